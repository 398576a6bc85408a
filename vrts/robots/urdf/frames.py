"""Where the links of a URDF file are in the frames L_k that turn with the joints.

Every joint's frame is turned so that its axis is z, as `SerialArm` wants it.
"""

import math
from collections.abc import Iterable
from typing import NamedTuple

from vrts.base.pose import (
    IDENTITY,
    X_AXIS,
    Z_AXIS,
    Pose,
    Rotation,
    Vector,
    cross,
    dot,
    rotation_about,
    scale,
)
from vrts.robots.urdf.description import JOINTS
from vrts.robots.urdf.joints import Joint
from vrts.robots.urdf.values import QUARTER, clean


class Placed(NamedTuple):
    """A link of the file in the frame L_k it moves with."""

    joint: int
    X_LU: Pose


def placed_links(
    links: Iterable[str], joints: tuple[Joint, ...], moving: tuple[Joint, ...]
) -> tuple[dict[str, Placed], tuple[Pose, ...]]:
    """Return every link in the frame it moves with, and the frames L_1 to L_6 in those before."""
    children = {joint.child for joint in joints}
    root = next(link for link in links if link not in children)
    found = {root: Placed(0, IDENTITY)}
    frames: dict[int, Pose] = {}
    for joint in joints:
        at = found[joint.parent]
        X_LC = at.X_LU @ joint.X_PC
        if not joint.turning:
            found[joint.child] = Placed(at.joint, X_LC)
            continue
        number = moving.index(joint) + 1
        align = Pose(_from_z(joint.axis), (0.0, 0.0, 0.0))  # L_k in the link's own frame
        frames[number] = clean(X_LC @ align)
        found[joint.child] = Placed(number, align.inverse())
    return found, tuple(frames[number] for number in range(1, JOINTS + 1))


def _from_z(axis: Vector) -> Rotation:
    """Return the smallest rotation that carries z into a unit vector."""
    across = cross(Z_AXIS, axis)
    sine, cosine = math.hypot(*across), dot(Z_AXIS, axis)
    if sine < QUARTER:
        return rotation_about(X_AXIS, 0.0 if cosine > 0.0 else math.pi)
    return clean(
        Pose(rotation_about(scale(across, 1.0 / sine), math.atan2(sine, cosine)), (0.0, 0.0, 0.0))
    ).rotation
