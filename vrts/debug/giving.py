"""What may be given another value while a program is debugged, and how the controller is told.

Variables by the rules of the language, signals and the operator's speed by commands. What is only
worked out can be given nothing: the reason is told, and nothing changes.
"""

import re
from collections.abc import Callable, Mapping
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.debug.evaluating import CannotTell
from vrts.engine.memory.cells import Array, Bound
from vrts.engine.run import State
from vrts.ir.commands import Command, ForceSignals, MonitorSpeed, SetVariable
from vrts.ir.data import Assign
from vrts.ir.ranges import HIGHEST_SUBSCRIPT, INPUTS, INTERNAL, OUTPUTS
from vrts.ir.system import SWITCHES
from vrts.ir.values import Type, Value, type_of_value
from vrts.lang.dialect import Dialect
from vrts.lang.names import key
from vrts.lang.vocabulary.functions import applied_functions, bare_functions
from vrts.lang.vocabulary.lookup import reserved_words
from vrts.monitor.desk import ALONE
from vrts.monitor.programs import in_view

LONGEST = 250  # characters
_NAMED = re.compile(r"([$#]?[A-Za-z][\w.]*)(?:\[([^\[\]]+)\])?", re.ASCII)
_ASKED = re.compile(r"([$#]?[A-Za-z][\w.]*)\(([^()]*)\)", re.ASCII)
_SIGNALS = frozenset({"sig", "signal"})
_STATES = {"on": -1.0, "off": 0.0}  # as signals are shown

Reads = Callable[[str], Value]
"""Gives the value of an expression where it stands, or raises CannotTell."""


class Target(NamedTuple):
    """What is given a value."""

    name: str  # of a variable, as its key; empty for the two below
    subscripts: tuple[int, ...] = ()
    signal: int = 0  # negative: given the opposite
    speed: bool = False  # that of the operator

    @property
    def shown(self) -> str:
        """What stands for it in an expression."""
        if self.speed:
            return "SPEED(1)"
        if not self.name:
            return f"SIG({self.signal})"
        inside = ",".join(map(str, self.subscripts))
        return f"{self.name}[{inside}]" if inside else self.name


def target_of(text: str, reads: Reads) -> Target:
    """Return what a text stands for.

    Raises:
        CannotTell: Nothing that can be given a value; the reason says why.
    """
    plain = text.strip()
    if len(plain) > LONGEST:
        raise CannotTell(f"a name has at most {LONGEST} characters")
    named = _NAMED.fullmatch(plain.replace(" ", ""))
    if named is not None and plain.split("[")[0].strip().count(" ") == 0:
        inside = named[2]
        return Target(
            key(named[1]), tuple(_whole(reads(p)) for p in inside.split(",")) if inside else ()
        )
    asked = _ASKED.fullmatch(plain)
    if asked is not None and asked[1].lower() in _SIGNALS:
        return Target("", signal=_signal(reads(asked[2])))
    if asked is not None and asked[1].lower() == "speed":
        if reads(asked[2]) != 1.0:
            raise CannotTell("only SPEED(1), the operator's, can be given a value here")
        return Target("", speed=True)
    if asked is not None and asked[1].upper() == "SWITCH":
        raise CannotTell("a switch is set by the program: ENABLE or DISABLE")
    if asked is not None:
        raise CannotTell(f"`{asked[1]}` is a function: it cannot be given a value")
    raise CannotTell(f"`{plain[:60]}` is no variable and no signal: it cannot be given a value")


def given(text: str, target: Target, reads: Reads) -> Value:
    """Return the value that a text stands for; signals may be on and off as they are shown."""
    state = _STATES.get(text.strip().lower()) if target.signal else None
    return reads(text) if state is None else state


def command_for(
    target: Target, value: Value, state: State, bound: Bound | None, dialect: Dialect
) -> Command:
    """Return what the controller is told.

    Args:
        target: What is given the value.
        value: The value.
        state: What has a value now.
        bound: What the name of a global variable stands for now, if anything.
        dialect: Of the program.

    Raises:
        CannotTell: The language does not allow it.
    """
    if target.speed:
        if not isinstance(value, float) or not 0.0 < value <= 100.0:
            raise CannotTell("a speed is above 0 and at most 100 %")
        return MonitorSpeed(value)
    if target.signal:
        if not isinstance(value, float):
            raise CannotTell("a signal is on or off: 1, -1, TRUE, or 0, FALSE")
        on = (value != 0.0) is (target.signal > 0)
        return ForceSignals((abs(target.signal) * (1 if on else -1),))
    is_new = bound is None
    if bound is not None and isinstance(bound, Array) is not bool(target.subscripts):
        words = "an array: say which element" if isinstance(bound, Array) else "no array"
        raise CannotTell(f"`{target.name}` is {words}")
    _allowed(target, value, state.variables, dialect, is_new=is_new)
    return SetVariable(target.name, target.subscripts, value)


def _allowed(
    target: Target, value: Value, known: Mapping[str, Value], dialect: Dialect, *, is_new: bool
) -> None:
    """Refuse what the language would not let a program write."""
    name = target.name
    word = name.lstrip("$#").upper()
    if word in SWITCHES and is_new:
        raise CannotTell(f"`{word}` is a switch, and set by the program: ENABLE or DISABLE")
    taken = {*applied_functions(dialect), *bare_functions(dialect)}
    if is_new and (word in reserved_words(dialect) or word.lower() in taken):
        raise CannotTell(f"`{word}` is a word of the language and cannot be a variable")
    inside = f"[{','.join('0' for _ in target.subscripts)}]" if target.subscripts else ""
    step = f"{name}{inside} = 0"
    match type_of_value(value):
        case Type.STRING:
            step = f'{name}{inside} = ""'
        case Type.POSE:
            step = f"{_set(dialect)} {name}{inside} = NULL"
        case Type.JOINTS:
            step = f"{_set(dialect)} {name}{inside} = #PPOINT(0,0,0,0,0,0)"
        case _:
            pass
    source = SourceFile("expression", f".PROGRAM {ALONE}\n{step}\n.END\n")
    found = in_view(source, (step,), {}, known, dialect)
    error = next((d.headline for d in found.diagnostics if d.is_error), None)
    first = None if found.module is None else found.module.programs[ALONE].instructions[0]
    if error is not None:
        raise CannotTell(error)
    if not isinstance(first, Assign) or first.place.variable.name != name:
        raise CannotTell(f"`{target.shown}` cannot be given a value")


def _set(dialect: Dialect) -> str:
    return "POINT" if dialect.is_as else "SET"


def _whole(value: Value) -> int:
    if not isinstance(value, float) or not 0.0 <= value <= HIGHEST_SUBSCRIPT:
        raise CannotTell(f"an index is from 0 to {HIGHEST_SUBSCRIPT}")
    return round(value)


def _signal(value: Value) -> int:
    number = round(value) if isinstance(value, float) and abs(value) < 1e6 else 0
    if not any(abs(number) in there for there in (INPUTS, OUTPUTS, INTERNAL)):
        raise CannotTell(f"there is no signal {value if number == 0 else number}")
    return number
