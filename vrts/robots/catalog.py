"""The robots a scene can name."""

from vrts.robots.gripper import TWO_FINGERS
from vrts.robots.model import Arm, Robot
from vrts.robots.puma import PUMA_761, PUMA_762
from vrts.robots.puma560 import PUMA_560

_PUMAS = {arm.name: Robot(arm, TWO_FINGERS) for arm in (PUMA_761, PUMA_762, PUMA_560)}


def names() -> tuple[str, ...]:
    """Return the names of the robots that a scene can hold."""
    return tuple(_PUMAS)


def robot(name: str) -> Robot:
    """Return the robot of a name. Raises KeyError when there is none."""
    return _PUMAS[name]


def arm(name: str) -> Arm:
    """Return the arm of a name. Raises KeyError when there is none."""
    return robot(name).arm
