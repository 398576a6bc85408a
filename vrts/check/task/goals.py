"""How things are to end: objects at places, and objects beside, on or in something."""

from enum import Enum
from fractions import Fraction
from typing import NamedTuple

from vrts.base.pose import Pose, Vector
from vrts.base.source import Span

TARGET = "target "  # begins the names of checks of these


class Looks(Enum):
    """Which turns of an object count as none, as far as its shape has them."""

    SHAPE = "shape"  # every turn after which it looks the same
    UPRIGHT = "upright"  # those about the vertical, but not upside down
    NONE = "none"  # not one: it has a label


class Phases(NamedTuple):
    """Shares of a goal's points for what comes before the object is in place."""

    gripped: Fraction = Fraction(0)
    lifted: Fraction = Fraction(0)
    height: float = 0.0  # it must have been carried up by so much [m]


class Choice(NamedTuple):
    """One way to reach a goal."""

    body: str
    place: int  # in a group of goals each place serves once, and each object
    X_WG: Pose
    where: str  # in words: "base1"


class Goal(NamedTuple):
    """An object that must end at rest in a pose; or one of several, or in one of several poses."""

    body: str  # of the first choice
    X_WG: Pose
    position_tolerance: float  # [m]
    orientation_tolerance: float  # [rad], after the turns that count as none
    weight: Fraction
    title: str  # "can1 on base2"
    span: Span | None
    looks: Looks = Looks.SHAPE
    phases: Phases = Phases()
    others: tuple[Choice, ...] = ()  # all choices, where there is more than one
    group: int | None = None  # goals that share objects or places; None: with no other

    @property
    def choices(self) -> tuple[Choice, ...]:
        """Every way to reach it, the first one first."""
        return self.others or (Choice(self.body, 0, self.X_WG, self.title),)

    @property
    def bodies(self) -> tuple[str, ...]:
        """Objects that can reach it, each once."""
        return tuple(dict.fromkeys(choice.body for choice in self.choices))

    @property
    def check(self) -> str:
        """Name of the check: no two goals of a task have one name."""
        return TARGET + (self.body if len(self.bodies) == 1 else self.title)


class Stands(Enum):
    """How an object is to end, as seen from the robot; the value is what a task file says."""

    LEFT = "left_of"  # Y is larger
    RIGHT = "right_of"
    FARTHER = "farther_than"  # X is larger
    NEARER = "nearer_than"
    ON = "stacked_on"
    ALIGNED = "aligned_with"
    INSIDE = "inside"


class Relation(NamedTuple):
    """An object that must end at rest in some relation to another one, or in a box."""

    body: str
    stands: Stands
    other: str  # "" for a box
    weight: Fraction
    title: str  # "can1 left of can2"
    span: Span | None
    distance: float = 0.0  # [m] at least, between the middles
    tolerance: float | None = None  # [m] full points up to here beyond what is asked; None: 0
    turn_tolerance: float = 0.0  # [rad] of things in a row
    along: str = ""  # axis of a row: "x" or "y"
    lower: Vector = (0.0, 0.0, 0.0)  # of the box, in W [m]
    upper: Vector = (0.0, 0.0, 0.0)

    @property
    def check(self) -> str:
        """Name of the check."""
        return TARGET + self.title
