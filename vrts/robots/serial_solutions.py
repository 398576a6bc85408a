"""Solutions of the inverse kinematics of arms without a closed form, from a fixed list of starts.

The starts are the configuration the arm comes from and a grid over the limits; the same pose always
gives the same solutions. The grid finds the nearest of all solutions of nine poses in ten [assumed
enough]; a solution it finds is exact.
"""

import math
from itertools import product
from typing import cast

from vrts.base.pose import Pose, add, distance, dot, scale, subtract
from vrts.robots.approach import Approach, approach
from vrts.robots.chain import chain, extent
from vrts.robots.limits import limit_violations, turned
from vrts.robots.model import Configuration, SerialArm

MOST_STEPS = 30  # from one start; most need eight
SAME = 1e-6  # [rad] two solutions that differ less are one
HALVED = (0, 1, 2, 4)  # joints, from 0, whose range the grid halves; these tell solutions apart
ORIENTATION_FIRST = 10.0  # extents of the arm that count as a radian when a pose is out of reach
ASIDE = 0.2  # of half its range: how far the other joints start from their middle


def solutions(arm: SerialArm, X_BF: Pose, near: Configuration) -> tuple[Configuration, ...]:
    """Return the configurations found that put the flange at a pose, the nearest first.

    Every joint is given the turn nearest `near` within its limits. Configurations within all
    limits come first; nearest is the smallest of the largest changes of a joint.

    Args:
        arm: The arm.
        X_BF: Where the flange shall be.
        near: The present configuration.
    """
    found: list[Configuration] = []
    for start in (near, *starts(arm)):
        result = approach(arm, X_BF, start, MOST_STEPS)
        if not result.reached:
            continue
        q = nearest_turns(arm, result.configuration, near)
        if all(_change(q, other) > SAME for other in found):
            found.append(q)
    return tuple(sorted(found, key=lambda q: (bool(limit_violations(arm, q)), _change(q, near))))


def reach_error(arm: SerialArm, X_BF: Pose) -> tuple[str, float] | None:
    """Return why no start leads to a pose, and by how much.

    Returns:
        ("too far" or "too close", seen from the shoulder, and how far the flange stays away with
        the orientation nearly kept [m]), or None when one does.
    """
    best: Approach | None = None
    length = ORIENTATION_FIRST * extent(arm)
    for start in (arm.ready, *starts(arm)):
        result = approach(arm, X_BF, start, MOST_STEPS, length=length)
        if result.reached:
            return None
        if best is None or _left(result, length) < _left(best, length):
            best = result
    assert best is not None
    at = chain(arm, best.configuration)
    # on the axis of joint 1, at the height of joint 2
    axis, point = at.axes[0], at.points[0]
    centre = add(point, scale(axis, dot(subtract(at.points[1], point), axis)))
    wanted, got = distance(X_BF.translation, centre), distance(at.X_BF.translation, centre)
    return ("too far" if wanted >= got else "too close", best.gap_m)


def starts(arm: SerialArm) -> tuple[Configuration, ...]:
    """Return the grid: sixteen configurations within the limits."""
    values: list[tuple[float, ...]] = []
    for joint, (lower, upper) in enumerate(zip(arm.lower, arm.upper, strict=True)):
        middle, half = 0.5 * (lower + upper), min(0.5 * (upper - lower), math.pi)
        if joint in HALVED:
            values.append((middle - 0.5 * half, middle + 0.5 * half))
        else:
            values.append((middle + ASIDE * half,))
    return tuple(cast(Configuration, row) for row in product(*values))


def nearest_turns(arm: SerialArm, q: Configuration, near: Configuration) -> Configuration:
    """Return a configuration with every joint on the turn nearest `near` within its limits."""
    return cast(
        Configuration,
        tuple(
            turned(math.remainder(angle, math.tau), at, lower, upper)
            for angle, at, lower, upper in zip(q, near, arm.lower, arm.upper, strict=True)
        ),
    )


def _left(result: Approach, length: float) -> float:
    return result.gap_m / length + result.turn_rad


def _change(q: Configuration, near: Configuration) -> float:
    return max(abs(a - b) for a, b in zip(q, near, strict=True))
