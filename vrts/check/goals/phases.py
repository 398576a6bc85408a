"""What an object went through before it was in place: was it gripped, was it lifted?"""

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Pose
from vrts.check.collision.of_run import motion_of
from vrts.check.curves.certified import Quantity, peak
from vrts.check.curves.timeline_arrays import Curves, lasting_of
from vrts.check.curves.tool_motion import turning
from vrts.engine.memory.events import Grasped
from vrts.engine.memory.records import Lie
from vrts.engine.run import Run
from vrts.robots.kinematics.batch import flange_of, link_frames
from vrts.robots.kinematics.kinematics import hand_pose
from vrts.robots.kinematics.levers import levers
from vrts.robots.model import Arm

ROUNDING = 5e-6  # [m] half of what lengths are rounded to: 49.995 mm are 50 mm


def was_gripped(run: Run, body: str, until_s: float) -> bool:
    """Return whether the hand took hold of an object up to a time."""
    return any(
        isinstance(event, Grasped) and event.body == body and event.time_s <= until_s
        for event in run.events
    )


def was_lifted(run: Run, body: str, height: float, until_s: float) -> bool:
    """Return whether the hand carried an object up by a height [m] from where it took hold of it.

    Certified on the polynomials; where it cannot be told to 0.01 ms, it was not.
    """
    if not lasting_of(run.timeline.segments):
        return False
    motion = motion_of(run)
    for placement in run.placements.get(body, ()):
        if placement.lie is not Lie.HELD or placement.start_s > until_s:
            continue
        start = np.maximum(motion.starts, placement.start_s)
        end = np.minimum(motion.ends, min(placement.end_s, until_s))
        during = start < end
        X_WF = hand_pose(run.scene.robot.arm, run.at(placement.start_s).configuration)
        least = (X_WF @ placement.X).translation[2] + height - ROUNDING
        rise = _height(run.scene.robot.arm, placement.X, motion)
        if peak(rise, start[during], end[during], least).above_s is not None:
            return True
    return False


def _height(arm: Arm, X_FO: Pose, motion: Curves) -> Quantity:
    """Return the height [m] of an object that is fixed to the flange."""
    point = np.array(X_FO.translation)
    reach = np.array(levers(arm, X_FO.translation))

    def height(
        start: npt.NDArray[np.float64],
        middle: npt.NDArray[np.float64],
        end: npt.NDArray[np.float64],
    ) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        values = motion.values(middle)
        rotations, origins = link_frames(arm, values[:, :6])
        rotations, origins = flange_of(arm, rotations[6], origins[6])
        found: npt.NDArray[np.float64] = origins[:, 2] + rotations[:, 2, :] @ point
        return found, found + turning(motion, start, middle, end) @ reach

    return height
