"""Steps of a program as lines of URScript."""

from typing import NamedTuple

from vrts.dispatch.saying.arguments import Arguments
from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import plain
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
from vrts.dispatch.urscript.processes import Processes, abort, end
from vrts.dispatch.urscript.values import HERE, JOINTS_HERE, NOTHING, Values, name_of, number
from vrts.dispatch.urscript.watching import Watching
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression, Format, Load, Place, Slot, WholeArray
from vrts.ir.instructions import HandAction, Interpolation, Scope, SpeedUnit
from vrts.ir.module import Program
from vrts.ir.values import Type

SILENT = (ir.SetAccuracy, ir.SetNulling, ir.SetIntegration, ir.SetTurns)
HANDS = {HandAction.OPEN: "True, False", HandAction.CLOSE: "False, True"}
HANDS[HandAction.RELAX] = "False, False"
REMEDIES: dict[type, str] = {
    ir.Move: "write OPEN or CLOSE, then MOVE",
    ir.MoveHand: "write OPEN or CLOSE without a distance",
    ir.Grasp: "write CLOSEI, then look at an input of the hand with IF SIG(...)",
    ir.RequestBranch: "leave it out: UR takes the joints nearest to where the arm stands",
}
MOVES = (ir.Move, ir.Depart, ir.Draw, ir.Drive, ir.Ready)
UNITS = {SpeedUnit.PERCENT: "/ 100.0", SpeedUnit.MM_PER_S: "/ v_full_mm"}
UNITS[SpeedUnit.INCH_PER_S] = "* 25.4 / v_full_mm"


class Mode(NamedTuple):
    """How a program is written: as one that is called, or as a reaction."""

    watching: Watching | None = None
    reaction: bool = False
    processes: Processes | None = None
    beside: bool = False  # it is carried out beside the first program

    @property
    def own(self) -> str:
        """What the names of functions that move the arm begin with."""
        return "r" if self.reaction else "v"

    @property
    def called(self) -> str:
        """What the names of programs begin with."""
        if self.beside:
            return "beside"
        return "react" if self.reaction else "prog"

    @property
    def here(self) -> str:
        """What tells where the arm rests: a reaction may have stopped it on its way."""
        return HERE if self.watching is None else "v_here()"

    @property
    def passes(self) -> str:
        """What lets a frame pass."""
        return "sync()" if self.watching is None else f"{self.own}_pass()"

    @property
    def rests(self) -> list[str]:
        """What waits until the arm rests: without reactions it does behind every motion."""
        return [] if self.watching is None else [f"{self.own}_wait()"]

    def stays(self, seconds: str, *, motion: bool) -> str:
        """Return what waits for some seconds, as a motion or not."""
        if self.watching is None:
            return f"sleep({seconds})"
        return f"{self.own}_{'sleep' if motion else 'hold'}({seconds})"


