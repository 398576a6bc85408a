"""What may be wrong with a robot: every number that a log may tell, and what it is called."""

from enum import Enum
from typing import NamedTuple

from vrts.base.units import DEG, MM
from vrts.robots.built import LINKS
from vrts.robots.model import Arm, SphericalWristArm


class Kind(Enum):
    """What a number changes."""

    ZERO = "zero"  # a joint stands off, and its encoder shows it
    HIDDEN_ZERO = "hidden zero"  # a joint stands off, and only the tool shows it
    LINK = "link"  # the arm has another link than the scene says
    COUNTED_LINK = "counted link"  # the controller counts with another link
    TOOL = "tool"
    BASE = "base"
    TURN = "turn"  # of the base, as a rotation vector
    RATE = "rate"  # of the clock
    LAG = "lag"  # of the servos
    SPEEDS = "speeds"  # all of them, by one factor
    SPEED = "speed"  # of one joint
    LINE_SPEED = "line speed"
    ACCELERATION = "acceleration"
    CORNERS = "corners"


BY_TICKS = frozenset({Kind.SPEEDS, Kind.SPEED, Kind.LINE_SPEED, Kind.ACCELERATION, Kind.CORNERS})
"""What the controller turns into whole ticks: a small change may change nothing."""


class Cause(NamedTuple):
    """One number, 0 where the robot is as the scene says."""

    kind: Kind
    place: int = 0  # of the joint or the axis, from 0
    link: str = ""  # of a link: name of the field

    @property
    def by_ticks(self) -> bool:
        """Whether it works through whole ticks."""
        return self.kind in BY_TICKS

    @property
    def step(self) -> float:
        """A small change, for derivatives, in its own unit."""
        return STEPS.get(self.kind, 0.0)


STEPS = {
    Kind.ZERO: 0.01 * DEG,
    Kind.HIDDEN_ZERO: 0.01 * DEG,
    Kind.LINK: 0.1 * MM,
    Kind.COUNTED_LINK: 0.1 * MM,
    Kind.TOOL: 0.1 * MM,
    Kind.BASE: 0.1 * MM,
    Kind.TURN: 0.01 * DEG,
    Kind.RATE: 1e-5,
    Kind.LAG: 1e-3,
}
GROUPS = (
    tuple(Cause(Kind.BASE, axis) for axis in range(3)),
    (*(Cause(Kind.BASE, axis) for axis in range(3)), *(Cause(Kind.TURN, a) for a in range(3))),
    tuple(Cause(Kind.TOOL, axis) for axis in range(3)),
)


def causes_for(
    arm: Arm, *, joints: bool, positions: bool, decide: tuple[Cause, ...]
) -> list[tuple[Cause, ...]]:
    """Return what may be wrong, the simplest first, some of it several numbers at once.

    Args:
        arm: As the scene says.
        joints: Whether the log has joints.
        positions: Whether it has positions of the tool.
        decide: Numbers that work through ticks and that the run depends on.
    """
    found: list[tuple[Cause, ...]] = [(Cause(Kind.ZERO, joint),) for joint in range(6)]
    found += [(cause,) for cause in decide]
    # a lag behind the motion itself, or behind straight lines from set point to set point
    found += [(Cause(Kind.LAG, 1),), (Cause(Kind.LAG),), (Cause(Kind.RATE),)]
    if positions:
        found += [(Cause(kind, axis),) for kind in (Kind.TOOL, Kind.BASE) for axis in range(3)]
        found += [(Cause(Kind.TURN, axis),) for axis in range(3)]
        if joints:
            found += [(Cause(Kind.HIDDEN_ZERO, joint),) for joint in range(6)]
    if isinstance(arm, SphericalWristArm):
        kinds = [Kind.LINK, Kind.COUNTED_LINK] if positions else [Kind.COUNTED_LINK]
        found += [(Cause(kind, 0, link),) for kind in kinds for link in LINKS]
    if positions:
        found += GROUPS
    return found


def possible_ticks() -> list[Cause]:
    """Return every number that works through ticks."""
    return [
        Cause(Kind.SPEEDS),
        *(Cause(Kind.SPEED, joint) for joint in range(6)),
        Cause(Kind.LINE_SPEED),
        Cause(Kind.ACCELERATION),
        Cause(Kind.CORNERS),
    ]
