"""Reads `[[via]]` of a task."""

import math

from vrts.base.diagnostic import Rule
from vrts.base.pose import Vector
from vrts.base.toml.reading import Problems, Table
from vrts.base.units import DEG, MM
from vrts.check.task.task import ViaPoint

VIA_POINT = Rule("V443", "via-point")

RADIUS_MM = 20.0  # when the file gives none
CONE_DEG = 10.0  # when the file gives a direction alone
FARTHEST = 10_000.0  # [mm] any position
FASTEST = 10_000.0  # [mm/s] any speed


def read_via(table: Table, problems: Problems, number: int) -> ViaPoint:
    """Return a via point; what is wrong goes to `problems`."""
    name = table.string("name", f"via {number}")
    at = table.numbers("at_mm", count=3, minimum=-FARTHEST, maximum=FARTHEST, required=True)
    radius = table.number("radius_mm", RADIUS_MM, above=0.0, maximum=FARTHEST)
    approach = table.numbers("approach", count=3, minimum=-FARTHEST, maximum=FARTHEST)
    cone = table.number("cone_deg", CONE_DEG, above=0.0, maximum=180.0)
    speed = table.numbers("speed_mm_s", count=2, minimum=0.0, maximum=FASTEST)
    table.finish()
    x, y, z = at or (0.0, 0.0, 0.0)
    found = ViaPoint(name, (x * MM, y * MM, z * MM), radius * MM, table.span)
    if approach is not None:
        direction = _direction(table, problems, name, approach)
        found = found._replace(approach=direction, cone=cone * DEG)
    elif "cone_deg" in table and "approach" not in table:
        problems.error(
            VIA_POINT,
            f"`{name}` has a cone, but no direction",
            table.value_span("cone_deg"),
            help=("add `approach = [0, 0, -1]`, where the tool is to point: here straight down",),
        )
    if speed is not None:
        slowest, fastest = speed
        found = found._replace(slowest=slowest * MM, fastest=fastest * MM)
        if slowest > fastest:
            problems.error(
                VIA_POINT,
                f"no speed is allowed at `{name}`",
                table.value_span("speed_mm_s"),
                help=("write the least speed first, then the largest: `speed_mm_s = [0, 100]`",),
            )
    return found


def _direction(
    table: Table, problems: Problems, name: str, given: tuple[float, ...]
) -> Vector | None:
    x, y, z = given
    length = math.hypot(x, y, z)
    if length == 0.0:
        problems.error(
            VIA_POINT,
            f"the approach of `{name}` points nowhere",
            table.value_span("approach"),
            help=("write where the tool is to point: straight down is `[0, 0, -1]`",),
        )
        return None
    return (x / length, y / length, z / length)
