"""What stands on what when a run starts, and what cannot be there."""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.diagnostic import Label, Rule
from vrts.base.toml.reading import Problems
from vrts.base.units import mm
from vrts.geometry.support import bounds
from vrts.robots.model import Robot
from vrts.scene.clearance import clearance, overlap_is_within, placed_body, placed_robot
from vrts.scene.model import Body, Mobility
from vrts.scene.outline import Polygon, contains, hull, plan
from vrts.scene.outline import corners as hull_corners

OVERLAP = Rule("V613", "objects-overlap")
UNSUPPORTED = Rule("V614", "not-supported")

DEEPEST = 0.2e-3  # [m] overlap that counts as touching, as for contact events
TOUCHING = 1e-3  # [m] gap between an underside and what it stands on
LEVEL = 0.05e-3  # [m] corners of a mesh this near to the lowest one are its underside


class Support(NamedTuple):
    """What holds a body up."""

    body: str | None  # the support under the centre of mass; None: nothing, or not enough
    touching: tuple[str, ...]  # everything under it that it touches


def find_support(body: Body, others: Sequence[Body]) -> Support:
    """Return what a body stands on. Bodies are upright: their undersides are level."""
    underside = bounds(body.pieces, body.X_WO).lower[2]
    footprint = plan(body.pieces, body.X_WO)
    x, y, _ = body.X_WO.apply(body.centre_of_mass)
    areas: list[tuple[str, Polygon]] = []
    for other in others:
        if other.name == body.name:
            continue
        for piece in other.pieces:
            top = bounds((piece,), other.X_WO).upper[2]
            area = plan((piece,), other.X_WO)
            if -DEEPEST <= underside - top <= TOUCHING and _meet(footprint, area):
                areas.append((other.name, area))
    touching = tuple(dict.fromkeys(name for name, _ in areas))
    for name, area in areas:
        if contains(area, (x, y)):
            return Support(name, touching)
    if contains(hull(point for _, area in areas for point in area), (x, y)):
        return Support(touching[0], touching)  # a bridge
    return Support(None, touching)


def check_overlaps(bodies: Sequence[Body], problems: Problems) -> None:
    """Report every pair of bodies that are in each other."""
    placed = [placed_body(body) for body in bodies]
    for index, second in enumerate(placed):
        for first in placed[:index]:
            if overlap_is_within(first, second, DEEPEST):
                continue
            body, other = bodies[index], first.name
            depth = -clearance(first, second, 0.0)
            problems.error(
                OVERLAP,
                f"`{body.name}` is inside `{other}` at the start",
                body.span,
                f"{mm(depth):.1f} mm deep",
                secondary=_labels(bodies, other),
                help=("move one of the two, or let one stand `on` the other",),
                data={"bodies": (other, body.name), "depth_m": depth},
            )


def check_robot(robot: Robot, bodies: Sequence[Body], problems: Problems) -> None:
    """Report every body that is in the robot as it stands ready. The floor may touch its base."""
    parts = placed_robot(robot, robot.arm.ready, robot.gripper.opening_min)
    for body in bodies:
        placed = placed_body(body)
        for part in parts:
            if body.kind == "floor" or overlap_is_within(part, placed, DEEPEST):
                continue
            problems.error(
                OVERLAP,
                f"`{body.name}` is inside the robot at the start",
                body.span,
                f"overlaps the {part.name} of the robot in its ready position",
                help=("move it away from the robot, which stands at x = 0, y = 0",),
                data={"bodies": (part.name, body.name)},
            )
            break


def check_support(body: Body, support: Support, problems: Problems) -> None:
    """Report a body that would fall."""
    if support.body is not None:
        return
    if support.touching:
        named = " and ".join(f"`{name}`" for name in support.touching)
        headline = f"`{body.name}` would topple off {named}"
        text = "its middle is not above what it stands on"
    else:
        headline = f"`{body.name}` stands on nothing"
        text = f"its underside is at z = {mm(body.X_WO.translation[2]):.1f} mm"
    problems.error(
        UNSUPPORTED,
        headline,
        body.span,
        text,
        help=('write on = "NAME" of what it stands on, and an `at_mm` above it',),
        data={"body": body.name},
    )


def check_footing(body: Body, problems: Problems) -> None:
    """Report a mesh whose middle is not above the corners that it stands on."""
    if body.kind != "mesh":
        return
    lowest = bounds(body.pieces, body.X_WO).lower[2]
    corners = (body.X_WO.apply(c) for piece in body.pieces for c in hull_corners(piece))
    foot = hull((x, y) for x, y, z in corners if z <= lowest + LEVEL)
    x, y, _ = body.X_WO.apply(body.centre_of_mass)
    if contains(foot, (x, y)):
        return
    problems.error(
        UNSUPPORTED,
        f"`{body.name}` would topple: its middle is not above its own underside",
        body.span,
        help=("choose another `up`, or write fixed = true",),
        data={"body": body.name},
    )


def must_stand(body: Body) -> bool:
    """Return whether a body needs a support: what is fixed may be mounted on a wall."""
    return body.mobility is Mobility.MOVABLE or body.kind == "base"


def _labels(bodies: Sequence[Body], name: str) -> tuple[Label, ...]:
    span = next((body.span for body in bodies if body.name == name), None)
    return (Label(span, "the other one"),) if span else ()


def _meet(a: Polygon, b: Polygon) -> bool:
    """Return whether two convex polygons overlap: no edge of either separates them."""
    for polygon, other in ((a, b), (b, a)):
        for (ax, ay), (bx, by) in zip(polygon, (*polygon[1:], polygon[0]), strict=True):
            if all((bx - ax) * (y - ay) - (by - ay) * (x - ax) <= 0.0 for x, y in other):
                return False
    return True
