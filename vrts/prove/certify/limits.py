"""Joints beyond their range or their speed, in motions laid end to end."""

from collections.abc import Iterator, Sequence

import numpy as np

from vrts.check.curves.extremes import fastest, first_outside
from vrts.check.curves.timeline_arrays import Curves
from vrts.check.verdicts.limits import POSITION_TOLERANCE
from vrts.engine.motion.overspeed import SPEED_TOLERANCE
from vrts.engine.motion.polynomials import shifted
from vrts.prove.certify.laying import Entry
from vrts.prove.certify.situation import What
from vrts.prove.certify.stretches import Stretch
from vrts.prove.certify.touching import Beyond
from vrts.robots.model import Arm


def beyond(
    arm: Arm, entries: Sequence[Entry], motion: Curves, order: Sequence[int]
) -> Iterator[Beyond]:
    """Yield where joints are out of their range, and where each is too fast.

    Args:
        arm: The arm.
        entries: What was laid end to end.
        motion: All of it.
        order: Which entry each piece of the motion is.
    """
    bounds, ordered = motion.pieces, [entries[k] for k in order]
    moves = np.array([_concerned(entry) for entry in ordered], dtype=np.bool_)
    rates = np.array([entry.stretch.rate for entry in ordered])
    lower, upper = np.array(arm.lower), np.array(arm.upper)
    out = bounds.lower[:, :6] < lower - POSITION_TOLERANCE
    out |= bounds.upper[:, :6] > upper + POSITION_TOLERANCE
    shares = bounds.speed[:, :6] * rates[:, None] / np.array(arm.speed)
    for place, joint in np.argwhere(out & moves[:, None]).tolist():
        stretch = ordered[place].stretch
        limits = arm.lower[joint], arm.upper[joint]
        at = _outside(stretch, joint, limits)
        if at is not None:
            s, value = at
            limit = limits[0] if value < limits[0] else limits[1]
            time_s = stretch.time(stretch.from_s + s)
            yield Beyond(ordered[place].future, time_s, joint, False, value, limit)
    fast = shares > 1.0 + SPEED_TOLERANCE
    for place, joint in np.argwhere(fast & moves[:, None]).tolist():
        stretch = ordered[place].stretch
        row = shifted(stretch.rows[joint], stretch.from_s)
        speed, at_s = fastest(row, stretch.to_s - stretch.from_s)
        time_s = stretch.time(stretch.from_s + at_s)
        limit = arm.speed[joint]
        yield Beyond(ordered[place].future, time_s, joint, True, speed * stretch.rate, limit)


def _concerned(entry: Entry) -> bool:
    """Return whether the arm moves in an entry as it did not before."""
    return entry.stretch.moves and any(part.what is What.ITSELF for part in entry.parts)


def _outside(
    stretch: Stretch, joint: int, limits: tuple[float, float]
) -> tuple[float, float] | None:
    """Return when a joint first is out of its range, from the start of a stretch, and where."""
    row = shifted(stretch.rows[joint], stretch.from_s)
    lower, upper = limits[0] - POSITION_TOLERANCE, limits[1] + POSITION_TOLERANCE
    return first_outside(row, stretch.to_s - stretch.from_s, lower, upper)
