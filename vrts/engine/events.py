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
    """EXECUTE took effect."""

    time_s: float
    program: str
    cause: Cause | None = None


class ProgramEnded(NamedTuple):
    """The robot program is over and the arm stands still."""

    time_s: float
    ending: str  # value of Ending
    cause: Cause | None = None


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


class Toppled(NamedTuple):
    """A released object met something on which it cannot stand; it stays there."""

    time_s: float
    body: str
    support: str
    cause: Cause | None


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


class Found(NamedTuple):
    """A finding of the engine: an error that stopped the program, or a warning on the way."""

    time_s: float
    diagnostic: Diagnostic
    cause: Cause | None


Event: TypeAlias = (
    ProgramStarted
    | ProgramEnded
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
    | Found
)
