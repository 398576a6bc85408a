"""The robots a scene can name."""

from vrts.robots.model import Robot, SphericalWristArm
from vrts.robots.puma import PUMA_560, PUMA_761, PUMA_762, TWO_FINGERS

_ARMS = {arm.name: arm for arm in (PUMA_761, PUMA_762, PUMA_560)}
_ROBOTS = {arm.name: Robot(arm, TWO_FINGERS) for arm in (PUMA_761, PUMA_762)}


def names() -> tuple[str, ...]:
    """Return the names of the robots that a scene can hold: those with geometry."""
    return tuple(_ROBOTS)


def robot(name: str) -> Robot:
    """Return the robot of a name. Raises KeyError when there is none."""
    return _ROBOTS[name]


def arm(name: str) -> SphericalWristArm:
    """Return the arm of a name, also of those without geometry. Raises KeyError."""
    return _ARMS[name]
