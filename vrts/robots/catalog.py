"""The robots a scene can name."""

from vrts.robots.arms.gripper import TWO_FINGERS
from vrts.robots.arms.puma import PUMA_761, PUMA_762
from vrts.robots.arms.puma560 import PUMA_560
from vrts.robots.model import Arm, Robot, SphericalWristArm
from vrts.robots.urdf.universal import WheelMissing
from vrts.robots.urdf.universal import names as universal_names
from vrts.robots.urdf.universal import robot as universal_robot

__all__ = ["WheelMissing", "arm", "names", "puma", "robot"]

_PUMAS = {arm.name: arm for arm in (PUMA_761, PUMA_762, PUMA_560)}
_ROBOTS = {name: Robot(arm, TWO_FINGERS) for name, arm in _PUMAS.items()}


def names() -> tuple[str, ...]:
    """Return the names of the robots that a scene can hold."""
    return (*_ROBOTS, *universal_names())


def robot(name: str) -> Robot:
    """Return the robot of a name.

    Raises:
        KeyError: There is none.
        WheelMissing: Its description is not installed.
    """
    return _ROBOTS.get(name) or universal_robot(name)


def arm(name: str) -> Arm:
    """Return the arm of a name; raises as `robot` does."""
    return robot(name).arm


def puma(name: str) -> SphericalWristArm:
    """Return the arm of a name of the PUMA family. Raises KeyError when there is none."""
    return _PUMAS[name]
