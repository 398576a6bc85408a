"""Solutions of the inverse kinematics of arms without a closed form, from a fixed list of starts.

The starts are the configuration the arm comes from and a grid over the limits; where they lead to
nothing within the limits, a finer grid. The same pose always gives the same solutions, and each is
exact; but no grid can promise that it finds the nearest of all: of poses and present configurations
drawn at random it does in five of six or better.
"""

import math
from collections.abc import Iterable
from functools import lru_cache
from itertools import product
from typing import cast

from vrts.base.pose import Pose, add, distance, dot, scale, subtract
from vrts.robots.kinematics.approach import Approach, approach
from vrts.robots.kinematics.chain import chain, extent, forward
from vrts.robots.kinematics.limits import TIE, limit_violations, turned
from vrts.robots.kinematics.too_far import as_far_as_links, beyond
from vrts.robots.model import Configuration, SerialArm

MOST_STEPS = 30  # from one start; most need eight
SAME = 1e-6  # [rad] two solutions that differ less are one
COARSE = (2, 2, 2, 1, 2, 1)  # parts of the range of each joint; these tell solutions apart
FINER = (2, 3, 3, 2, 2, 1)
ORIENTATION_FIRST = 10.0  # extents of the arm that count as a radian when a pose is out of reach
REMEMBERED = 128  # answers: a program that fails at a place may try again and again
ASIDE = 0.2  # of half its range: how far a joint that is not cut starts from its middle


@lru_cache(maxsize=REMEMBERED)
def solutions(arm: SerialArm, X_BF: Pose, near: Configuration) -> tuple[Configuration, ...]:
    """Return the configurations found that put the flange at a pose, the nearest first.

    Every joint is given the turn nearest `near` within its limits. Configurations within all
    limits come first; nearest is the smallest of the largest changes of a joint.

    Args:
        arm: The arm.
        X_BF: Where the flange shall be.
        near: The present configuration.
    """
    if beyond(arm, X_BF) > 0.0:
        return ()
    found: list[Configuration] = []
    _collect(arm, X_BF, near, (near, *starts(arm)), found)
    if all(limit_violations(arm, q) for q in found):
        _collect(arm, X_BF, near, starts(arm, FINER), found)
    return tuple(sorted(found, key=lambda q: _order(arm, q, near)))


def _order(arm: SerialArm, q: Configuration, near: Configuration) -> tuple[bool, list[int]]:
    """Return a key: within limits first, then by the largest change, then by the next largest.

    Changes are counted in steps, so that rounding does not choose.
    """
    changes = sorted((abs(a - b) for a, b in zip(q, near, strict=True)), reverse=True)
    return bool(limit_violations(arm, q)), [round(change / TIE) for change in changes]


@lru_cache(maxsize=REMEMBERED)
def reach_error(arm: SerialArm, X_BF: Pose) -> tuple[str, float] | None:
    """Return why no start leads to a pose, and by how much.

    Returns:
        ("too far" or "too close", seen from the shoulder, and how far the flange stays away with
        the orientation nearly kept [m]), or None when one does.
    """
    if beyond(arm, X_BF) > 0.0:  # steps are short far away, and all starts lead to much the same
        best = _best(arm, as_far_as_links(arm, X_BF), (arm.ready, *starts(arm)))
        return ("too far", distance(X_BF.translation, forward(arm, best.configuration).translation))
    best = _best(arm, X_BF, (arm.ready, *starts(arm), *starts(arm, FINER)))
    if best.reached:
        return None
    at = chain(arm, best.configuration)
    # on the axis of joint 1, at the height of joint 2
    axis, point = at.axes[0], at.points[0]
    centre = add(point, scale(axis, dot(subtract(at.points[1], point), axis)))
    wanted, got = distance(X_BF.translation, centre), distance(at.X_BF.translation, centre)
    return ("too far" if wanted >= got else "too close", best.gap_m)


def _best(arm: SerialArm, X_BF: Pose, from_: Iterable[Configuration]) -> Approach:
    """Return where the first start leads that reaches a pose, else the one that comes nearest."""
    best: Approach | None = None
    length = weighs_orientation(arm)
    for start in from_:
        result = approach(arm, X_BF, start, MOST_STEPS, length=length)
        if best is None or result.reached or _left(result, length) < _left(best, length):
            best = result
        if result.reached:
            break
    assert best is not None
    return best


def weighs_orientation(arm: SerialArm) -> float:
    """Return the length that counts as a radian where a pose is out of reach [m]."""
    return ORIENTATION_FIRST * extent(arm)


def starts(arm: SerialArm, parts: tuple[int, ...] = COARSE) -> tuple[Configuration, ...]:
    """Return a grid of configurations within the limits.

    Args:
        arm: The arm.
        parts: Into how many the range of each joint is cut, at most a full turn of it; a start
            stands in the middle of every part.
    """
    values: list[tuple[float, ...]] = []
    for lower, upper, count in zip(arm.lower, arm.upper, parts, strict=True):
        middle, half = 0.5 * (lower + upper), min(0.5 * (upper - lower), math.pi)
        if count == 1:
            values.append((middle + ASIDE * half,))
        else:
            shares = ((2 * number + 1) / count - 1.0 for number in range(count))
            values.append(tuple(middle + share * half for share in shares))
    return tuple(cast(Configuration, row) for row in product(*values))


def _collect(
    arm: SerialArm,
    X_BF: Pose,
    near: Configuration,
    from_: Iterable[Configuration],
    found: list[Configuration],
) -> None:
    """Add the solutions to which starts lead and that are not there yet."""
    for start in from_:
        result = approach(arm, X_BF, start, MOST_STEPS)
        if not result.reached:
            continue
        q = nearest_turns(arm, result.configuration, near)
        if all(_change(q, other) > SAME for other in found):
            found.append(q)


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
