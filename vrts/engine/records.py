"""Plain records that a Run is made of."""

from enum import Enum
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.engine.events import Cause
from vrts.ir.instructions import Interpolation
from vrts.robots.model import Configuration

COORDINATES = 7  # six joints [rad] and the hand opening [m]


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


class Ending(Enum):
    """How an execution ended."""

    COMPLETED = "completed"
    HALTED = "halted"
    PAUSED = "paused"
    ERROR = "error"  # a run-time error; the diagnostic is in Run.findings
    LIMIT = "limit"  # a limit of the scenario; the diagnostic is in Run.findings
    RUNNING = "running"  # not ended up to the horizon
    NOT_STARTED = "not started"
