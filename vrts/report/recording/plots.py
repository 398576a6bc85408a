"""Curves: joints and speeds with their limits, the hand opening, the clearance."""

from collections.abc import Sequence

import numpy as np
import rerun as rr

from vrts.base.units import DEG, MM
from vrts.report.assessment import Assessment
from vrts.report.recording.names import Array, at_times
from vrts.report.recording.static import curves
from vrts.report.recording.thinning import bends

JOINT_NAMES = tuple(f"JT{k}" for k in range(1, 7))
OPENING, SMALLEST, LIMIT = ("opening",), ("smallest distance",), ("limit",)
LIMITS = {"range": 2, "speed": 2, "hand": 1, "clearance": 2}  # how many, as a rule
LIMIT_COLOR = (150, 150, 150)
TOLERANCE = 0.05  # of range and speed, in hundredths of what the limits allow
HAND_TOLERANCE_MM = 0.02


def send_plots(a: Assessment, times: Array, states: Array, rates: Array) -> None:
    """Send curves over time; limits as straight lines.

    Between the rows that are sent the viewer draws straight lines, which are nowhere farther than
    `TOLERANCE` off what the curves are.

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
    shown = bends(times, 100.0 * share, TOLERANCE)
    _curves("joints", times[shown], states[shown, :6] / DEG, JOINT_NAMES)
    _curves("range", times[shown], 100.0 * share[shown], JOINT_NAMES)
    speed = 100.0 * rates[:, :6] / np.array(arm.speed)
    shown = bends(times, speed, TOLERANCE)
    _curves("speed", times[shown], speed[shown], JOINT_NAMES)
    for path in ("range", "speed"):
        _limits(path, ends, (100.0, -100.0))
    opening = states[:, 6:] / MM
    shown = bends(times, opening, HAND_TOLERANCE_MM)
    _curves("hand", times[shown], opening[shown], OPENING)
    _limits("hand", ends, (a.scene.robot.gripper.opening_max / MM,))
    if a.clearance:
        rows = np.array(a.clearance)
        _curves("clearance", rows[:, 0], rows[:, 1:] / MM, SMALLEST)
        report = a.judgement.collisions if a.judgement else None
        threshold = report.near_miss_m if report else None
        _limits("clearance", ends, (0.0,) if threshold is None else (0.0, threshold / MM))


def prepare_plots() -> None:
    """Make what says how the curves are called, which is kept."""
    for path in ("joints", "range", "speed"):
        curves(path, JOINT_NAMES)
    curves("hand", OPENING)
    curves("clearance", SMALLEST)
    for path, count in LIMITS.items():
        curves(f"{path}/limit", LIMIT * count, LIMIT_COLOR)


def _curves(path: str, times: Array, values: Array, names: tuple[str, ...]) -> None:
    rr.send_chunks(curves(path, names))
    _send(path, times, values)


def _limits(path: str, ends: Array, values: Sequence[float]) -> None:
    """Draw levels from the first to the last time."""
    rr.send_chunks(curves(f"{path}/limit", LIMIT * len(values), LIMIT_COLOR))
    _send(f"{path}/limit", ends, np.tile(values, (2, 1)))


def _send(path: str, times: Array, values: Array) -> None:
    columns = rr.Scalars.columns(scalars=values.ravel())
    if values.shape[1] > 1:
        columns = columns.partition(np.full(len(times), values.shape[1]))
    rr.send_columns(path, at_times(times), columns)
