"""The UR3, UR5 and UR10 of Universal Robots, from the descriptions of the example-robot-data wheel.

Joints, limits, speeds and shapes are the wheel's; the rest is here.
"""

import sys
from functools import cache
from pathlib import Path

from vrts.base.units import DEG, MM
from vrts.robots.arms.primitives import degrees
from vrts.robots.model import Robot
from vrts.robots.urdf.description import UrdfFault
from vrts.robots.urdf.reader import read_urdf
from vrts.robots.urdf.serial_robot import Manner, serial_robot

WHEEL = "example-robot-data"
SHARE = "cmeel.prefix/share"
PACKAGE = "package://"

_READY = degrees(0, -90, 90, -90, -90, 0)  # forearm level, hand down in front [assumed]

_MANNERS = {
    name: Manner(
        name,
        f"Universal Robots {name.upper()}",
        ready=_READY,
        base_height=750 * MM,  # a column as high as a workbench [assumed]
        linear_speed=1000 * MM,  # [assumed]
        angular_speed=100 * DEG,  # as of the PUMA [assumed]
    )
    for name in ("ur3", "ur5", "ur10")
}


class WheelMissing(Exception):  # noqa: N818 -- names the situation
    """The robot's description is not installed."""


def names() -> tuple[str, ...]:
    """Return the names of these robots, whether or not the wheel is installed."""
    return tuple(_MANNERS)


@cache
def robot(name: str) -> Robot:
    """Return the robot of a name.

    Raises:
        KeyError: None of these has that name.
        WheelMissing: Its description is not installed, or not of the version this was made for.
    """
    manner = _MANNERS[name]
    share = _share()
    if share is None:
        raise WheelMissing(f"the package {WHEEL} is not installed")
    folder = share / WHEEL / "robots" / "ur_description"
    try:
        description = read_urdf((folder / "urdf" / f"{name}_robot.urdf").read_bytes())
        return serial_robot(
            description, manner, lambda file: (share / file.removeprefix(PACKAGE)).read_bytes()
        )
    except (OSError, UrdfFault) as fault:
        raise WheelMissing(f"the package {WHEEL} does not hold a usable {name}: {fault}") from fault


def _share() -> Path | None:
    """Return the folder in which the wheel keeps its data, wherever Python finds packages."""
    places = (Path(place) / SHARE for place in sys.path)
    return next((share for share in places if (share / WHEEL).is_dir()), None)
