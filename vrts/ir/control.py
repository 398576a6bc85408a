"""Instructions that decide what is executed next: jumps, loops, calls, waiting, reactions."""

from typing import NamedTuple

from vrts.base.source import Span
from vrts.ir.expressions import Expression, Place, WholeArray


class Jump(NamedTuple):
    """Go on at an instruction index."""

    target: int


class JumpIf(NamedTuple):
    """Go on at an index when the condition, taken as true or false, equals `when`."""

    condition: Expression
    when: bool
    target: int


class BeginFor(NamedTuple):
    """Assign the first value, then evaluate and keep limit and increment of the loop."""

    place: Place
    first: Expression
    last: Expression
    increment: Expression | None
    loop: int  # index of the loop in its program


class TestFor(NamedTuple):
    """Leave the loop when the variable is past its limit.

    A loop never begun is VAL's *Control structure error*.
    """

    place: Place
    loop: int
    leave: int


class NextFor(NamedTuple):
    """Add the increment to the variable, then go on at the test."""

    place: Place
    loop: int
    test: int


class BeginCase(NamedTuple):
    """Evaluate the selector of a CASE once and keep it in the frame."""

    selector: Expression
    case: int  # index of the CASE in its program


class TestCase(NamedTuple):
    """Go on at an index when none of the values equals the selector kept."""

    case: int
    values: tuple[Expression, ...]
    otherwise: int


class Call(NamedTuple):
    """CALL: a Place or WholeArray is passed by reference, an expression by value, None is omitted.

    A Place whose type is DYNAMIC passes whatever it holds.
    """

    program: str
    arguments: tuple[Expression | Place | WholeArray | None, ...]
    program_span: Span | None = None


class CallNamed(NamedTuple):
    """CALLS (V+): as CALL, with the name of the program in a string."""

    program: Expression
    arguments: tuple[Expression | Place | WholeArray | None, ...]


class Return(NamedTuple):
    """RETURN, and the end of every program; VAL's `RETURN n` skips n steps of the caller."""

    skip: Expression | None = None


class ReturnError(NamedTuple):
    """RETURNE: from an error reaction to the step after the one that failed."""


class Stop(NamedTuple):
    """STOP: end this execution cycle, from any depth of calls."""

    message: Expression | None = None


class Halt(NamedTuple):
    """HALT: end the execution. Breaks continuous path."""

    message: Expression | None = None


class Pause(NamedTuple):
    """PAUSE: stop, resumable at the next step. Breaks continuous path."""

    message: Expression | None = None


class Wait(NamedTuple):
    """WAIT: until the condition is true at a tick; None gives up the rest of this tick."""

    condition: Expression | None


class WaitTime(NamedTuple):
    """TWAIT, WAIT.EVENT with a time: the program waits [s], the arm goes on."""

    time: Expression


class React(NamedTuple):
    """REACT, REACTI: watch a signal; negative watches for off.

    REACTI stops the motion when the reaction is taken. ON of AS waits for the end of the motion.
    """

    signal: Expression
    program: str | None
    priority: Expression | None
    immediate: bool
    always: bool = False  # stays armed [assumed, manual language/reactions#always]
    after_motion: bool = False


class ReactError(NamedTuple):
    """REACTE: the program that run-time errors call from now on; None is none."""

    program: str | None


class Ignore(NamedTuple):
    """IGNORE: give up the watch on a signal."""

    signal: Expression


class Lock(NamedTuple):
    """LOCK: reactions up to a priority wait; None is 0."""

    priority: Expression | None


class StartProcess(NamedTuple):
    """PCEXECUTE: run a second program beside this one; None is the one run last."""

    program: str | None
    cycles: Expression | None = None
    step: Expression | None = None


class AbortProcess(NamedTuple):
    """PCABORT: stop the second program after its step; it can be resumed."""


class EndProcess(NamedTuple):
    """PCEND: stop the second program at the end of its cycle; -1 takes that back."""

    mode: Expression | None = None
