"""Steps of the program that do something, as lines of G-code."""

from typing import TypeAlias

from vrts.dispatch.linuxcnc.locations import Locations, called
from vrts.dispatch.linuxcnc.memory import WIDTH, Memory
from vrts.dispatch.linuxcnc.names import number
from vrts.dispatch.linuxcnc.values import CLOCK
from vrts.dispatch.saying.arguments import Arguments
from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import plain, printed
from vrts.dispatch.saying.parts import constant
from vrts.dispatch.saying.signals import (
    FIRST_INPUT,
    FIRST_INTERNAL,
    bits_of,
    read_outputs,
    signal_of,
)
from vrts.dispatch.saying.table import Table
from vrts.dispatch.saying.timers import timer_of
from vrts.ir import instructions as ir
from vrts.ir.expressions import (
    Apply,
    Constant,
    Expression,
    Format,
    FormatKind,
    Function,
    Place,
    Slot,
)
from vrts.ir.instructions import BranchRequest, HandAction, Interpolation, Scope, SpeedUnit
from vrts.ir.values import Type

MM_PER_INCH = 25.4
HANDS = {HandAction.OPEN: 1, HandAction.CLOSE: 2, HandAction.RELAX: 3}
ASKED = {
    BranchRequest.LEFTY: ("side", 1),
    BranchRequest.RIGHTY: ("side", -1),
    BranchRequest.ABOVE: ("elbow", 1),
    BranchRequest.BELOW: ("elbow", -1),
    BranchRequest.NOFLIP: ("wrist", 1),
    BranchRequest.FLIP: ("wrist", -1),
}
HARMLESS = (ir.SetAccuracy, ir.SetNulling, ir.SetIntegration)  # they change pauses alone
STOP = "o<v_stop> call"

REMEDIES: dict[type, str] = {
    ir.SetBase: "write `SHIFT(place BY ...)`, or places in a frame: `frame:place`",
    ir.Grasp: "write CLOSEI, then look at an input of the hand with IF SIG(...)",
}

Lines: TypeAlias = list[str]


