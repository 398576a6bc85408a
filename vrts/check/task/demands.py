"""What a task demands of the way a goal is reached, beside goals, via points and time."""

from enum import Enum
from fractions import Fraction
from typing import NamedTuple

from vrts.base.pose import Vector
from vrts.base.source import Span
from vrts.robots.model import Arm, SphericalWristArm

DEMAND = "demand "  # begins the names of checks of these


class Keeps(Enum):
    """What a demand is about."""

    TOOL_OUT = "tool out of zone"
    ROBOT_OUT = "robot out of zone"  # with what it holds
    UPRIGHT = "upright"
    JOINT_SPEED = "joint speed"
    TOOL_SPEED = "tool speed"
    WRIST = "wrist singularity"
    ELBOW = "elbow singularity"
    SHOULDER = "shoulder singularity"
    SINGULAR = "singular value"  # of arms without a spherical wrist
    USES = "must use"
    AVOIDS = "must not use"
    STEPS = "steps"


OF_SPHERICAL_WRIST = (Keeps.WRIST, Keeps.ELBOW, Keeps.SHOULDER)
OF_OTHERS = (Keeps.SINGULAR,)


class Demand(NamedTuple):
    """One thing to keep to, and what it costs not to."""

    keeps: Keeps
    name: str  # as shown: "zone glass", "can1 upright"
    points: Fraction  # lost when it is not kept
    span: Span | None
    limit: float = 0.0  # [rad], [m/s], [m], share of the joints' limits, or a plain number
    lower: Vector = (0.0, 0.0, 0.0)  # of a zone, in W [m]
    upper: Vector = (0.0, 0.0, 0.0)
    body: str = ""  # that is kept upright
    word: str = ""  # instruction, in upper case


def distances_of(arm: Arm) -> tuple[Keeps, ...]:
    """Return the kinds of distance from a singularity that are measured of an arm."""
    return OF_SPHERICAL_WRIST if isinstance(arm, SphericalWristArm) else OF_OTHERS
