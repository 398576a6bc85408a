"""Reads what an object of a scene file looks like: the keys of its kind, in mm and degrees."""

import math

from vrts.base.diagnostic import Rule
from vrts.base.toml.reading import Table
from vrts.base.units import DEG, MM
from vrts.robots.model import Robot
from vrts.scene.colors import Color
from vrts.scene.reading.files import SceneFolder
from vrts.scene.things.forms import Form, dish, stand, table, upright_box, upright_cylinder
from vrts.scene.things.oven import BELOW, Oven, oven
from vrts.scene.things.pizza import ARM, pizza

PLATE_TOO_LOW = Rule("V485", "stand-too-low")
MOUTH_TOO_LOW = Rule("V486", "oven-mouth-too-low")

COLORS = {  # usual colours of the kinds
    "can": "red",
    "base": "steel",
    "box": "orange",
    "table": "wood",
    "dish": "white",
    "stand": "wood",
    "oven": "steel",
    "pizza": "#f0cf73",
    "mesh": "steel",
}
CARRIED = ("can", "dish", "pizza", "mesh")  # unless the file says otherwise
MAY_BE_FIXED = (*CARRIED, "box")
FARTHEST = 10_000.0  # [mm] any position or size
STEEPEST = 25.0  # [degrees] of a stand: steeper, nothing would stay on it
WALL = 5.0  # [mm] of a dish
PLATE = 16.0  # [mm] of a stand
STONE = 80.0  # [mm] height of the baking stone in an oven
LEAST_MOUTH = 50.0  # [mm] height of an oven's mouth: less, and no hand gets in
NARROWEST = 150.0  # [mm] depth and width of an oven
SMALLEST = 60.0  # [mm] radius of a pizza
HANDLE = 100.0  # [mm]
SHORTEST = ARM / MM + 30.0  # [mm] handle that leaves room for the fingers


def read_form(
    kind: str, section: Table, chosen: Robot, paint: Color, folder: SceneFolder
) -> Form | None:
    """Return the shape of an object, or None after saying what is wrong.

    Args:
        kind: One of `COLORS`.
        section: The object's.
        chosen: The robot, whose shoulder's height tells where the floor is.
        paint: The object's colour.
        folder: Where the pieces of a mesh are.
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
        case "oven":
            return _oven(section, paint)
        case "pizza":
            return _pizza(section, paint)
        case "mesh":
            from vrts.scene.reading.mesh_section import read_mesh  # numpy

            return read_mesh(section, folder)
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


def _oven(section: Table, paint: Color) -> Form | None:
    size = section.numbers("size_mm", count=3, minimum=NARROWEST, maximum=FARTHEST, required=True)
    lowest = math.ceil(BELOW / MM)
    stone = section.number("stone_mm", STONE, minimum=lowest, maximum=FARTHEST)
    if size is None:
        return None
    depth, width, height = size
    measures = Oven(depth * MM, width * MM, height * MM, stone * MM)
    mouth = measures.mouth / MM
    if mouth < LEAST_MOUTH:
        section.problems.error(
            MOUTH_TOO_LOW,
            "the mouth of the oven is too low",
            section.value_span("size_mm"),
            f"{max(0.0, mouth):.0f} mm is left above the stone, {LEAST_MOUTH:.0f} mm is needed",
            help=("make the oven higher, or its stone lower (`stone_mm`)",),
            data={"mouth_mm": mouth},
        )
        return None
    return oven(measures, paint)


def _pizza(section: Table, paint: Color) -> Form | None:
    radius = section.number("radius_mm", required=True, minimum=SMALLEST, maximum=FARTHEST)
    handle = section.number("handle_mm", HANDLE, minimum=SHORTEST, maximum=FARTHEST)
    return None if radius is None else pizza(radius * MM, handle * MM, paint)
