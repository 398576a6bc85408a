"""A robot from an arm's description: convex links, the hand, and which links are never compared."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import combinations
from typing import NamedTuple, cast

from vrts.base.pose import Pose, translation
from vrts.base.units import MM
from vrts.geometry.proving.scalar import nearest
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece
from vrts.geometry.support import bounds
from vrts.robots.arms.gripper import TWO_FINGERS
from vrts.robots.kinematics.chain import link_poses
from vrts.robots.kinematics.limits import limit_violations
from vrts.robots.model import Configuration, Link, Robot, SerialArm
from vrts.robots.urdf.description import (
    Description,
    Part,
    Shape,
    UrdfFault,
)

COLUMN_RADIUS = 90 * MM  # of the column under an arm that stands above the floor [assumed]
PLATE = (60 * MM, 5 * MM)  # radius and thickness of a base nothing is known of [assumed]


class Manner(NamedTuple):
    """What a description does not say about an arm."""

    name: str
    title: str
    ready: Configuration  # [rad]
    base_height: float  # of B above the floor, on a column [m]
    linear_speed: float  # [m/s]
    angular_speed: float  # [rad/s]
    acceleration_time: float = 0.224  # as of the PUMA, so that programs compare [assumed]
    tick: float = 0.028  # as of the PUMA [assumed]


def serial_robot(description: Description, manner: Manner, mesh: Callable[[str], bytes]) -> Robot:
    """Return the robot of a description.

    Args:
        description: Of the arm.
        manner: What else there is to know.
        mesh: Returns the file of a mesh, by the name in the description.

    Raises:
        UrdfFault: A mesh cannot be used, a joint has no speed, or the ready configuration violates
            a limit.
    """
    for joint, speed in zip(description.joint_names, description.speed, strict=True):
        if speed <= 0.0:
            raise UrdfFault(f"joint `{joint}` has no speed: give `velocity` in its limit")
    arm = SerialArm(
        name=manner.name,
        title=manner.title,
        joints=description.joints,
        X_LF=description.X_LF,
        shoulder_height=manner.base_height,
        lower=cast(Configuration, description.lower),
        upper=cast(Configuration, description.upper),
        speed=cast(Configuration, description.speed),
        ready=manner.ready,
        linear_speed=manner.linear_speed,
        angular_speed=manner.angular_speed,
        acceleration_time=manner.acceleration_time,
        tick=manner.tick,
        links=_links(description.parts, manner.base_height, mesh),
        skipped_pairs=frozenset(),
    )
    violations = limit_violations(arm, arm.ready)
    if violations:
        joint, value, lower, upper = violations[0]
        raise UrdfFault(
            f"ready puts joint {joint} at {math.degrees(value):.1f} degrees; its limits are"
            f" {math.degrees(lower):.1f} and {math.degrees(upper):.1f}"
        )
    return Robot(_with_skipped_pairs(arm), TWO_FINGERS)


def _links(
    parts: Sequence[Part], base_height: float, mesh: Callable[[str], bytes]
) -> tuple[Link, ...]:
    """Return one link for each joint, the base first."""
    found: list[Link] = []
    for joint in range(7):
        own = [part for part in parts if part.joint == joint and (part.shapes or joint == 0)]
        pieces = [_piece(shape, mesh) for part in own for shape in part.shapes]
        if joint == 0:
            pieces += _foot(base_height, bare=not pieces)
        if pieces:
            named = next((part for part in own if part.shapes), own[0] if own else None)
            found.append(Link(_words(named.name if named else "base"), joint, tuple(pieces)))
    return tuple(found)


def _foot(base_height: float, *, bare: bool) -> list[Piece]:
    """Return the column the arm stands on, or a plate where there would be nothing."""
    if base_height > 0.0:
        half = 0.5 * base_height
        return [Piece(Cylinder(COLUMN_RADIUS, half), translation(0.0, 0.0, -half))]
    radius, thickness = PLATE
    half = 0.5 * thickness
    return [Piece(Cylinder(radius, half), translation(0.0, 0.0, half))] if bare else []


def _words(name: str) -> str:
    return name.removesuffix("_link").replace("_", " ").strip() or "link"


def _piece(shape: Shape, mesh: Callable[[str], bytes]) -> Piece:
    match shape.kind:
        case "box":
            x, y, z = shape.size
            return Piece(Box((x / 2, y / 2, z / 2)), shape.X_LP)
        case "cylinder":
            radius, length = shape.size
            return Piece(Cylinder(radius, length / 2), shape.X_LP)
        case _:
            return Piece(_hull(shape, mesh), shape.X_LP)


def _hull(shape: Shape, mesh: Callable[[str], bytes]) -> Hull:
    from vrts.robots.urdf import hulls  # loads numpy, which runs with other robots do without

    if shape.kind == "sphere":
        return hulls.ball(shape.size[0])
    return hulls.mesh_hull(shape, mesh(shape.file))


def _with_skipped_pairs(arm: SerialArm) -> SerialArm:
    """Return the arm with the pairs of links that meet at ready: they do so by construction."""
    poses = link_poses(arm, arm.ready)
    met = [
        frozenset((first.name, second.name))
        for first, second in combinations(arm.links, 2)
        if second.joint > first.joint + 1
        and _meet(first, poses[first.joint], second, poses[second.joint])
    ]
    return replace(arm, skipped_pairs=frozenset(met))


def _meet(first: Link, X_BA: Pose, second: Link, X_BB: Pose) -> bool:
    a, b = bounds(first.pieces, X_BA), bounds(second.pieces, X_BB)
    if any(a.lower[k] > b.upper[k] or b.lower[k] > a.upper[k] for k in range(3)):
        return False
    return any(nearest(p, X_BA, q, X_BB).lower <= 0.0 for p in first.pieces for q in second.pieces)
