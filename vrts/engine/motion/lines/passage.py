"""The joints on the way from one set point to the next, looked at as closely as they turn.

Between two set points a line may pass a singularity, lose its reach, or come out on another
solution of the kinematics. Where a joint turns far, the way is halved until it turns little in
every part.
"""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeAlias

from vrts.base.pose import Pose
from vrts.robots.kinematics.approach import approach
from vrts.robots.kinematics.kinematics import reach_error
from vrts.robots.kinematics.limits import limit_violations
from vrts.robots.kinematics.serial_solutions import MOST_STEPS, weighs_orientation
from vrts.robots.kinematics.singular import least_direction, singular_at
from vrts.robots.kinematics.tracking import track
from vrts.robots.model import Arm, ArmBranch, Configuration, SerialArm

LITTLE = 0.1  # [rad] that a joint turns in a part of the way that is looked at
MOST_HALVINGS = 12  # of the way between two set points: at 1 m/s to less than 0.01 mm

Flange: TypeAlias = Callable[[float], Pose]
"""X_BF that a line asks for at a path time [s]."""


class Stand(NamedTuple):
    """How the arm stands at a path time [s]."""

    time_s: float
    q: Configuration
    branch: ArmBranch


class Met(NamedTuple):
    """A singularity that makes a joint too fast."""

    name: str
    time_s: float  # path time
    joint: int  # from 0


class Passage(NamedTuple):
    """How the arm gets on."""

    last: Stand  # at the end, or where it can go no farther
    lost_s: float | None = None  # path time at which no solution goes on
    met: Met | None = None


def passage(arm: Arm, flange: Flange, start: Stand, end_s: float) -> Passage:
    """Follow the flange closely.

    Args:
        arm: The arm; its limits bind, so give one without.
        flange: Where the flange shall be.
        start: Where the arm stands.
        end_s: Until when, in path time.
    """
    at, shortest = start, (end_s - start.time_s) * 0.5**MOST_HALVINGS
    met, worst = None, 0.0
    waiting = [end_s]
    while waiting:
        goal = waiting[-1]
        found = track(arm, flange(goal), at.branch, at.q)
        far = found is None or turned(at.q, found[0]) > LITTLE
        if far and goal - at.time_s > shortest:
            waiting.append(0.5 * (at.time_s + goal))
            continue
        if found is None:
            return Passage(at, goal, met)
        q, branch = found
        name = singular_at(arm, q) or singular_at(arm, at.q)
        if name is None and far:  # it turns round at one point
            name = "singular"
        if name is not None:
            joint, share = fastest_joint(arm, at.q, q, goal - at.time_s)
            caused = far or _by_singularity(arm, at, Stand(goal, q, branch), joint)
            if caused and share > max(worst, 1.0):
                met, worst = Met(name, goal, joint), share
        at = Stand(waiting.pop(), q, branch)
    return Passage(at, None, met)


def fastest_joint(
    arm: Arm, before: Configuration, after: Configuration, step_s: float
) -> tuple[int, float]:
    """Return the joint (from 0) that turns fastest, as a share of its limit."""
    shares = [
        abs(b - a) / (speed * step_s) for a, b, speed in zip(before, after, arm.speed, strict=True)
    ]
    most = max(shares)
    return shares.index(most), most


def too_fast(arm: Arm, before: Configuration, after: Configuration, step_s: float) -> bool:
    """Return whether any joint turns faster than its limit: asked at every set point."""
    a1, a2, a3, a4, a5, a6 = before
    b1, b2, b3, b4, b5, b6 = after
    s1, s2, s3, s4, s5, s6 = arm.speed
    return not (
        abs(b1 - a1) <= s1 * step_s
        and abs(b2 - a2) <= s2 * step_s
        and abs(b3 - a3) <= s3 * step_s
        and abs(b4 - a4) <= s4 * step_s
        and abs(b5 - a5) <= s5 * step_s
        and abs(b6 - a6) <= s6 * step_s
    )


def _by_singularity(arm: Arm, before: Stand, after: Stand, joint: int) -> bool:
    """Return whether a joint is too fast because of the direction in which the hand hardly moves.

    What the joints do in that direction is taken away: is the joint within its limit then?
    """
    direction = least_direction(arm, after.q)
    turns = [b - a for a, b in zip(before.q, after.q, strict=True)]
    wasted = math.fsum(x * y for x, y in zip(direction, turns, strict=True))
    rest = abs(turns[joint] - wasted * direction[joint])
    return rest <= arm.speed[joint] * (after.time_s - before.time_s)


def turned(a: Configuration, b: Configuration) -> float:
    """Return how far the joint turns that turns most [rad]."""
    return max([abs(x - y) for x, y in zip(a, b, strict=True)])


def crossing(
    arm: Arm, flange: Flange, start: Stand, end_s: float, plus: Callable[[float], Configuration]
) -> float:
    """Return the path time at which a joint passes its limit, on a short way at whose end it has.

    Args:
        arm: The arm, with its limits.
        flange: Where the flange shall be.
        start: Where the arm stands, within the limits.
        end_s: When a joint is beyond.
        plus: What is added to the joints.
    """
    low, high = start.time_s, end_s
    for _ in range(MOST_HALVINGS):
        middle = 0.5 * (low + high)
        found = track(arm, flange(middle), start.branch, start.q)
        q = None if found is None else [a + b for a, b in zip(found[0], plus(middle), strict=True)]
        if q is None or limit_violations(arm, tuple(q)):  # type: ignore[arg-type]
            high = middle
        else:
            low = middle
    return high


def farthest_out(
    arm: Arm, flange: Flange, times: Sequence[float], last: Configuration
) -> tuple[str, float, float] | None:
    """Return how far beyond reach a line goes at most, as far as it was sampled.

    Returns:
        "too far" or "too close", the excess [m], and the path time; None where every place can be
        reached, although not from where the arm is.
    """
    if isinstance(arm, SerialArm):  # the nearest that the steps lead to, not the nearest of all
        X_BFs = [flange(time_s) for time_s in times]
        length = weighs_orientation(arm)
        gaps: list[float] = []
        for X_BF in X_BFs:
            result = approach(arm, X_BF, last, MOST_STEPS, length=length)
            last = result.configuration
            gaps.append(result.gap_m)
        worst = max(range(len(gaps)), key=gaps.__getitem__)
        error = reach_error(arm, X_BFs[worst])
        return None if error is None else (*error, times[worst])
    excesses = [_excess(arm, flange, time_s) for time_s in times]
    worst = max(range(len(times)), key=excesses.__getitem__)
    low, high = times[max(worst - 1, 0)], times[min(worst + 1, len(times) - 1)]
    for _ in range(MOST_HALVINGS):  # between the set points beside it
        third = (high - low) / 3.0
        if _excess(arm, flange, low + third) < _excess(arm, flange, high - third):
            low += third
        else:
            high -= third
    time_s = max((low, times[worst], high), key=lambda t: _excess(arm, flange, t))
    error = reach_error(arm, flange(time_s))
    return None if error is None else (*error, time_s)


def _excess(arm: Arm, flange: Flange, time_s: float) -> float:
    error = reach_error(arm, flange(time_s))
    return 0.0 if error is None else error[1]
