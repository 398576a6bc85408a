"""What a real robot is displaced by: its clock, its base and its tool, fitted to a log.

The model: the tool is at X_WB' (p + R d), with p and R the tool in the run at the shifted time, d
the error of the tool in its own frame T, and X_WB' the small displacement of the base. Found by
Gauss-Newton steps with exact derivatives.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.base.diagnostic import Diagnostic, Rule, warning
from vrts.engine.run import Run
from vrts.validate.log.log import RobotLog
from vrts.validate.sampling import sampled

LOG_OFFSETS = Rule("V892", "log-offsets")

Array = npt.NDArray[np.float64]

STEPS = 25  # of Gauss and Newton, at most
CLOSE = 1e-10  # a step shorter than this is the last
LEVER_M = 0.5  # a turn counts by what it does so far from the origin
WEAKEST = 1e-3  # of the strongest direction: what a path tells less about is left as it is
LONGEST_STEP_S = 0.2  # by which the clock is moved at once

NOTHING: tuple[float, float, float] = (0.0, 0.0, 0.0)


class Wanted(NamedTuple):
    """What is to be fitted."""

    time: bool = True
    base: bool = False
    tool: bool = False


class Offsets(NamedTuple):
    """Displacements of the real robot, and how sure they are (one standard deviation)."""

    time_s: float = 0.0  # added to the times of the log
    base_m: tuple[float, float, float] = NOTHING  # of the real base in W
    base_rad: tuple[float, float, float] = NOTHING  # turn about axes of W, as a rotation vector
    tool_m: tuple[float, float, float] = NOTHING  # of the real tool in T
    sigma: tuple[float, ...] = (0.0,) * 10  # of the ten numbers above


class Fitted(NamedTuple):
    """Offsets and what is to be said about them."""

    offsets: Offsets
    findings: tuple[Diagnostic, ...]


def fit_offsets(run: Run, log: RobotLog, shift_s: float, wanted: Wanted) -> Fitted:
    """Return the offsets with which a run comes closest to a log.

    Args:
        run: The run.
        log: The log.
        shift_s: What to add to times of the log, to begin with [s].
        wanted: What to fit; base and tool need logged positions of the tool.
    """
    told: list[Diagnostic] = []
    time_s, sigma_s = shift_s, 0.0
    if wanted.time and log.joints is not None:
        time_s, sigma_s = _fit_time(run, log, shift_s)
    offsets = Offsets(time_s, sigma=(sigma_s, *(0.0,) * 9))
    if log.positions is None:
        if wanted.base or wanted.tool:
            told.append(
                _undetermined(
                    "base and tool cannot be found from joints alone",
                    "the log has no position of the tool",
                )
            )
        return Fitted(offsets, tuple(told))
    free = np.array(
        [wanted.time and log.joints is None, *[wanted.base] * 6, *[wanted.tool] * 3], bool
    )
    if not free.any():
        return Fitted(offsets, tuple(told))
    return _fit_all(run, log, offsets, free, told)


def predicted(run: Run, times: Array, offsets: Offsets) -> Array:
    """Return where a displaced robot would have its tool in W, shape (n, 3) [m]."""
    samples = sampled(run, times)
    R = turned(np.array(offsets.base_rad))
    points = samples.positions + samples.rotations @ np.array(offsets.tool_m)
    return points @ R.T + np.array(offsets.base_m)


def _fit_time(run: Run, log: RobotLog, shift_s: float) -> tuple[float, float]:
    """Return the shift with which joints fit best, and its standard deviation [s]."""
    assert log.joints is not None
    known = np.isfinite(log.joints).all(axis=1)
    times, joints = log.times[known], log.joints[known]
    shift, sigma = shift_s, 0.0
    for _ in range(STEPS):
        samples = sampled(run, times + shift)
        error, rates = joints - samples.joints, samples.rates
        weight = float((rates * rates).sum())
        if weight == 0.0:
            break
        step = float((rates * error).sum()) / weight
        step = float(np.clip(step, -LONGEST_STEP_S, LONGEST_STEP_S))
        sigma = float(np.sqrt((error**2).mean() / weight))
        shift += step
        if abs(step) < CLOSE:
            break
    return shift, sigma


def _fit_all(
    run: Run,
    log: RobotLog,
    begun: Offsets,
    free: npt.NDArray[np.bool_],
    told: list[Diagnostic],
) -> Fitted:
    assert log.positions is not None
    known = np.isfinite(log.positions).all(axis=1)
    times, positions = log.times[known], log.positions[known]
    units = np.array([1.0, *[1.0] * 3, *[1.0 / LEVER_M] * 3, *[1.0] * 3])[free]
    turn, base, tool, time_s = np.eye(3), np.zeros(3), np.zeros(3), begun.time_s
    sigma = np.zeros(10)
    sigma[0] = begun.sigma[0]
    weak = False
    for _ in range(STEPS):
        samples = sampled(run, times + time_s)
        inner = (samples.positions + samples.rotations @ tool) @ turn.T
        error = positions - (inner + base)
        columns = _derivatives(samples.velocities @ turn.T, inner + base, turn @ samples.rotations)
        jacobian = columns[:, :, free].reshape(-1, int(free.sum())) * units
        u, strengths, vt = np.linalg.svd(jacobian, full_matrices=False)
        told_of = strengths > WEAKEST * strengths[0]
        weak = not bool(told_of.all())
        inverse = np.where(told_of, 1.0 / np.where(told_of, strengths, 1.0), 0.0)
        step = np.zeros(10)
        step[free] = units * (vt.T @ (inverse * (u.T @ error.ravel())))
        step[0] = np.clip(step[0], -LONGEST_STEP_S, LONGEST_STEP_S)
        spread = ((vt.T * inverse) ** 2).sum(axis=1)
        sigma[free] = units * np.sqrt(spread * (error**2).mean())
        time_s += step[0]
        further = turned(step[4:7])
        base = further @ base + step[1:4]
        turn, tool = further @ turn, tool + step[7:10]
        if float(np.abs(step).max()) < CLOSE:
            break
    if weak:
        both = free[1] and free[7]
        told.append(
            _undetermined(
                "the path does not tell all that was to be fitted",
                "the tool keeps its direction, so that an error of the tool looks like one of the"
                " base; what cannot be told apart is shared out"
                if both
                else "the path is too short or too straight to tell every turn of the base",
            )
        )
    offsets = Offsets(
        float(time_s),
        _three(base),
        _three(rotation_vector(turn)),
        _three(tool),
        tuple(float(value) for value in sigma),
    )
    return Fitted(offsets, tuple(told))


def _derivatives(velocities: Array, points: Array, rotations: Array) -> Array:
    """Return how points move with time, base, turn of the base and tool, shape (n, 3, 10)."""
    found = np.zeros((len(points), 3, 10))
    found[:, :, 0] = velocities
    found[:, :, 1:4] = np.eye(3)
    x, y, z = points.T
    found[:, 1, 4], found[:, 2, 4] = -z, y
    found[:, 0, 5], found[:, 2, 5] = z, -x
    found[:, 0, 6], found[:, 1, 6] = -y, x
    found[:, :, 7:10] = rotations
    return found


def turned(vector: Array) -> Array:
    """Return the rotation of a rotation vector [rad], by Rodrigues' formula [Rodrigues]_."""
    angle = float(np.linalg.norm(vector))
    if angle < 1e-15:
        return np.eye(3)
    x, y, z = vector / angle
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * (K @ K)


def rotation_vector(R: Array) -> Array:
    """Return the rotation vector of a rotation by less than half a turn [rad]."""
    axis = 0.5 * np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    sine = float(np.linalg.norm(axis))
    angle = float(np.arctan2(sine, 0.5 * (np.trace(R) - 1.0)))
    return axis if sine < 1e-12 else axis * (angle / sine)


def _three(values: Array) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in values)
    return x, y, z


def _undetermined(headline: str, why: str) -> Diagnostic:
    return warning(
        LOG_OFFSETS,
        headline,
        notes=(why,),
        help=("fit less at once, or log a program in which the tool turns about several axes",),
    )
