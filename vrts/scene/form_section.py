"""Reads what an object of a scene file looks like: the keys of its kind, in mm and degrees."""

import math

from vrts.base.diagnostic import Rule
from vrts.base.toml import Table
from vrts.base.units import DEG, MM
from vrts.robots.model import Robot
from vrts.scene.things import Form, dish, stand, table, upright_box, upright_cylinder

PLATE_TOO_LOW = Rule("V485", "stand-too-low")

COLORS = {  # usual colours of the kinds
    "can": "red",
    "base": "steel",
    "box": "orange",
    "table": "wood",
    "dish": "white",
    "stand": "wood",
}
CARRIED = ("can", "dish")  # unless the file says otherwise
MAY_BE_FIXED = (*CARRIED, "box")
FARTHEST = 10_000.0  # [mm] any position or size
STEEPEST = 25.0  # [degrees] of a stand: steeper, nothing would stay on it
WALL = 5.0  # [mm] of a dish
PLATE = 16.0  # [mm] of a stand


def read_form(kind: str, section: Table, chosen: Robot) -> Form | None:
    """Return the shape of an object, or None after saying what is wrong.

    Args:
        kind: One of `COLORS`.
        section: The object's.
        chosen: The robot, whose shoulder's height tells where the floor is.
    """
    match kind:
        case "can":
            return _cylinder(section)
        case "base" if "radius_mm" in section:
            return _cylinder(section)
        case "base" | "box":
            size = section.numbers("size_mm", count=3, above=0.0, maximum=FARTHEST, required=True)
            return None if size is None else upright_box(*(length * MM for length in size))
        case "dish":
            return _dish(section)
        case "stand":
            return _stand(section)
        case _:
            return _table(section, chosen)


def _table(section: Table, chosen: Robot) -> Form | None:
    problems_before = len(section.problems.found)
    size = section.numbers("size_mm", count=2, above=0.0, maximum=FARTHEST, required=True)
    floor_mm = -chosen.arm.shoulder_height / MM
    top_mm = section.number("top_z_mm", required=True, above=floor_mm, maximum=FARTHEST)
    legs = section.boolean("legs", default=True)
    height = ((top_mm or 0.0) - floor_mm) * MM
    thickness = section.number(
        "thickness_mm", min(40.0, height / MM), above=0.0, maximum=height / MM
    )
    if size is None or top_mm is None or len(section.problems.found) > problems_before:
        return None
    return table(size[0] * MM, size[1] * MM, height, thickness * MM, legs=legs)


def _cylinder(section: Table) -> Form | None:
    radius = section.number("radius_mm", required=True, above=0.0, maximum=FARTHEST)
    height = section.number("height_mm", required=True, above=0.0, maximum=FARTHEST)
    if radius is None or height is None:
        return None
    return upright_cylinder(radius * MM, height * MM)


def _dish(section: Table) -> Form | None:
    radius = section.number("radius_mm", required=True, above=0.0, maximum=FARTHEST)
    height = section.number("height_mm", required=True, above=0.0, maximum=FARTHEST)
    if radius is None or height is None:
        return None
    thickest = min(radius, height) / 2
    wall = section.number("wall_mm", min(WALL, thickest), above=0.0, maximum=thickest)
    return dish(radius * MM, height * MM, wall * MM)


def _stand(section: Table) -> Form | None:
    size = section.numbers("size_mm", count=2, above=0.0, maximum=FARTHEST, required=True)
    height = section.number("height_mm", required=True, above=0.0, maximum=FARTHEST)
    slope = section.number("slope_deg", required=True, minimum=0.0, maximum=STEEPEST)
    if size is None or height is None or slope is None:
        return None
    x, y = size
    lowest = height - x / 2 * math.sin(slope * DEG)
    if lowest <= PLATE:
        section.problems.error(
            PLATE_TOO_LOW,
            "the low end of the stand is below what it stands on",
            section.value_span("height_mm"),
            f"its upper side would be {lowest:.0f} mm high there, and it is {PLATE:.0f} mm thick",
            help=("make it higher, shorter or less steep",),
            data={"lowest_mm": lowest},
        )
        return None
    return stand(x * MM, y * MM, height * MM, PLATE * MM, slope * DEG)
