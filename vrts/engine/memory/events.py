"""What happened at an instant. Every event names the instruction that caused it, if one did."""

from typing import NamedTuple, TypeAlias

from vrts.base.diagnostic import Diagnostic
from vrts.base.pose import Pose
from vrts.base.source import Span


class Cause(NamedTuple):
    """The instruction behind an event."""

    program: str
    step: int
    span: Span


class ProgramStarted(NamedTuple):
    """EXECUTE or PCEXECUTE took effect."""

    time_s: float
    program: str
    cause: Cause | None = None
    process: bool = False  # as the process control program


class ProgramEnded(NamedTuple):
    """A program is over; the robot program when the arm stands still."""

    time_s: float
    ending: str  # value of Ending
    cause: Cause | None = None
    process: bool = False  # the process control program


class ProgramProgressed(NamedTuple):
    """A program was resumed, began another cycle, or changed its priority."""

    time_s: float
    program: str
    cycles_done: int
    cycles_left: int  # the present one included; negative is endless
    priority: int
    running: bool
    cause: Cause | None = None
    process: bool = False  # the process control program


class MotionStarted(NamedTuple):
    """A motion began; `motion` indexes Run.motions."""

    time_s: float
    motion: int
    cause: Cause


class MotionEnded(NamedTuple):
    """A motion reached the end of its path, or was cut."""

    time_s: float
    motion: int
    cause: Cause


class HandCommanded(NamedTuple):
    """The hand began to open, close or go limp."""

    time_s: float
    action: str  # value of ir.HandAction
    cause: Cause | None


class Grasped(NamedTuple):
    """The pads met an object and it is attached as it lies."""

    time_s: float
    body: str
    X_FO: Pose  # object in the flange frame
    cause: Cause | None


class MissedOffCentre(NamedTuple):
    """Only one pad met an object: no grasp."""

    time_s: float
    body: str
    cause: Cause | None


class Released(NamedTuple):
    """An object left the hand."""

    time_s: float
    body: str
    height_m: float  # it will fall this far; 0 when set down
    cause: Cause | None


class Landed(NamedTuple):
    """A released object came to rest on a support."""

    time_s: float
    body: str
    support: str
    cause: Cause | None
    also: tuple[str, ...] = ()  # what it rests on beside that


class Toppled(NamedTuple):
    """A released object met something on which it cannot stand; it stays there."""

    time_s: float
    body: str
    support: str
    cause: Cause | None
    also: tuple[str, ...] = ()  # what it touches beside that


class SignalChanged(NamedTuple):
    """A binary signal changed."""

    time_s: float
    signal: int
    on: bool
    cause: Cause | None


class Printed(NamedTuple):
    """A program wrote to the terminal."""

    time_s: float
    text: str  # exactly, line ends included
    cause: Cause | None


class SwitchChanged(NamedTuple):
    """A system switch was turned on or off."""

    time_s: float
    switch: str
    on: bool
    cause: Cause | None


class AnalogChanged(NamedTuple):
    """An analog output got a value [counts]."""

    time_s: float
    channel: int
    value: float
    cause: Cause | None


class Prompted(NamedTuple):
    """A program waits for a line of the terminal."""

    time_s: float
    cause: Cause | None


class Answered(NamedTuple):
    """A line of the terminal was read."""

    time_s: float
    text: str
    cause: Cause | None


class Reacted(NamedTuple):
    """A reaction to a signal, or to a run-time error (signal 0), was taken."""

    time_s: float
    signal: int
    program: str
    cause: Cause | None


class SpeedChanged(NamedTuple):
    """The operator's speed changed [%]."""

    time_s: float
    percent: float
    cause: Cause | None = None


class CommandRefused(NamedTuple):
    """A command could not be carried out."""

    time_s: float
    words: str  # VAL's, without asterisks
    cause: Cause | None = None


class Found(NamedTuple):
    """A finding of the engine: an error that stopped the program, or a warning on the way."""

    time_s: float
    diagnostic: Diagnostic
    cause: Cause | None


Event: TypeAlias = (
    ProgramStarted
    | ProgramEnded
    | ProgramProgressed
    | MotionStarted
    | MotionEnded
    | HandCommanded
    | Grasped
    | MissedOffCentre
    | Released
    | Landed
    | Toppled
    | SignalChanged
    | Printed
    | SwitchChanged
    | AnalogChanged
    | Prompted
    | Answered
    | Reacted
    | SpeedChanged
    | CommandRefused
    | Found
)
