"""What a controller model is: every reading of the documents that time or motion depends on.

The documents of VAL-II that could be read leave much of this open. Each field is one such question,
each value one answer to it. `models` has the models.
"""

from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple

FITTED = " fitted"  # end of the name of a model with a pace fitted from logs


class NoLength(Enum):
    """How long a motion takes that goes nowhere."""

    NO_TIME = "no time"  # the arm is there already; nothing is joined to it by a corner
    LEAST_TIME = "least time"  # as the shortest motion does
    BY_KIND = "by kind"  # a joint motion from rest no time, any other one the least time


class CornerShape(Enum):
    """How the speed changes from one motion to the next in a rounded corner."""

    QUARTIC = "quartic"  # the acceleration begins and ends at zero
    PARABOLA = "parabola"  # the acceleration is constant


class LineTurn(Enum):
    """How the tool turns along a straight line."""

    TWO_TURNS = "two turns"  # one of the approach vector, one about it
    ONE_AXIS = "one axis"  # about the axis that carries one orientation into the other


class TurnMeasure(Enum):
    """Which angle of two turns at once the limit of turning speed is for."""

    LARGER = "larger"  # of the two
    SUM = "sum"  # of the two
    TRUE = "true"  # how fast the tool turns in space: both are about axes at right angles


class Settling(Enum):
    """When the controller waits until the joints are near enough."""

    EVERY_STOP = "every stop"  # before whatever comes after the arm has stopped
    WAITS = "waits"  # only before steps that wait for the arm, such as BREAK


class WristChoice(Enum):
    """Which wrist a MOVE takes when neither FLIP nor NOFLIP was asked for."""

    NEAREST = "nearest"  # the one whose largest change of joints 4 to 6 is smaller
    KEPT = "kept"  # the present one while it is within limits


class AlignTurn(Enum):
    """How ALIGN turns the hand about the tool's own axis."""

    SMALLEST = "smallest turn"  # whatever comes of the smallest turn to the axis of the world
    KEEPS_T = "keeps T"  # along a level axis T stays as it was


class Pace(NamedTuple):
    """How long motions take."""

    tick_s: float  # between set points of the trajectory generator
    departure_ticks: int  # from a motion instruction at rest to the start of its motion
    acceleration_s: float | None  # from rest to full speed; None: as the robot's data say
    least_accelerations: float  # a motion takes at least so many times its acceleration
    no_length: NoLength
    most_speed_percent: float  # a higher program speed acts as this
    most_monitor_percent: float  # a higher speed of the operator acts as this
    brake_accelerations: float  # BRAKE and stops take so many times the acceleration
    monitor_accelerations: float  # a change of the operator's speed takes so many times it
    pendant_percent: float  # of the arm's speed, at the pendant's full speed


class Corners(NamedTuple):
    """How corners between motions are rounded."""

    shape: CornerShape
    half_accelerations: float  # half a corner takes so many times the longer acceleration
    whole_s: (
        float | None
    )  # a corner at full acceleration; None: as the robot's data, else by the above


class Lines(NamedTuple):
    """How the tool turns along straight lines, and to the axis that ALIGN finds."""

    turn: LineTurn
    measure: TurnMeasure
    align: AlignTurn


class Stops(NamedTuple):
    """What happens where the arm stops."""

    settling: Settling
    fine_ticks: int  # of settling, with FINE and NULL
    coarse_ticks: int  # with COARSE and NULL
    branch_words_wait: bool  # RIGHTY and its like wait until the arm stands still


class NextMotion(NamedTuple):
    """What counts as the next motion, for settings that hold for one motion only."""

    delay_uses_settings: bool  # DELAY uses up SPEED, COARSE and their like
    delay_moves_hand: bool  # OPEN and CLOSE act when a DELAY begins
    drive_uses_speed: bool  # DRIVE uses up a SPEED that it does not go by


class Programs(NamedTuple):
    """How programs and their steps go on in time."""

    steps_a_tick: int  # of each program
    hand_s: float | None  # wait after OPENI and its like; None: the hand's whole stroke
    pulse_s: float  # of PULSE without a time


class Branches(NamedTuple):
    """Which arm branch motions take, and how near a boundary the arm keeps the one it had."""

    wrist: WristChoice
    shoulder_boundary_m: float  # of the wrist's signed reach in the arm plane
    elbow_boundary_m: float  # of the elbow's signed bend
    wrist_boundary_deg: float  # of joint 5


@dataclass(frozen=True, slots=True)
class ControllerModel:
    """One way to read the documents: an answer to every question that they leave open."""

    name: str  # "val2"
    title: str  # in words
    pace: Pace
    corners: Corners
    lines: Lines
    stops: Stops
    next_motion: NextMotion
    programs: Programs
    branches: Branches
    fitted_from: tuple[str, ...] = ()  # sha256 of the logs it was fitted from
