"""The section `[robot.built]`: how an arm stands where that is not what its controller counts with.

A laboratory's own numbers, measured or found by `vrts validate --identify`: joints, links, tool and
base, and under `within` how far each may be from the truth.
"""

from dataclasses import replace
from typing import cast

from vrts.base.pose import Pose, Vector, rotate
from vrts.base.toml.reading import Table
from vrts.base.units import DEG, MM
from vrts.robots.built import LINKS, as_built
from vrts.robots.model import Arm, Configuration, Off, SphericalWristArm, Within

SECTION, WITHIN = "built", "within"
SHOWN, ZEROS, LINK, COUNTED = "stands_off_deg", "zero_deg", "link_mm", "counted_link_mm"
TOOL, BASE, TURN = "tool_mm", "base_mm", "base_turn_deg"
SPEEDS, LINES = "speed_percent", "linear_percent"
ACCELERATION, BLEND = "acceleration_s", "blend_s"
MOST_DEG, MOST_MM = 20.0, 100.0  # more is another robot, not one that is off
MOST_PERCENT, MOST_S = 50.0, 1.0
NO_LINKS = (0.0, 0.0, 0.0, 0.0)


def read_built(section: Table | None, arm: Arm, X_FT: Pose) -> Arm:
    """Return an arm as a section says that it stands, and with the links that are counted.

    Args:
        section: None: the arm stands as its controller counts.
        arm: As the scene says.
        X_FT: TOOL with which programs start: the tool's error is given along its axes.
    """
    if section is None:
        return arm
    family = isinstance(arm, SphericalWristArm)  # others have no such links: their keys are unknown
    off = _off(section, links=family, least=-1.0)
    counted = _links(section, COUNTED, -MOST_MM) if family else NO_LINKS
    doubts, within = section.table(WITHIN), Within()
    if doubts is not None:
        within = _within(doubts, X_FT, links=family)
    section.finish()
    off = off._replace(tool=rotate(X_FT.rotation, off.tool))
    if isinstance(arm, SphericalWristArm):
        longer = zip(LINKS, counted, strict=True)
        arm = replace(arm, **{link: getattr(arm, link) + by for link, by in longer})
        a, b, c, d = (by - more for by, more in zip(off.links, counted, strict=True))
        off = off._replace(links=(a, b, c, d))
    if off == Off() and within == Within():
        return arm
    return as_built(arm, off, within)


def _within(section: Table, X_FT: Pose, *, links: bool) -> Within:
    off = _off(section, links=links, least=0.0)
    if links:
        a, b, c, d = map(sum, zip(off.links, _links(section, COUNTED, 0.0), strict=True))
        off = off._replace(links=(a, b, c, d))
    speeds = section.numbers(SPEEDS, (0.0,) * 6, count=6, minimum=0.0, maximum=MOST_PERCENT)
    found = Within(
        off._replace(tool=_boxed(X_FT, off.tool)),
        cast(Configuration, tuple(0.01 * one for one in speeds or (0.0,) * 6)),
        0.01 * section.number(LINES, 0.0, minimum=0.0, maximum=MOST_PERCENT),
        section.number(ACCELERATION, 0.0, minimum=0.0, maximum=MOST_S),
        section.number(BLEND, 0.0, minimum=0.0, maximum=MOST_S),
    )
    section.finish()
    return found


def _off(section: Table, *, links: bool, least: float) -> Off:
    """Return the numbers of a section, the tool's along T; `least` is -1 where they have signs."""
    least_deg, least_mm = least * MOST_DEG, least * MOST_MM
    return Off(
        _joints(section, SHOWN, least_deg),
        _joints(section, ZEROS, least_deg),
        _links(section, LINK, least_mm) if links else NO_LINKS,
        _vector(section, TOOL, MM, least_mm, MOST_MM),
        _vector(section, BASE, MM, least_mm, MOST_MM),
        _vector(section, TURN, DEG, least_deg, MOST_DEG),
    )


def _boxed(X_FT: Pose, half: Vector) -> Vector:
    """Return half the edges of a box along F that holds one along T."""
    r = X_FT.rotation
    x, y, z = (sum(abs(r[3 * row + k]) * half[k] for k in range(3)) for row in range(3))
    return (x, y, z)


def _joints(section: Table, key: str, least: float) -> Configuration:
    found = section.numbers(key, (0.0,) * 6, count=6, minimum=least, maximum=MOST_DEG)
    return cast(Configuration, tuple(DEG * one for one in found or (0.0,) * 6))


def _links(section: Table, key: str, least: float) -> tuple[float, float, float, float]:
    found = section.numbers(key, (0.0,) * 4, count=4, minimum=least, maximum=MOST_MM)
    a, b, c, d = found or (0.0,) * 4
    return (MM * a, MM * b, MM * c, MM * d)


def _vector(section: Table, key: str, unit: float, least: float, most: float) -> Vector:
    found = section.numbers(key, (0.0,) * 3, count=3, minimum=least, maximum=most)
    x, y, z = found or (0.0,) * 3
    return (unit * x, unit * y, unit * z)
