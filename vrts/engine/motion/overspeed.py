"""Joints that a motion asks for more speed than they have, and the SPEED that would do.

Such a motion is generated as commanded. The remedy is not estimated: the same motion is planned
again, slower, until no joint is too fast.
"""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeAlias

from vrts.base.remembered import is_remembering, remembered
from vrts.engine.motion.lines.set_points import Piece
from vrts.engine.motion.paths import JointPath
from vrts.engine.motion.plan import Intent, joint_profile, line_profile
from vrts.engine.motion.polynomials import Row, rate
from vrts.engine.motion.remarks import Overspeed
from vrts.robots.model import Arm, Configuration

SPEED_TOLERANCE = 1e-6  # share of the limit; rounding of the polynomials
TRIES_PAST = 5  # of speeds at which a line may get past a singularity, each half of the one before
CUBIC = 4  # coefficients
LOOKS = 16  # at a polynomial of higher degree than three

Planning: TypeAlias = Callable[[Intent], Sequence[Piece] | None]
"""Plans a motion; None when it cannot be carried out like that."""


class Fastest(NamedTuple):
    """The largest share of its limit that a joint's speed reaches."""

    share: float
    joint: int  # from 0
    speed: float  # [rad/s] in path time


def fastest(pieces: Sequence[Piece], limits: Configuration) -> Fastest:
    """Return the joint that comes nearest to its speed limit, or is farthest above it."""
    if not is_remembering():
        return _fastest(pieces, limits)
    key = ("fastest", id(pieces), limits)
    return remembered(key, lambda: _fastest(pieces, limits), alive=pieces)


def _fastest(pieces: Sequence[Piece], limits: Configuration) -> Fastest:
    found = Fastest(0.0, 0, 0.0)
    for start, end, rows in pieces:
        for joint, (row, limit) in enumerate(zip(rows, limits, strict=True)):
            if len(row) < 2:
                continue
            speed = _peak(row, end - start)
            if speed > found.share * limit:
                found = Fastest(speed / limit, joint, speed)
    return found


def none_too_fast(pieces: Sequence[Piece], limits: Configuration, rate_of_time: float) -> bool:
    """Return whether surely no joint is too fast, as is nearly always so, without its peak.

    The speed of a cubic never leaves the range of its three Bezier ordinates. What they do not
    tell of a polynomial, its peak does.
    """
    allowed = [limit * (1.0 + SPEED_TOLERANCE / 2.0) / rate_of_time for limit in limits]
    for start, end, rows in pieces:
        length = end - start
        for row, most in zip(rows, allowed, strict=True):
            if len(row) == CUBIC:
                _, first, bend, twist = row
                middle = first + bend * length
                last = middle + (bend + 3.0 * twist * length) * length
                if -most <= first <= most and -most <= middle <= most and -most <= last <= most:
                    continue
            if len(row) > 1 and not _peak(row, length) <= most:
                return False
    return True


def overspeed(
    arm: Arm,
    pieces: Sequence[Piece],
    rate_of_time: float,
    intent: Intent,
    plannings: Sequence[Planning],
) -> Overspeed | None:
    """Return what is too fast in a motion; None when nothing is.

    Args:
        arm: The arm.
        pieces: Of the motion.
        rate_of_time: The operator's speed, as a share of full speed.
        intent: The motion.
        plannings: Plan it again: as it stands, then from rest.
    """
    if none_too_fast(pieces, arm.speed, rate_of_time):
        return None
    most = fastest(pieces, arm.speed)
    if most.share * rate_of_time <= 1.0 + SPEED_TOLERANCE:
        return None
    speed, limit = most.speed * rate_of_time, arm.speed[most.joint]
    linear = not isinstance(intent.path, JointPath)
    for number, planning in enumerate(plannings):
        percent = _fitting(arm, rate_of_time, intent, planning, most.share * rate_of_time)
        if percent is not None:
            return Overspeed(most.joint + 1, speed, limit, percent, number > 0, linear)
    return Overspeed(most.joint + 1, speed, limit, None, linear=linear)


def past_singularity(
    arm: Arm, rate_of_time: float, intent: Intent, planning: Planning, share: float
) -> int | None:
    """Return a percentage at which a line gets past a singularity; None: none that was tried does.

    Args:
        arm: The arm.
        rate_of_time: The operator's speed, as a share of full speed.
        intent: The line that is stopped by it.
        planning: Plans it again.
        share: Of its limit at which a joint would have to turn.
    """
    percent = math.floor(100.0 * intent.fraction / share)
    for _ in range(TRIES_PAST):
        if percent < 1:
            return None
        pieces = planning(slower(arm, intent, percent))
        if pieces is not None and fastest(pieces, arm.speed).share * rate_of_time <= 1.0:
            return percent
        percent //= 2
    return None


def slower(arm: Arm, intent: Intent, percent: int) -> Intent:
    """Return a motion as SPEED makes it, with nothing said about the speed of turning."""
    fraction = percent / 100.0
    settings = intent.settings._replace(rotation=None)
    if isinstance(intent.path, JointPath):
        profile = joint_profile(arm, intent.path, settings, fraction, intent.model)
    else:
        profile = line_profile(arm, intent.path, settings, fraction, intent.model)
    return intent._replace(settings=settings, fraction=fraction, profile=profile)


def _fitting(
    arm: Arm, rate_of_time: float, intent: Intent, planning: Planning, share: float
) -> int | None:
    """Return a percentage at which the motion was planned without an excess; one more was too much.

    A little below what the excess says, set points fall elsewhere: so the search goes down until
    something fits, then halves the gap.
    """

    def fits(percent: int) -> bool:
        pieces = planning(slower(arm, intent, percent))
        if pieces is None:
            return False
        return fastest(pieces, arm.speed).share * rate_of_time <= 1.0 + SPEED_TOLERANCE

    too_much = math.ceil(100.0 * intent.fraction - 1e-9)
    percent = min(math.floor(100.0 * intent.fraction / share) + 1, too_much - 1)
    step = 1
    while percent >= 1 and not fits(percent):
        too_much, percent = percent, (percent - step if percent > step else percent // 2)
        step *= 2
    if percent < 1:
        return None
    while too_much - percent > 1:
        middle = (percent + too_much) // 2
        if fits(middle):
            percent = middle
        else:
            too_much = middle
    return percent


def _peak(row: Row, length: float) -> float:
    """Return the largest absolute derivative of a polynomial, from 0 to a length.

    Exact up to cubics, which is what lines are made of; of a corner's polynomials, whose speed goes
    over from one to another without a bump, it is looked for at both ends and between.
    """
    found = max(abs(row[1]), abs(rate(row, length)))
    degree = len(row) - 1
    if degree == 3:
        if row[3] != 0.0 and 0.0 < (at := -row[2] / (3.0 * row[3])) < length:
            found = max(found, abs(rate(row, at)))
    elif degree > 3:
        found = max(found, *(abs(rate(row, length * k / LOOKS)) for k in range(1, LOOKS)))
    return found
