"""What a robot is, as data. The numbers, with their sources, stand in one file per robot."""

from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple, TypeAlias

from vrts.base.pose import Pose, Vector, translation
from vrts.geometry.shapes import Piece

Configuration: TypeAlias = tuple[float, float, float, float, float, float]
"""Six joint positions [rad] in VAL's convention: READY of a PUMA is 0, -90, 90, 0, 0, 0 degrees."""


class Shoulder(Enum):
    """Which side the arm hangs on: the sign of the reach in the arm plane."""

    LEFTY = "lefty"
    RIGHTY = "righty"


class Elbow(Enum):
    """Elbow above or below the line from shoulder to wrist."""

    ABOVE = "above"
    BELOW = "below"


class Wrist(Enum):
    """Sign of joint 5."""

    NOFLIP = "noflip"  # joint 5 >= 0
    FLIP = "flip"  # joint 5 < 0


class ArmBranch(NamedTuple):
    """Which solution of the inverse kinematics: VAL's manuals call it configuration."""

    shoulder: Shoulder
    elbow: Elbow
    wrist: Wrist


class Link(NamedTuple):
    """A rigid part of the arm that turns with a joint (0 is the base)."""

    name: str  # "base", "turret", "upper arm", "forearm", "wrist", "wrist bend", "flange", ...
    joint: int  # number of joints before it; its frame L_k is right after the rotation of joint k
    pieces: tuple[Piece, ...]  # in frame L_k


class Finger(NamedTuple):
    """A finger that moves along the flange's y axis with the hand."""

    name: str  # "left finger", "right finger"
    side: int  # +1 or -1: its pad stands at y = side * opening / 2
    pieces: tuple[Piece, ...]  # in the flange frame F at opening 0


@dataclass(frozen=True, slots=True)
class Gripper:
    """A two-finger parallel hand on the flange frame F: z out of it, y from finger to finger."""

    name: str
    opening_min: float  # [m]
    opening_max: float  # [m]
    stroke_time: float  # full stroke [s]
    body: tuple[Piece, ...]  # in F
    fingers: tuple[Finger, Finger]
    X_FP: Pose  # centre P between the pads; z along the approach, y from finger to finger
    pad_width: float  # extent of a pad along x of P [m]
    pad_length: float  # extent of a pad along z of P [m]
    overlap_min: float  # a grasp needs this much overlap of object and pad [m]

    @property
    def finger_speed(self) -> float:
        """Change of the opening while the fingers move [m/s]."""
        return (self.opening_max - self.opening_min) / self.stroke_time


NO_JOINTS: Configuration = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class Off(NamedTuple):
    """By how much an arm as it stands differs from what its controller counts with."""

    shown: Configuration = NO_JOINTS  # by which joints stand off; encoders show it [rad]
    zeros: Configuration = NO_JOINTS  # the same, of which encoders show nothing [rad]
    links: tuple[float, float, float, float] = (
        0.0,
        0.0,
        0.0,
        0.0,
    )  # a2, a3, d2, d4 [m]
    tool: Vector = (0.0, 0.0, 0.0)  # of the hand, in F [m]
    base: Vector = (0.0, 0.0, 0.0)  # of the whole arm, in W [m]
    turn: Vector = (0.0, 0.0, 0.0)  # of the whole arm about the origin of W, rotation vector [rad]


class Within(NamedTuple):
    """How far the truth may be from what was found: half intervals, none negative."""

    off: Off = Off()
    speeds: Configuration = NO_JOINTS  # shares of the largest joint speeds
    lines: float = 0.0  # share of the speed of straight lines
    acceleration_s: float = 0.0
    blend_s: float = 0.0


class Built(NamedTuple):
    """An arm as it stands, where that is not what its controller counts with.

    The frames are those of the arm of steel; commanded joints turn in them.
    """

    joints: tuple[Pose, ...]  # six: of L_k in L_(k-1) while joint k is commanded to zero
    X_LF: Pose  # the flange in L_6
    off: Off
    within: Within = Within()


@dataclass(frozen=True)
class Named:
    """What an arm is called."""

    name: str  # "puma761"
    title: str  # "Unimation PUMA 761"


@dataclass(frozen=True)
class SphericalWristGeometry(Named):
    """Standard DH rows (alpha, a, d) of the PUMA family, with VAL's joint angles.

    Rows: (-90, 0, 0), (0, a2, d2), (+90, a3, 0), (-90, 0, d4), (+90, 0, 0), (0, 0, d6).
    """

    a2: float  # [m]
    a3: float  # [m]
    d2: float  # [m]
    d4: float  # [m]
    d6: float  # [m]

    @property
    def X_LF(self) -> Pose:
        """The flange in L_6: d6 along the axis of joint 6."""
        return translation(0.0, 0.0, self.d6)


@dataclass(frozen=True)
class SerialGeometry(Named):
    """Six turning joints, one behind the other: joint k turns L_k about its own z axis."""

    joints: tuple[Pose, ...]  # six: of L_k in L_(k-1) with joint k at zero; L_0 is B
    X_LF: Pose  # the flange in L_6


@dataclass(frozen=True)
class ArmData(Named):
    """What is known of every arm alike: limits, speeds, shape."""

    shoulder_height: float  # of B above the floor [m]
    lower: Configuration  # joint limits [rad]
    upper: Configuration  # [rad]
    speed: Configuration  # largest joint speeds [rad/s]
    ready: Configuration  # [rad]
    linear_speed: float  # straight lines at SPEED 100 [m/s]
    angular_speed: float  # straight lines at SPEED 100 [rad/s]
    acceleration_time: float  # of every motion [s]
    tick: float  # trajectory generator [s]
    links: tuple[Link, ...]  # joint 0 to 6
    skipped_pairs: frozenset[frozenset[str]]  # link names never tested against each other
    blend_time: float | None = None  # of a rounded corner [s]; None: twice the acceleration time
    built: Built | None = None  # as it stands; None: as its controller counts


# The order of the bases gives that of the fields: name, geometry, the rest. Bundles hold a digest
# of an arm, field by field.


@dataclass(frozen=True, slots=True)
class SphericalWristArm(ArmData, SphericalWristGeometry):
    """A six-axis arm of the PUMA family.

    Base frame B: origin where the axes of joints 1 and 2 meet level, z up.
    """


@dataclass(frozen=True, slots=True)
class SerialArm(ArmData, SerialGeometry):
    """Any arm of six turning joints; it has no arm branches. Base frame B: z up."""


Arm: TypeAlias = SphericalWristArm | SerialArm


def flange_in_hand(arm: Arm) -> Pose:
    """Return X_LF of the arm as it stands, the flange in L_6."""
    return arm.X_LF if arm.built is None else arm.built.X_LF


@dataclass(frozen=True, slots=True)
class Robot:
    """An arm with its gripper. `gripper.X_FP` is not VAL's TOOL: programs set that."""

    arm: Arm
    gripper: Gripper
