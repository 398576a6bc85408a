"""Commands that drive a controller. Live, monitor and offline runs use the same ones.

A command that the controller cannot carry out in its present state is refused: the run gains a
`CommandRefused` event with VAL's words, and nothing changes.
"""

from typing import NamedTuple, TypeAlias

from vrts.ir.module import Module
from vrts.ir.values import Value


class Execute(NamedTuple):
    """Run a program as the robot program."""

    program: str
    cycles: int = 1  # negative is endless; 0 counts as 1
    step: int = 1  # of the first cycle; later ones begin at 1


class Abort(NamedTuple):
    """Stop the robot program after its step and slow the arm down to rest along its path."""


class Panic(NamedTuple):
    """Stop both programs and the arm; what was to be done next is forgotten."""


class Proceed(NamedTuple):
    """Go on with the next step after PAUSE, ABORT, a single step or an error."""


class Retry(NamedTuple):
    """As PROCEED, after the step that failed or the motion that was cut is done again."""


class RunSteps(NamedTuple):
    """NEXT, SSTEP, XSTEP: execute some steps of the stopped program, then stop again."""

    steps: int = 1
    over_calls: bool = False  # a CALL with all it leads to counts as one step


class EndCycle(NamedTuple):
    """CYCLE.END: stop the robot program at the end of its present cycle."""


class Kill(NamedTuple):
    """Clear the stopped robot program: it cannot be resumed."""


class Do(NamedTuple):
    """Execute a program of one instruction at once, while no robot program executes."""

    module: Module  # whose first program is the instruction; its data are not loaded


class StartProcess(NamedTuple):
    """PCEXECUTE: run a process control program; None is the one run last."""

    program: str | None = None
    cycles: int = 1
    step: int = 1


class AbortProcess(NamedTuple):
    """PCABORT: stop the process control program after its step."""


class EndProcess(NamedTuple):
    """PCEND: stop it at the end of its cycle; False takes that back."""

    on: bool = True


class ProceedProcess(NamedTuple):
    """PCPROCEED: go on with the process control program where it stopped."""


class RetryProcess(NamedTuple):
    """PCRETRY: as PCPROCEED, with the step that failed done again."""


class MonitorSpeed(NamedTuple):
    """SPEED of the operator [%]: the path stays, time is stretched."""

    percent: float


class Answer(NamedTuple):
    """A line typed at the terminal, for the PROMPT that waits or the next one."""

    text: str


class ForceSignals(NamedTuple):
    """Set signals by hand, inputs too; a negative number is off."""

    signals: tuple[int, ...]


class SetVariable(NamedTuple):
    """Give a variable a value, or none."""

    name: str  # as Global.name
    subscripts: tuple[int, ...]
    value: Value | None


class SetLocal(NamedTuple):
    """Give an argument or automatic variable of the innermost program a value, or none."""

    name: str  # as Slot.name
    subscripts: tuple[int, ...]
    value: Value | None
    process: bool = False  # of the process control program


class GoTo(NamedTuple):
    """Let the innermost program go on with another of its steps."""

    step: int
    process: bool = False  # the process control program


class DeleteVariables(NamedTuple):
    """Forget variables; a name stands for all elements of an array."""

    names: tuple[str, ...]


class Load(NamedTuple):
    """Add programs and data to memory; those of the same name are replaced."""

    module: Module


class DeletePrograms(NamedTuple):
    """Forget programs that are not being executed."""

    names: tuple[str, ...]


class PutBack(NamedTuple):
    """No command, but what people do: all parts stand as at first, and the hand is empty."""


class TakeAway(NamedTuple):
    """No command, but what people do: parts that stand elsewhere than at first are gone."""


Command: TypeAlias = (
    Execute
    | Abort
    | Panic
    | Proceed
    | Retry
    | RunSteps
    | EndCycle
    | Kill
    | Do
    | StartProcess
    | AbortProcess
    | EndProcess
    | ProceedProcess
    | RetryProcess
    | MonitorSpeed
    | Answer
    | ForceSignals
    | SetVariable
    | SetLocal
    | GoTo
    | DeleteVariables
    | Load
    | DeletePrograms
    | PutBack
    | TakeAway
)


class TimedCommand(NamedTuple):
    """A command and the simulated time [s] at which it is issued.

    It takes effect at the beginning of a tick; or, as a debugger wants it, within the tick of this
    time as soon as a number of statements of both programs is finished.
    """

    time_s: float
    command: Command
    after: int | None = None  # statements

    @property
    def order(self) -> tuple[float, int]:
        """What comes first is carried out first."""
        return self.time_s, -1 if self.after is None else self.after
