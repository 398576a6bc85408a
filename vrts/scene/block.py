"""Locations as a VAL-II file writes them: name, then X Y Z in mm and O A T in degrees."""

from collections.abc import Mapping

from vrts.base.oat import components
from vrts.base.pose import Pose

DECIMALS = 2  # 0.01 mm and 0.01 degrees
NAME_WIDTH = 15  # VAL-II counts 15 characters of a name [manual language/names#length]


def location_line(name: str, X_WT: Pose) -> str:
    """Return the line of one location."""
    numbers = " ".join(f"{round(value, DECIMALS) + 0.0:8.2f}" for value in components(X_WT))
    return f"{name:<{NAME_WIDTH}} {numbers}"


def location_block(locations: Mapping[str, Pose]) -> str:
    """Return a `.LOCATIONS` section, ready to be pasted after a program."""
    lines = [location_line(name, X_WT) for name, X_WT in locations.items()]
    return "\n".join([".LOCATIONS", *lines, ".END"]) + "\n"