class Steps:
    """Writes the steps of one program."""

    def __init__(
        self, table: Table, ready: str, program: Program, arguments: Arguments, mode: Mode
    ) -> None:
        """Know signals, joints of READY, and which arguments come back."""
        self.table, self.ready, self.mode = table, ready, mode
        self.read = read_outputs(arguments.module)
        self.arguments = arguments
        self.values = Values(table, mode.here)
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
                rests, word = self.mode.rests, self._word(interpolation)
                back = f"pose_trans({HERE}, v_shift(0.0, 0.0, (-{v.real(distance)})))"
                return [*rests, f"{word}({back}, {r})"]
            case ir.Draw(offsets, False, None) if not any(offsets[3:]):
                by = ", ".join("0.0" if o is None else v.real(o) for o in offsets[:3])
                line = self._word(Interpolation.LINEAR)
                return [*self.mode.rests, f"{line}(pose_trans(v_shift({by}), {HERE}), {r})"]
            case ir.Drive(joint, change, speed):
                known = constant(joint)
                at = f"v_index({v.real(joint)} - 1.0)" if known is None else str(round(known) - 1)
                share = "1.0" if speed is None else f"{v.real(speed)} / 100.0"
                return [f"{self.mode.own}_drive({at}, {v.real(change)}, {share}, {r})"]
            case ir.Ready():
                return [f"{self.mode.own}_movejoints({self.ready}, {r})"]
            case ir.Break():
                return self.mode.rests or ["sync()"]
            case ir.Delay(time):
                waits = self.mode.stays(v.real(time), motion=True)
                return [waits, "global v_next = 0.0"]  # it was a motion too
            case ir.WaitTime(time):
                return [self.mode.stays(v.real(time), motion=False)]
            case ir.MoveHand(action, immediate, None):
                if not immediate and not isinstance(following, MOVES):
                    raise CannotSay("the hand moves with a motion that does not follow at once")
                rows = [f"v_hand({HANDS[action]})"]
                waits = self.mode.stays("v_hand_s", motion=False)
                return [*rows, waits] if immediate else rows
            case ir.SetSpeed(rotation=None):
                share = f"{v.real(step.value)} {UNITS[step.unit]}"
                scope = "always" if step.scope is Scope.ALWAYS else "next"
                return [f"global v_{scope} = {share}"]
            case ir.SetBase():
                given = (step.dx, step.dy, step.dz, step.rotation)
                each = ", ".join("0.0" if e is None else v.real(e) for e in given)
                return [*self.mode.rests, f"v_base({each})"]
            case ir.SetTool(pose):
                tool = NOTHING if pose is None else v.location(pose)
                return [*self.mode.rests, f"set_tcp({tool})", f"global {HERE} = v_here()"]
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
                return [self.given(place, self.mode.here)]
            case ir.AssignHere(place, None):
                return [self.given(place, JOINTS_HERE)]
            case ir.Signal(signals):
                return [row for s in signals for row in self._signal(*signal_of(s))]
            case ir.Reset():
                return [
                    row for signal in self.table.outputs for row in self._output(signal, "False")
                ]
            case ir.SetBits(first, length, value):
                return self._bits(bits_of(first, length), value)
            case ir.Wait(condition) if condition is not None:
                return [f"while (not {v.condition(condition)}):", f"  {self.mode.passes}", "end"]
            case ir.Call(program, arguments):
                back = self.arguments.taken(step)
                name = f"{self.mode.called}_{plain(program)}"
                called = f"{name}({', '.join(map(self._argument, arguments))})"
                return [called, *(self.given(place, held) for place, held in back)]
            case ir.Type(items):
                return [row for item in items for row in self._told(item)] or ["sync()"]
            case ir.Halt(message) | ir.Stop(message):
                told = [] if message is None else self._told(message)
                return [*told, *self.mode.rests, "halt"]
            case ir.SetTimer(timer, value):
                return [f"global timer_{timer_of(timer)} = v_clock() - {v.real(value)}"]
            case ir.StartProcess() if self.mode.processes is not None:
                return self.mode.processes.start(step, v)
            case ir.EndProcess() if self.mode.processes is not None:
                return end(step)
            case ir.AbortProcess() if self.mode.processes is not None:
                return abort()
            case ir.React() if self.mode.watching is not None:
                return self.mode.watching.watch(step, self.table)
            case ir.Ignore(signal) if self.mode.watching is not None:
                return self.mode.watching.ignore(signal_of(signal)[0])
            case ir.Ignore():
                return ["sync()"]
            case ir.Lock(priority):
                return self._lock(priority)
            case ir.Return(None):
                return self.leaving
            case _:
                remedy = REMEDIES.get(type(step), "write the step without it")
                raise CannotSay(f"URScript has nothing that means {_name(step)}", remedy)

    def _lock(self, priority: Expression | None) -> list[str]:
        if self.mode.reaction:
            raise CannotSay("a reaction says LOCK", "leave it out: others wait for its end")
        if self.mode.watching is None:
            return ["sync()"]
        level = "0.0" if priority is None else self.values.real(priority)
        return [f"global v_priority = {level}", "v_look()"]

    def _word(self, interpolation: Interpolation) -> str:
        kind = "movel" if interpolation is Interpolation.LINEAR else "movej"
        return f"{self.mode.own}_{kind}"

    def _move(self, move: ir.Move, r: str) -> str:
        v = self.values
        joints = v.is_joints(move.target)
        target = v.location(move.target)
        if joints and move.interpolation is Interpolation.JOINT and move.retreat is None:
            return f"{self.mode.own}_movejoints({target}, {r})"
        if joints:
            target = f"v_tool({target})"
        if move.retreat is not None:
            target = f"pose_trans({target}, v_shift(0.0, 0.0, (-{v.real(move.retreat)})))"
        return f"{self._word(move.interpolation)}({target}, {r})"

    def _assign(self, place: Place, value: object) -> str:
        v = self.values
        kind = place.variable.type
        expression: Load = value  # type: ignore[assignment]
        if kind is Type.REAL:
            return self.given(place, v.real(expression))
        if kind is Type.STRING:
            return self.given(place, v.string(expression))
        if (kind is Type.JOINTS) != v.is_joints(expression):
            raise CannotSay("a pose becomes joints here, or joints a pose")
        return self.given(place, v.location(expression))

    def given(self, place: Place, text: str) -> str:
        """Return the line that gives a variable a value; an element's list is there already."""
        own = isinstance(place.variable, Slot) or place.subscripts
        return f"{'' if own else 'global '}{self.values.place(place)} = {text}"

    def _signal(self, signal: int, on: bool) -> list[str]:
        if signal >= FIRST_INTERNAL:
            return [f"global signal_{signal} = {on}"]
        return self._output(signal, str(on))

    def _output(self, signal: int, state: str) -> list[str]:
        rows = [f"set_standard_digital_out({self.table.output(signal)}, {state})"]
        return [*rows, f"global out_{signal} = {state}"] if signal in self.read else rows

    def _bits(self, signals: range, value: Expression) -> list[str]:
        if signals and signals[-1] >= FIRST_INPUT:
            raise CannotSay("BITS sets signals that are no outputs", "write SIGNAL for them")
        known = constant(value)
        text = "" if known is not None else f"v_index({self.values.real(value)}) + 0.0"
        rows: list[str] = []
        for k, signal in enumerate(signals):
            state = (
                f"v_bit({text}, {2.0**k})" if known is None else str(bool(round(known) >> k & 1))
            )
            rows += self._output(signal, state)
        return rows

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
            case _:
                expression: Load = item  # type: ignore[assignment]
                words = self.values.is_string(expression)
                v = self.values
                return [f"textmsg({(v.string if words else v.real)(expression)})"]


def _name(step: ir.Instruction) -> str:
    words: dict[type, str] = {
        ir.ReactError: "REACTE",
        ir.StartProcess: "PCEXECUTE",
        ir.EndProcess: "PCEND",
        ir.AbortProcess: "PCABORT",
        ir.Jump: "GOTO",
        ir.JumpIf: "GOTO",
        ir.RequestBranch: "arm branches",
        ir.Move: "MOVET",
        ir.MoveHand: "an opening of the hand",
    }
    return words.get(type(step), type(step).__name__.upper())


def asks(step: ir.Instruction) -> bool:
    """Return whether an instruction sets an output, or a clock, as a motion begins."""
    if isinstance(step, ir.SetTimer | ir.SetBits):
        return constant(step.value) is not None
    if isinstance(step, ir.Signal):
        return any(signal_of(signal)[0] < FIRST_INTERNAL for signal in step.signals)
    return isinstance(step, ir.Reset)
