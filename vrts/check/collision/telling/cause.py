"""What was under way at a time: the instruction, and what the hand held."""

import numpy as np

from vrts.check.collision.pairs.arm_state import RunRecord
from vrts.check.curves.timeline_arrays import Curves
from vrts.engine.memory.events import Cause
from vrts.engine.memory.records import Lie


def held_at(run: RunRecord, time_s: float) -> str | None:
    """Return the object between the pads at a time."""
    for body, placements in run.placements.items():
        for placement in placements:
            gripped = placement.lie is Lie.HELD and placement.support is None
            if gripped and placement.start_s <= time_s <= placement.end_s:
                return body
    return None


def cause_at(run: RunRecord, curves: Curves, time_s: float) -> Cause | None:
    """Return the instruction under way; without a motion, the last one that did a thing."""
    motion = int(curves.motions[curves.piece_at(np.array([time_s]))[0]])
    if motion >= 0:
        return run.motions[motion].cause
    cause = None
    for event in run.events:
        if event.time_s > time_s:
            break
        cause = event.cause or cause
    return cause
