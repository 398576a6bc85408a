"""Steps of a program as lines of URScript."""

from vrts.dispatch.saying.arguments import Arguments
from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import plain, printed
from vrts.dispatch.saying.signals import FIRST_INTERNAL, signal_of
from vrts.dispatch.saying.table import Table
from vrts.dispatch.urscript.values import HERE, NOTHING, Values, name_of, number
from vrts.ir import instructions as ir
from vrts.ir.expressions import Constant, Format, Load, Place, Slot, WholeArray
from vrts.ir.instructions import HandAction, Interpolation, Scope, SpeedUnit
from vrts.ir.module import Program
from vrts.ir.values import Type

SILENT = (ir.SetAccuracy, ir.SetNulling, ir.SetIntegration, ir.SetTurns)
HANDS = {HandAction.OPEN: "True, False", HandAction.CLOSE: "False, True"}
HANDS[HandAction.RELAX] = "False, False"
MOVES = (ir.Move, ir.Depart, ir.Draw, ir.Ready)
UNITS = {SpeedUnit.PERCENT: "/ 100.0", SpeedUnit.MM_PER_S: "/ v_full_mm"}
UNITS[SpeedUnit.INCH_PER_S] = "* 25.4 / v_full_mm"


class Steps:
    """Writes the steps of one program."""

    def __init__(self, table: Table, ready: str, program: Program, arguments: Arguments) -> None:
        """Know signals, joints of READY, and which arguments come back."""
        self.table, self.ready = table, ready
        self.arguments = arguments
        self.values = Values(table)
        back = (f"global {to} = {name_of(formal)}" for to, formal in arguments.back(program))
        self.leaving = [*back, "return True"]

    def lines(self, step: ir.Instruction, following: object, radius: float) -> list[str]:
        """Return what an instruction becomes.

        Args:
            step: The instruction.
            following: The next one.
            radius: Of the rounded corner behind a motion [m].

        Raises:
            CannotSay: URScript has nothing of the kind.
        """
        v = self.values
        r = number(radius)
        match step:
            case ir.Move(opening=None):
                return [self._move(step, r)]
            case ir.Depart(interpolation, distance):
                back = f"pose_trans({HERE}, v_shift(0.0, 0.0, (-{v.real(distance)})))"
                return [f"{_word(interpolation)}({back}, {r})"]
            case ir.Draw(offsets, False, None) if not any(offsets[3:]):
                by = ", ".join("0.0" if o is None else v.real(o) for o in offsets[:3])
                return [f"v_movel(pose_trans(v_shift({by}), {HERE}), {r})"]
            case ir.Ready():
                return [f"v_movejoints({self.ready}, {r})"]
            case ir.Break():
                return ["sync()"]
            case ir.Delay(time):
                return [f"sleep({v.real(time)})", "global v_next = 0.0"]  # it was a motion too
            case ir.MoveHand(action, immediate, None):
                if not immediate and not isinstance(following, MOVES):
                    raise CannotSay("the hand moves with a motion that does not follow at once")
                rows = [f"v_hand({HANDS[action]})"]
                return [*rows, "sleep(v_hand_s)"] if immediate else rows
            case ir.SetSpeed(rotation=None):
                share = f"{v.real(step.value)} {UNITS[step.unit]}"
                scope = "always" if step.scope is Scope.ALWAYS else "next"
                return [f"global v_{scope} = {share}"]
            case ir.SetTool(pose):
                tool = NOTHING if pose is None else v.location(pose)
                return [f"set_tcp({tool})", f"global {HERE} = v_here()"]
            case _ if isinstance(step, SILENT):
                return ["sync()"]
            case _:
                return self._other(step)

    def _other(self, step: ir.Instruction) -> list[str]:
        v = self.values
        match step:
            case ir.Assign(place, value):
                return [self._assign(place, value)]
            case ir.AssignHere(place, None) if place.variable.type is Type.POSE:
                return [self.given(place, HERE)]
            case ir.Signal(signals):
                return [self._signal(*signal_of(signal)) for signal in signals]
            case ir.Reset():
                return [
                    f"set_standard_digital_out({p}, False)" for p in self.table.outputs.values()
                ]
            case ir.Wait(condition) if condition is not None:
                return [f"while (not {v.condition(condition)}):", "  sync()", "end"]
            case ir.Call(program, arguments):
                back = self.arguments.taken(step)
                called = f"prog_{plain(program)}({', '.join(map(self._argument, arguments))})"
                return [called, *(self.given(place, held) for place, held in back)]
            case ir.Type(items):
                return [row for item in items for row in self._told(item)] or ["sync()"]
            case ir.Halt(message) | ir.Stop(message):
                return [*([] if message is None else self._told(message)), "halt"]
            case ir.Return(None):
                return self.leaving
            case _:
                raise CannotSay(f"URScript has nothing that means {_name(step)}")

    def _move(self, move: ir.Move, r: str) -> str:
        v = self.values
        joints = v.is_joints(move.target)
        target = v.location(move.target)
        if joints and move.interpolation is Interpolation.JOINT and move.retreat is None:
            return f"v_movejoints({target}, {r})"
        if joints:
            target = f"v_tool({target})"
        if move.retreat is not None:
            target = f"pose_trans({target}, v_shift(0.0, 0.0, (-{v.real(move.retreat)})))"
        return f"{_word(move.interpolation)}({target}, {r})"

    def _assign(self, place: Place, value: object) -> str:
        v = self.values
        kind = place.variable.type
        expression: Load = value  # type: ignore[assignment]
        if kind is Type.REAL:
            return self.given(place, v.real(expression))
        if (kind is Type.JOINTS) != v.is_joints(expression):
            raise CannotSay("a pose becomes joints here, or joints a pose")
        return self.given(place, v.location(expression))

    def given(self, place: Place, text: str) -> str:
        """Return the line that gives a variable a value; an element's list is there already."""
        own = isinstance(place.variable, Slot) or place.subscripts
        return f"{'' if own else 'global '}{self.values.place(place)} = {text}"

    def _signal(self, signal: int, on: bool) -> str:
        if signal >= FIRST_INTERNAL:
            return f"global signal_{signal} = {on}"
        return f"set_standard_digital_out({self.table.output(signal)}, {on})"

    def _argument(self, argument: object) -> str:
        if isinstance(argument, Place):
            return self.values.place(argument)
        if argument is None or isinstance(argument, WholeArray):
            raise CannotSay("an argument is left out, or is an array", "pass a value")
        expression: Load = argument  # type: ignore[assignment]
        try:
            return self.values.real(expression)
        except CannotSay:
            return self.values.location(expression)

    def _told(self, item: object) -> list[str]:
        match item:
            case Format():
                return []
            case Constant(str(text)):
                words = printed(text).replace('"', "'").replace("\n", " ")
                return [f'textmsg("{words}")']
            case _:
                expression: Load = item  # type: ignore[assignment]
                return [f"textmsg({self.values.real(expression)})"]


def _word(interpolation: Interpolation) -> str:
    return "v_movel" if interpolation is Interpolation.LINEAR else "v_movej"


def _name(step: ir.Instruction) -> str:
    words: dict[type, str] = {
        ir.React: "REACT",
        ir.ReactError: "REACTE",
        ir.StartProcess: "PCEXECUTE",
        ir.SetBase: "BASE",
        ir.Jump: "GOTO",
        ir.JumpIf: "GOTO",
        ir.RequestBranch: "arm branches",
        ir.Move: "MOVET",
        ir.MoveHand: "an opening of the hand",
        ir.WaitTime: "a timed wait",
    }
    return words.get(type(step), type(step).__name__.upper())


def asks(step: ir.Instruction) -> bool:
    """Return whether an instruction sets an output, which somebody outside sees."""
    if isinstance(step, ir.Signal):
        return any(signal_of(signal)[0] < FIRST_INTERNAL for signal in step.signals)
    return isinstance(step, ir.Reset)
