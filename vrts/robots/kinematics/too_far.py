"""Places that no configuration of a serial arm reaches, whatever its joints do: a proven bound.

An arm is no longer than its links laid end to end. That counts too much, since what lies along an
axis stays along it however its joint turns: so where a joint is said to be is slid along its axis
to the foot of the link before, and what lies along the axis goes over to the next link. Of the last
joint the place is known, because the flange's orientation is.
"""

from functools import lru_cache
from math import fsum, hypot
from typing import NamedTuple

from vrts.base.pose import Pose, Vector, add, distance, dot, rotate, scale, subtract
from vrts.robots.model import SerialArm

REACHED = 1e-6  # [m]


class Bound(NamedTuple):
    """How far the last joint can be from the first."""

    centre: Vector  # on the axis of joint 1, in B [m]
    to_last: Vector  # from the flange to the last joint, in F [m]
    reach_m: float  # no shorter than any distance of the two


def beyond(arm: SerialArm, X_BF: Pose) -> float:
    """Return by how much a pose is certainly too far [m]; not above zero: that is not known."""
    bound = _bound(arm.joints, arm.X_LF)
    last = add(X_BF.translation, rotate(X_BF.rotation, bound.to_last))
    return distance(last, bound.centre) - bound.reach_m - REACHED


def as_far_as_links(arm: SerialArm, X_BF: Pose) -> Pose:
    """Return a pose that is certainly too far, brought nearer until that is no longer known."""
    bound = _bound(arm.joints, arm.X_LF)
    out = subtract(add(X_BF.translation, rotate(X_BF.rotation, bound.to_last)), bound.centre)
    share = bound.reach_m / hypot(*out)
    return Pose(X_BF.rotation, add(X_BF.translation, scale(out, share - 1.0)))


@lru_cache(maxsize=16)
def _bound(joints: tuple[Pose, ...], X_LF: Pose) -> Bound:
    X_BL, *rest = joints
    height = rest[0].translation[2]  # of joint 2 along the axis of joint 1
    centre = add(X_BL.translation, rotate(X_BL.rotation, (0.0, 0.0, height)))
    lengths: list[float] = []
    slid = -height  # along the axis of the joint before
    for joint in rest:
        x, y, z = joint.translation
        link = (x, y, z + slid)
        axis = rotate(joint.rotation, (0.0, 0.0, 1.0))
        slid = dot(link, axis)
        lengths.append(hypot(*subtract(link, scale(axis, slid))))
    X_FL = X_LF.inverse()
    to_last = add(X_FL.translation, rotate(X_FL.rotation, (0.0, 0.0, -slid)))
    return Bound(centre, to_last, fsum(lengths))
