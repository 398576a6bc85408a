"""Locations of the program: worked out by the library, told by their address."""

from collections.abc import Iterable

from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.base.units import deg
from vrts.dispatch.linuxcnc.memory import WIDTH, Memory
from vrts.dispatch.linuxcnc.names import number
from vrts.dispatch.linuxcnc.values import Values
from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import plain
from vrts.dispatch.saying.table import Table
from vrts.ir.expressions import Apply, Argument, Compose, Constant, Expression, Function, Load, Slot
from vrts.ir.values import Type, Value

DESTINATION, TOOL, JOINTS = "110", "130", "100"  # addresses of the library
POSES = frozenset(
    {
        *(Function.TRANS, Function.NULL, Function.INVERSE, Function.SHIFT),
        *(Function.HERE, Function.DEST, Function.TOOL),
    }
)
SIX = 6


class Locations:
    """Writes the locations of one program, and through `values` its numbers."""

    def __init__(self, memory: Memory, table: Table, before: list[str]) -> None:
        """Share what is known of variables; lines that come first go to `before`."""
        self.memory, self.before = memory, before
        self.values = Values(memory, table, before, self.address)

    def type_of(self, e: Expression) -> Type:
        """Return whether a location is a pose or six joints."""
        match e:
            case Load(place):
                return place.variable.type
            case Apply(function):
                return Type.POSE if function in POSES else Type.JOINTS
            case Compose():
                return Type.POSE
            case Constant(value):
                return Type.POSE if isinstance(value, Pose) else Type.JOINTS
            case _:
                return Type.DYNAMIC

    def address(self, e: Expression) -> str:
        """Return where a location is."""
        match e:
            case Load(place):
                if isinstance(place.variable, Slot):
                    if place.subscripts or place.variable.type is Type.DYNAMIC:
                        raise CannotSay("LinuxCNC passes no arrays", "pass one element")
                    return f"#<{plain(place.variable.name)}>"
                return self.values.element(place)
            case Constant(value):
                return self._worked_out(
                    Type.POSE if isinstance(value, Pose) else Type.JOINTS, value
                )
            case Compose((first, *others)):
                at = self.address(first)
                to = str(self.memory.more(WIDTH[Type.POSE]))
                for other in others:
                    self._call("compose", to, at, self.address(other))
                    at = to
                return at
            case Apply(function, arguments):
                return self._apply(function, arguments)
            case _:
                raise CannotSay("LinuxCNC has nothing that means this location")

    def _worked_out(self, kind: Type, value: Value) -> str:
        to = self.memory.more(WIDTH[kind])
        self.before.append(constant(str(to), value))
        return str(to)

    def _apply(self, function: Function, arguments: tuple[Argument, ...]) -> str:
        if function in (Function.HERE, Function.DEST):
            return DESTINATION  # HERE is read at rest: what waits is carried out first
        if function in (Function.HERE_JOINTS, Function.DEST_JOINTS):
            return JOINTS
        if function is Function.TOOL:
            return TOOL
        if function is Function.INVERSE:
            at = self.address(_given(arguments[0]))
            to = str(self.memory.more(WIDTH[Type.POSE]))
            self._call("inverse", to, at)
            return to
        if function is Function.SHIFT:
            at = self.address(_given(arguments[0]))
            by = self._numbers(arguments[1:], SIX // 2)
            to = str(self.memory.more(WIDTH[Type.POSE]))
            self._call("shift", to, at, *by)
            return to
        if function in (Function.TRANS, Function.NULL):
            to = str(self.memory.more(WIDTH[Type.POSE]))
            if function is Function.NULL or not arguments:
                self._call("trans", to, "0", "0", "0", "90", "-90", "0")
            else:
                self._call("trans", to, *self._numbers(arguments, SIX))
            return to
        if function is Function.PPOINT:
            to = str(self.memory.more(WIDTH[Type.JOINTS]))
            self._call("point", to, *self._numbers(arguments, SIX))
            return to
        raise CannotSay(f"LinuxCNC has nothing that means {function.value.upper()}")

    def _numbers(self, arguments: tuple[Argument, ...], count: int) -> list[str]:
        given = [*arguments, *(None for _ in range(count))][:count]
        return ["0" if a is None else self.values.real(_given(a)) for a in given]

    def _call(self, name: str, *arguments: str) -> None:
        self.before.append(called(f"v_{name}", *arguments))


def called(name: str, *arguments: str) -> str:
    """Return the call of a subroutine."""
    return " ".join((f"o<{name}> call", *(f"[{argument}]" for argument in arguments)))


def constant(to: str, value: Value) -> str:
    """Return what puts a location that is known into its place."""
    if isinstance(value, Pose):
        return called("v_trans", to, *_numbers(components(value)))
    assert isinstance(value, tuple)
    return called("v_point", to, *_numbers(map(deg, value)))


def _numbers(values: Iterable[float]) -> list[str]:
    return [number(round(value, 7) + 0.0).strip("[]") for value in values]


def _given(argument: Argument) -> Expression:
    if isinstance(argument, tuple) and hasattr(argument, "_fields"):
        return argument  # type: ignore[return-value]
    raise CannotSay("an argument is left out", "write it")