class Steps:
    """Writes the steps of one program."""

    def __init__(self, memory: Memory, table: Table, arguments: Arguments) -> None:
        """Share what is known of variables, signals and arguments."""
        self.arguments = arguments
        self.lines: Lines = []
        self.read = read_outputs(arguments.module)
        self.table, self.memory = table, memory
        self.locations = Locations(memory, table, self.lines)
        self.values = self.locations.values

    def take(self) -> Lines:
        """Return the lines written since the last time."""
        taken = self.lines.copy()
        self.lines.clear()
        return taken

    def write(self, instruction: ir.Instruction) -> None:
        """Write what an instruction does.

        Raises:
            CannotSay: LinuxCNC does nothing of the kind.
        """
        match instruction:
            case ir.Move():
                self._move(instruction)
            case ir.Depart(interpolation, distance):
                name = "departs" if interpolation is Interpolation.LINEAR else "depart"
                self._call(name, self.values.real(distance))
            case ir.Draw(offsets, in_tool, speed):
                if in_tool or speed is not None or any(offsets[3:]):
                    raise CannotSay("LinuxCNC's DRAW is along the axes of the world only")
                self._call(
                    "draw", *("0" if o is None else self.values.real(o) for o in offsets[:3])
                )
            case ir.Drive(joint, change, speed):
                percent = "100" if speed is None else self.values.real(speed)
                self._call("drive", self.values.real(joint), self.values.real(change), percent)
            case ir.Ready():
                self._call("joints", "154")
            case ir.Break():
                self.lines.append(STOP)
            case ir.Delay(time):
                self._call("delay", self.values.real(time))
            case ir.MoveHand(action, immediate, opening):
                if opening is not None:
                    raise CannotSay(
                        "LinuxCNC's hand opens and closes, it takes no distance",
                        "write OPEN or CLOSE without a distance",
                    )
                kind = HANDS[action]
                self.lines.append(
                    called("v_hand", str(kind)) if immediate else f"#<_v_hand> = {kind}"
                )
            case ir.SetSpeed():
                self._speed(instruction)
            case ir.RequestBranch(branch):
                part, sign = ASKED[branch]
                self.lines += [STOP, f"#<_v_ask_{part}> = {number(sign)}"]
            case ir.SetTool(pose):
                self._call("tool", self.locations.address(pose or Apply(Function.NULL)))
            case ir.SetTurns(multiple=True) | ir.SetAccuracy() | ir.SetNulling():
                pass
            case ir.SetIntegration():
                pass
            case _:
                self._other(instruction)

    def _other(self, instruction: ir.Instruction) -> None:
        match instruction:
            case ir.Assign(place, value):
                self._assign(place, value)
            case ir.AssignHere(place, None):
                self.lines.append(STOP)
                self._copy(place, "110" if place.variable.type is Type.POSE else "100")
            case ir.Signal(signals):
                for signal in signals:
                    self._signal(*signal_of(signal))
            case ir.Reset():
                for signal in self.table.outputs:
                    self._output(signal, "0")
            case ir.SetBits(first, length, value):
                self._bits(bits_of(first, length), value)
            case ir.SetTimer(timer, value):
                begun = self.values.real(value)
                self.lines += [CLOCK, f"#<_timer_{timer_of(timer)}> = [#<_v_now> - {begun}]"]
            case ir.WaitTime(time):
                self.lines.append(f"G4 P{self.values.real(time)}")
            case ir.React():
                raise CannotSay(
                    "LinuxCNC has nothing that means REACT: G-code is not interrupted",
                    "look with IF SIG(...) behind BREAK; what must stop the arm belongs into HAL",
                )
            case ir.Ignore() | ir.Lock():
                pass  # nothing is watched
            case ir.Wait(condition):
                self._wait(condition)
            case ir.Call(program, arguments):
                back = self.arguments.taken(instruction)
                self.lines.append(called(plain(program), *map(self._argument, arguments)))
                self.lines += (f"{self.values.place(to)} = #<_{name}>" for to, name in back)
            case ir.Type(items):
                self._type(items)
            case ir.Halt(message) | ir.Stop(message):
                if message is not None:
                    self._type((message,))
                self.lines += [STOP, "G94", "M2"]
            case ir.SetParameter("HAND.TIME", _, value):
                self.lines.append(f"#<_v_hand_time> = [{self.values.real(value)}]")
            case _:
                remedy = REMEDIES.get(type(instruction), "write the step without it")
                raise CannotSay(f"LinuxCNC has nothing that means {_word(instruction)}", remedy)

    def _move(self, move: ir.Move) -> None:
        if move.opening is not None:
            raise CannotSay(
                "LinuxCNC has nothing that means MOVET", "write OPEN or CLOSE, then MOVE"
            )
        linear = move.interpolation is Interpolation.LINEAR
        kind = self.locations.type_of(move.target)
        at = self.locations.address(move.target)
        if kind is Type.JOINTS and (linear or move.retreat is not None):
            to = str(self.memory.more(WIDTH[Type.POSE]))
            self._call("here", to, at)
            at = to
        if move.retreat is not None:
            self._call("appros" if linear else "appro", at, self.values.real(move.retreat))
        elif linear:
            self._call("moves", at)
        else:
            self._call("joints" if kind is Type.JOINTS else "move", at)

    def _speed(self, speed: ir.SetSpeed) -> None:
        if speed.rotation is not None:
            raise CannotSay("LinuxCNC has no speed of rotation of its own")
        value = self.values.real(speed.value)
        match speed.unit:
            case SpeedUnit.PERCENT:
                share = f"{value}/100"
            case SpeedUnit.MM_PER_S:
                share = f"{value}/#<_v_linear>"
            case SpeedUnit.INCH_PER_S:
                share = f"{value}*{MM_PER_INCH:g}/#<_v_linear>"
        name = "always" if speed.scope is Scope.ALWAYS else "next"
        self.lines.append(f"#<_v_speed_{name}> = [{share}]")

    def _assign(self, place: Place, value: Expression) -> None:
        kind = place.variable.type
        if kind in (Type.POSE, Type.JOINTS):
            if self.locations.type_of(value) is not kind:
                raise CannotSay("a pose becomes joints here, or joints a pose")
            self._copy(place, self.locations.address(value))
            return
        if kind is not Type.REAL:
            raise CannotSay("LinuxCNC has no strings", "do without")
        text = self.values.real(value)
        self.lines.append(f"{self.values.place(place)} = {text}")

    def _copy(self, place: Place, at: str) -> None:
        to = (
            f"#<{plain(place.variable.name)}>"
            if isinstance(place.variable, Slot)
            else self.values.element(place)
        )
        self._call("copy", to, at, str(WIDTH[place.variable.type]))

    def _signal(self, signal: int, on: bool) -> None:
        state = "1" if on else "0"
        if signal >= FIRST_INTERNAL:
            self.lines.append(f"#<_signal_{signal}> = {state}")
        else:
            self._output(signal, state)

    def _output(self, signal: int, state: str) -> None:
        self._call("output", str(self.table.output(signal)), state)
        if signal in self.read:
            self.lines.append(f"#<_out_{signal}> = {state}")

    def _bits(self, signals: range, value: Expression) -> None:
        if signals and signals[-1] >= FIRST_INPUT:
            raise CannotSay("BITS sets signals that are no outputs", "write SIGNAL for them")
        known = constant(value)
        text = "" if known is not None else self.values.kept(f"[{self.values.real(value)}]")
        for k, signal in enumerate(signals):
            if known is not None:
                self._output(signal, str(round(known) >> k & 1))
                continue
            half = self.values.kept(f"FIX[ROUND[{text}] / {2**k}]")
            self._output(signal, self.values.kept(f"[{half} - 2*FIX[{half} / 2]]"))

    def _wait(self, condition: Expression | None) -> None:
        if condition is None:
            return
        self.lines.append(STOP)
        label = self.label()
        self.lines.append(f"o{label} do")
        text = self.values.condition(condition)
        self.lines.append(f"o{label} while [{text} EQ 0]")

    def label(self) -> int:
        """Return a number for an O-word that no other has."""
        return self.memory.label()

    def _argument(self, argument: object) -> str:
        match argument:
            case Place(variable) as place:
                if variable.type in (Type.POSE, Type.JOINTS):
                    if isinstance(variable, Slot):
                        return f"#<{plain(variable.name)}>"
                    return self.values.element(place)
                if variable.type is Type.REAL:
                    return self.values.place(place)
                raise CannotSay("LinuxCNC passes numbers and locations only")
            case None:
                raise CannotSay("an argument is left out", "write it")
            case _:
                return self._value(argument)

    def _value(self, argument: object) -> str:
        expression: Expression = argument  # type: ignore[assignment]
        try:
            return self.values.real(expression)
        except CannotSay:
            return self.locations.address(expression)

    def _type(self, items: tuple[Expression | Format, ...]) -> None:
        words: list[str] = []
        for item in items:
            match item:
                case Format(kind):
                    words.append(" " if kind is FormatKind.BLANK else "")
                case Constant(str(text)):
                    words.append(printed(text))
                case _:
                    words.append(self.values.kept(f"[{self.values.real(item)}]"))
        self.lines.append(f"(PRINT, {' '.join(word for word in words if word)})")

    def _call(self, name: str, *arguments: str) -> None:
        self.lines.append(called(f"v_{name}", *arguments))


def _word(instruction: ir.Instruction) -> str:
    words: dict[type, str] = {
        ir.ReactError: "REACTE",
        ir.StartProcess: "PCEXECUTE",
        ir.EndProcess: "PCEND",
        ir.AbortProcess: "PCABORT",
        ir.Prompt: "PROMPT",
        ir.SetBase: "BASE",
        ir.SetMonitorSpeed: "a change of the monitor speed",
        ir.SetTurns: "SINGLE",
        ir.Jump: "GOTO",
    }
    return words.get(type(instruction), type(instruction).__name__.upper())
