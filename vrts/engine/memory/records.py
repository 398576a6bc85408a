"""Plain records that a Run is made of."""

from enum import Enum
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.engine.memory.events import Cause
from vrts.ir.instructions import Interpolation
from vrts.robots.model import Configuration

COORDINATES = 7  # six joints [rad] and the hand opening [m]
INSTANT = 1e-9  # [s] of two times nearer than this neither is earlier


class Segment(NamedTuple):
    """Polynomials valid on an interval: coordinate i is sum_k c[i][k] (t - start_s)^k."""

    start_s: float
    end_s: float
    coefficients: tuple[tuple[float, ...], ...]  # 7 rows, ascending powers, any degree up to 8
    motion: int | None  # index in Run.motions; None while the arm stands still


class Motion(NamedTuple):
    """One motion instruction as executed."""

    interpolation: Interpolation
    start_s: float
    end_s: float  # end of the planned path
    start: Configuration
    goal: Configuration
    X_WT: Pose  # tool pose at the goal
    X_FT: Pose  # tool in force
    speed_fraction: float  # program speed as a share of full speed
    deviation_m: float  # of the polynomials from the straight line; 0 for joint motions
    cause: Cause
    blended: bool = False  # its end is rounded into the next motion
    cut: bool = False  # it was given up on the way
    short: bool = False  # a line that ends before its target, where a fault stops it

    @property
    def arrives(self) -> bool:
        """Whether it comes to its target."""
        return not self.cut and not self.short


class ArmPiece(NamedTuple):
    """Polynomials of the six joints on an interval of path time, in powers of (t - start_s)."""

    start_s: float
    end_s: float
    rows: tuple[tuple[float, ...], ...]
    motion: int


class Stroke(NamedTuple):
    """The hand opening changes linearly, or stops at once where start and end coincide."""

    start_s: float
    end_s: float
    start_m: float
    end_m: float


def stroke_at(stroke: Stroke, time_s: float) -> float:
    """Return the opening on a stroke, or where it ended [m]."""
    if time_s >= stroke.end_s:
        return stroke.end_m
    share = (time_s - stroke.start_s) / (stroke.end_s - stroke.start_s)
    return stroke.start_m + share * (stroke.end_m - stroke.start_m)


class Lie(Enum):
    """How an object is where it is."""

    RESTING = "resting"  # X is X_WO
    HELD = "held"  # X is X_FO
    FALLING = "falling"  # X is X_WO at the start; it sinks by g/2 (t - start)^2
    TOPPLED = "toppled"  # X is X_WO; it stays at first contact


class Placement(NamedTuple):
    """Where one movable object is, over an interval of time."""

    body: str
    start_s: float
    end_s: float  # inf for the last
    lie: Lie
    X: Pose
    support: (
        str | None
    )  # resting, toppled: body underneath; held: the carried body it rests on, if any


GRAVITY = 9.81  # [m/s^2]


def pose_of(placement: Placement, time_s: float, X_WF: Pose) -> Pose:
    """Return X_WO of a body at a time, with the flange where it is then."""
    if placement.lie is Lie.HELD:
        return X_WF @ placement.X
    if placement.lie is Lie.FALLING:
        x, y, z = placement.X.translation
        fallen = 0.5 * GRAVITY * (time_s - placement.start_s) ** 2
        return Pose(placement.X.rotation, (x, y, z - fallen))
    return placement.X


class ProgramStatus(Enum):
    """What a program is doing."""

    NOT_RUNNING = "not running"
    RUNNING = "running"
    WAITING = "waiting"  # for the arm, a signal, an answer, a time
    STOPPED = "stopped"  # it can be resumed
    COMPLETED = "completed"


class ProgramState(NamedTuple):
    """The robot program or the process control program at an instant."""

    program: str  # as named to EXECUTE
    status: ProgramStatus
    cycles_done: int
    cycles_left: int  # the present one included; negative is endless
    priority: int
    cause: Cause | None  # the step to come, waited at, or that failed


class Ending(Enum):
    """How an execution ended."""

    COMPLETED = "completed"
    HALTED = "halted"
    PAUSED = "paused"
    ABORTED = "aborted"
    STEPPED = "stepped"  # the steps asked for were executed
    ERROR = "error"  # a run-time error; the diagnostic is in Run.findings
    LIMIT = "limit"  # a limit of the scenario; the diagnostic is in Run.findings
    RUNNING = "running"  # not ended up to the horizon
    NOT_STARTED = "not started"
