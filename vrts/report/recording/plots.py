"""Curves: joints and speeds with their limits, the hand opening, the clearance."""

from collections.abc import Sequence

import numpy as np
import rerun as rr

from vrts.base.units import DEG, MM
from vrts.report.assessment import Assessment
from vrts.report.recording.names import Array, at_times

JOINT_NAMES = [f"JT{k}" for k in range(1, 7)]
LIMIT_COLOR = (150, 150, 150)


def send_plots(a: Assessment, times: Array, states: Array, rates: Array) -> None:
    """Send curves over time; limits as straight lines.

    Args:
        a: With run and scene.
        times: Shape (n,) [s].
        states: Joints [rad] and hand opening [m], shape (n, 7).
        rates: Their derivatives, shape (n, 7).
    """
    assert a.scene is not None
    arm = a.scene.robot.arm
    lower, upper = np.array(arm.lower), np.array(arm.upper)
    share = (2.0 * states[:, :6] - lower - upper) / (upper - lower)
    ends = times[[0, -1]]
    _curves("joints", times, states[:, :6] / DEG, JOINT_NAMES)
    _curves("range", times, 100.0 * share, JOINT_NAMES)
    _curves("speed", times, 100.0 * rates[:, :6] / np.array(arm.speed), JOINT_NAMES)
    for path in ("range", "speed"):
        _limits(path, ends, (100.0, -100.0))
    _curves("hand", times, states[:, 6:] / MM, ["opening"])
    _limits("hand", ends, (a.scene.robot.gripper.opening_max / MM,))
    if a.clearance:
        rows = np.array(a.clearance)
        _curves("clearance", rows[:, 0], rows[:, 1:] / MM, ["smallest distance"])
        report = a.judgement.collisions if a.judgement else None
        threshold = report.near_miss_m if report else None
        _limits("clearance", ends, (0.0,) if threshold is None else (0.0, threshold / MM))


def _curves(path: str, times: Array, values: Array, names: Sequence[str]) -> None:
    rr.log(path, rr.SeriesLines(names=list(names)), static=True)
    _send(path, times, values)


def _limits(path: str, ends: Array, values: Sequence[float]) -> None:
    """Draw levels from the first to the last time."""
    names, colors = ["limit"] * len(values), [LIMIT_COLOR] * len(values)
    rr.log(f"{path}/limit", rr.SeriesLines(names=names, colors=colors), static=True)
    _send(f"{path}/limit", ends, np.tile(values, (2, 1)))


def _send(path: str, times: Array, values: Array) -> None:
    columns = rr.Scalars.columns(scalars=values.ravel())
    if values.shape[1] > 1:
        columns = columns.partition(np.full(len(times), values.shape[1]))
    rr.send_columns(path, at_times(times), columns)
