"""A run at many times at once: joints, and pose and velocity of the tool."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.engine.batch import batch_of
from vrts.engine.run import Run
from vrts.robots.built import shown_off
from vrts.robots.kinematics.batch import flange_frames
from vrts.validate.log.log_units import Extent

Array = npt.NDArray[np.float64]

JOINTS = 6
APART_S = 1e-3  # between the two places that give a velocity
SPREAD_S = 0.02  # between instants at which the extent of a run is looked for


class Samples(NamedTuple):
    """The arm at n instants; before the run it stands as at its beginning, then as at its end."""

    joints: Array  # shape (n, 6) [rad]
    rates: Array  # shape (n, 6) [rad/s]
    rotations: Array  # of T in W, shape (n, 3, 3)
    positions: Array  # of T in W, shape (n, 3) [m]
    velocities: Array  # shape (n, 3) [m/s]


class Tools(NamedTuple):
    """Which tool is in force when: those of the motions."""

    starts: Array  # of every motion [s]
    rotations: Array  # of T in F, shape (motions + 1, 3, 3); the first holds before any motion
    origins: Array  # shape (motions + 1, 3) [m]


def tools_of(run: Run) -> Tools:
    """Return the tools of a run."""
    tools = [run.scene.X_FT, *(motion.X_FT for motion in run.motions)]
    if run.motions:
        tools[0] = run.motions[0].X_FT  # the arm has not moved before
    return Tools(
        np.array([motion.start_s for motion in run.motions]),
        np.array([X.rotation for X in tools]).reshape(-1, 3, 3),
        np.array([X.translation for X in tools]),
    )


def tool_poses(run: Run, times: Array, q: Array) -> tuple[Array, Array]:
    """Return T in W of configurations, with the tools in force at run times.

    Args:
        run: The run.
        times: Shape (n,) [s].
        q: Shape (n, 6) [rad].

    Returns:
        Rotations, shape (n, 3, 3), and origins, shape (n, 3) [m].
    """
    rotations, origins = flange_frames(run.scene.robot.arm, q)
    tools = tools_of(run)
    which = np.searchsorted(tools.starts, times, side="right")
    return (
        rotations @ tools.rotations[which],
        origins + np.einsum("nij,nj->ni", rotations, tools.origins[which]),
    )


def commanded(run: Run, shown: Array) -> Array:
    """Return what is commanded where encoders show joints, shape (n, 6) [rad]."""
    return shown - np.array(shown_off(run.scene.robot.arm))


def sampled(run: Run, times: Array) -> Samples:
    """Return a run at times, shape (n,) [s], of which any may lie outside the run."""
    batch = batch_of(run.timeline)
    joints = batch.values(times)[:, :JOINTS]
    rotations, positions = tool_poses(run, times, joints)
    _, before = tool_poses(run, times, batch.values(times - APART_S)[:, :JOINTS])
    _, after = tool_poses(run, times, batch.values(times + APART_S)[:, :JOINTS])
    velocities = (after - before) / (2.0 * APART_S)
    shown = joints + np.array(shown_off(run.scene.robot.arm))
    return Samples(shown, batch.rates(times)[:, :JOINTS], rotations, positions, velocities)


def extent_of(run: Run) -> Extent:
    """Return how far a run goes."""
    start, end = moving(run)
    times = np.arange(start, end + SPREAD_S, SPREAD_S)
    samples = sampled(run, times)
    return Extent(
        end - start,
        float(np.ptp(samples.joints, axis=0).max()),
        float(np.ptp(samples.positions, axis=0).max()),
    )


def moving(run: Run) -> tuple[float, float]:
    """Return when the first motion begins and the last one ends [s]; 0 and 0 without motions."""
    motions = run.motions
    if not motions:
        return 0.0, 0.0
    return motions[0].start_s, min(motions[-1].end_s, run.horizon_s)
