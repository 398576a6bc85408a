"""Where the tool of a run is at many times at once."""

from bisect import bisect_right

import numpy as np
import numpy.typing as npt

from vrts.base.oat import VERTICAL_TOLERANCE
from vrts.base.pose import Pose
from vrts.base.units import DEG
from vrts.engine.run import Run
from vrts.robots.kinematics.batch import flange_frames

Array = npt.NDArray[np.float64]


def tool_frames(run: Run, times: Array, q: Array) -> tuple[Array, Array]:
    """Return the tool in W, as `State.X_WT` has it.

    Args:
        run: In which the tool moves.
        times: Within the run, shape (m,) [s].
        q: The joints then, shape (m, 6) [rad].

    Returns:
        Rotations, shape (m, 3, 3), and origins, shape (m, 3) [m].
    """
    rotations, origins = flange_frames(run.scene.robot.arm, q)
    tools: dict[Pose, int] = {}
    which = np.array([tools.setdefault(_tool_at(run, t), len(tools)) for t in times.tolist()], int)
    turns = np.array([X.rotation for X in tools]).reshape(-1, 3, 3)[which]
    moves = np.array([X.translation for X in tools]).reshape(-1, 3)[which]
    return rotations @ turns, origins + np.einsum("mij,mj->mi", rotations, moves)


def _tool_at(run: Run, time_s: float) -> Pose:
    motions = run.motions
    found = bisect_right(motions, time_s, key=lambda motion: motion.start_s)
    if found and time_s <= motions[found - 1].end_s:
        return motions[found - 1].X_FT
    return run.at(time_s).X_FT


def oat_deg(rotations: Array) -> Array:
    """Return O A T in degrees, shape (m, 3), of rotations, shape (m, 3, 3), as `base.oat` has."""
    r = rotations
    level = np.hypot(r[:, 0, 2], r[:, 1, 2])
    vertical = level < VERTICAL_TOLERANCE
    o = np.where(
        vertical,
        np.arctan2(r[:, 1, 1], r[:, 0, 1]),
        np.arctan2(r[:, 0, 2], -r[:, 1, 2]),
    )
    a = np.arctan2(-r[:, 2, 2], level)
    t = np.where(vertical, 0.0, np.arctan2(r[:, 2, 1], -r[:, 2, 0]))
    return np.column_stack((o, a, t)) / DEG
