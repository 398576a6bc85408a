"""Does an object stay upright while it is in the hand?"""

import math
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Pose
from vrts.check.curves.certified import Peak, Quantity, peak
from vrts.check.curves.timeline_arrays import Curves
from vrts.check.curves.tool_motion import turning
from vrts.check.task.demands import Demand
from vrts.check.verdicts.demand_values import bound_of
from vrts.engine.memory.records import Lie
from vrts.engine.run import Run
from vrts.robots.kinematics.batch import flange_of, link_frames
from vrts.robots.model import Arm

Array: TypeAlias = npt.NDArray[np.float64]


def largest_tilt(run: Run, motion: Curves, demand: Demand) -> Peak | None:
    """Return when an object is tilted more than a demand allows; None: it is never held."""
    found: Peak | None = None
    for placement in run.placements.get(demand.body, ()):
        if placement.lie is not Lie.HELD:
            continue
        start = np.maximum(motion.starts, placement.start_s)
        end = np.minimum(motion.ends, placement.end_s)
        during = start < end
        angle = tilt(run.scene.robot.arm, placement.X, motion)
        one = peak(angle, start[during], end[during], bound_of(demand))
        found = one if found is None else _both(found, one)
    return found


def tilt(arm: Arm, X_FO: Pose, motion: Curves) -> Quantity:
    """Return the angle [rad] between the z axes of W and of an object fixed to the flange."""
    z_F = np.array(X_FO.approach)

    def angle(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        values = motion.values(middle)
        rotations, origins = link_frames(arm, values[:, :6])
        rotations, _ = flange_of(arm, rotations[6], origins[6])
        z_W = rotations @ z_F
        found = np.arctan2(np.hypot(z_W[:, 0], z_W[:, 1]), z_W[:, 2])
        upper = found + turning(motion, start, middle, end).sum(axis=1)
        return found, np.minimum(upper, math.pi)

    return angle


def _both(a: Peak, b: Peak) -> Peak:
    best = max(a, b, key=lambda each: each.largest)
    return Peak(
        a.above_s if a.above_s is not None else b.above_s,
        a.open_s if a.open_s is not None else b.open_s,
        best.largest,
        best.largest_s,
        a.intervals + b.intervals,
    )
