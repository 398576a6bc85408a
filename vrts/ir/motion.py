"""Instructions that move the arm or the hand, and the settings of motions.

Where one waits for the arm to stand still first, its docstring says "breaks continuous path".
"""

from enum import Enum
from typing import NamedTuple

from vrts.ir.expressions import Expression


class Interpolation(Enum):
    """How a motion goes from where the arm is to its target."""

    JOINT = "joint"
    LINEAR = "linear"


class Scope(Enum):
    """How long a motion setting holds."""

    NEXT_MOTION = "next"
    ALWAYS = "always"


class SpeedUnit(Enum):
    """Unit of a program speed."""

    PERCENT = "percent"
    MM_PER_S = "mm/s"
    INCH_PER_S = "inch/s"


class Accuracy(Enum):
    """How close to its end an arm must be for a motion to count as finished."""

    COARSE = "coarse"
    FINE = "fine"


class HandAction(Enum):
    """What the hand is told to do."""

    OPEN = "open"
    CLOSE = "close"
    RELAX = "relax"


class BranchRequest(Enum):
    """An arm branch asked for the next joint-interpolated motion to a pose."""

    RIGHTY = "righty"
    LEFTY = "lefty"
    ABOVE = "above"
    BELOW = "below"
    FLIP = "flip"
    NOFLIP = "noflip"


class Move(NamedTuple):
    """MOVE, MOVES, APPRO, APPROS: to a location, or `retreat` [mm] short of it along tool -Z.

    MOVET and MOVEST change the hand on the way, to `opening` [mm]; a pneumatic hand opens above 0.
    """

    interpolation: Interpolation
    target: Expression
    retreat: Expression | None = None
    opening: Expression | None = None


class Depart(NamedTuple):
    """DEPART, DEPARTS: back along tool -Z [mm] from the destination of the last motion."""

    interpolation: Interpolation
    distance: Expression


class Drive(NamedTuple):
    """DRIVE: one joint (1..6) by a change [deg], at its own speed [%]; None is 100."""

    joint: Expression
    change: Expression
    speed: Expression | None = None


class Draw(NamedTuple):
    """DRAW: straight by dx, dy, dz [mm], in world axes or those of the tool, turned by rx, ry, rz.

    The rotations [deg] and the speed [mm/s] are those of AS; None is 0, or the program speed.
    """

    offsets: tuple[Expression | None, ...]  # dx, dy, dz, rx, ry, rz
    in_tool: bool = False
    speed: Expression | None = None


class Align(NamedTuple):
    """ALIGN: turn the tool about its tip until it points along the nearest world axis."""


class Ready(NamedTuple):
    """READY: joint-interpolated to the robot's ready configuration."""


class Nest(NamedTuple):
    """NEST, REST: joint-interpolated to the parameter NEST.POS."""


class Delay(NamedTuple):
    """DELAY: a motion to nowhere that lasts a time [s]; ends continuous path."""

    time: Expression


class Break(NamedTuple):
    """BREAK: wait until the arm stands still. Breaks continuous path."""


class Brake(NamedTuple):
    """BRAKE: slow down to rest now and give the motion under way up. The program does not wait."""


class SetSpeed(NamedTuple):
    """SPEED value [MMPS|IPS] [ALWAYS]; V+ also gives the share of the rotational speed [%]."""

    value: Expression
    unit: SpeedUnit
    scope: Scope
    rotation: Expression | None = None


class SetMonitorSpeed(NamedTuple):
    """SPEED value MONITOR (V+): the operator's speed [%]."""

    value: Expression


class SetAcceleration(NamedTuple):
    """ACCEL, DECEL: percent of the normal acceleration and deceleration; None is unchanged."""

    acceleration: Expression | None
    deceleration: Expression | None
    scope: Scope


class SetDuration(NamedTuple):
    """DURATION: least time of a motion [s]; 0 is none."""

    time: Expression
    scope: Scope


class SetAccuracy(NamedTuple):
    """COARSE, FINE: how exactly a stop is waited for; V+ takes a percentage of the tolerance."""

    accuracy: Accuracy
    scope: Scope
    percent: Expression | None = None


class SetNulling(NamedTuple):
    """NULL, NONULL: whether a stop waits until the joint errors are small."""

    on: bool
    scope: Scope


class SetIntegration(NamedTuple):
    """INTON, INTOFF: integral action of the servos; kept, without effect on an ideal servo."""

    on: bool
    scope: Scope


class SetTurns(NamedTuple):
    """SINGLE, MULTIPLE: whether joints 4 and 6 may go beyond half a turn."""

    multiple: bool
    scope: Scope


class RequestBranch(NamedTuple):
    """RIGHTY .. NOFLIP: kept until a joint-interpolated motion does it. Breaks continuous path."""

    branch: BranchRequest


class MoveHand(NamedTuple):
    """OPEN, CLOSE, RELAX with the next motion; the I forms break, act now and wait HAND.TIME."""

    action: HandAction
    immediate: bool
    opening: Expression | None = None  # [mm], servo hands only


class Grasp(NamedTuple):
    """GRASP: close now; an opening below `distance` [mm] afterwards means that the part is missing.

    Then the program goes on at `missing`, or stops when there is no such label. Breaks.
    """

    distance: Expression
    missing: int | None = None  # index of an instruction


class SetTool(NamedTuple):
    """TOOL: pose of the tool tip in the flange frame; None is NULL. Breaks continuous path."""

    pose: Expression | None


class SetBase(NamedTuple):
    """BASE dx, dy, dz [mm], rotation [deg]: the robot was displaced. Breaks continuous path."""

    dx: Expression | None
    dy: Expression | None
    dz: Expression | None
    rotation: Expression | None


class SetBaseFrame(NamedTuple):
    """BASE of AS: pose of the new base frame in the robot's own. Breaks continuous path."""

    pose: Expression
