"""Motions from rest to rest: what a fit looks at, in the run and in a log."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.engine.memory.records import Motion
from vrts.engine.run import Run
from vrts.ir.instructions import Interpolation
from vrts.robots.kinematics.kinematics import forward
from vrts.validate.log.log import RobotLog
from vrts.validate.sampling import commanded, tool_poses

Array = npt.NDArray[np.float64]

LEAST_RAD, LEAST_M = 0.05, 0.02  # a motion that covers less is passed over
EARLY, LATE = 0.4, 0.6  # of a way: between them a motion has its full speed
MARGIN_S = 0.7  # half of it is looked at before a chain and after it, if the arm rests so long
FEWEST = 8  # rows


class Chain(NamedTuple):
    """Motions that follow one another without a stop, all joint motions or all lines."""

    in_joints: bool
    start: Array  # joints [rad] or tool position [m], shape (c,)
    ways: Array  # of each motion, shape (k, c)
    joint_ways: Array  # of each motion, in all joints, shape (k, 6) [rad]
    fractions: tuple[float, ...]  # of full speed
    durations: tuple[float, ...]  # T in the run [s]
    rest_before_s: float  # how long the arm stands still in the run, at most `MARGIN_S`
    rest_after_s: float


class Located(NamedTuple):
    """A chain as a log shows it."""

    chain: Chain
    times: Array  # of the rows, shape (n,) [s]
    values: Array  # in the coordinates that the chain moves, shape (n, c)
    ways: Array  # in the same coordinates, shape (k, c)
    departure_s: float  # about
    durations: tuple[float, ...]  # about


def chains_of(run: Run) -> list[Chain]:
    """Return the chains of a run that a fit can use; mixed ones and turning lines are not."""
    found: list[Chain] = []
    together: list[Motion] = []
    ended_s = -math.inf
    following = [*(motion.start_s for motion in run.motions[1:]), math.inf]
    for motion, next_s in zip(run.motions, following, strict=True):
        together.append(motion)
        if not motion.blended:
            rests = (together[0].start_s - ended_s, next_s - motion.end_s)
            chain = _chain(run, together, rests)
            if chain is not None:
                found.append(chain)
            together, ended_s = [], motion.end_s
    return found


def _chain(run: Run, motions: Sequence[Motion], rests: tuple[float, float]) -> Chain | None:
    kinds = {motion.interpolation for motion in motions}
    if len(kinds) != 1 or any(not m.arrives or m.end_s > run.horizon_s for m in motions):
        return None
    arm = run.scene.robot.arm
    in_joints = kinds == {Interpolation.JOINT}
    joint_ways = np.array([np.subtract(m.goal, m.start) for m in motions])
    if in_joints:
        start, ways, least = np.array(motions[0].start), joint_ways, LEAST_RAD
    else:
        start = np.array((forward(arm, motions[0].start) @ motions[0].X_FT).translation)
        ends = np.array([start, *(m.X_WT.translation for m in motions)])
        ways, least = np.diff(ends, axis=0), LEAST_M
        if any(
            _turns(run, m, float(np.linalg.norm(w))) for m, w in zip(motions, ways, strict=True)
        ):
            return None
    if float(np.linalg.norm(ways, axis=1).min()) < least:
        return None
    return Chain(
        in_joints,
        start,
        ways,
        joint_ways,
        tuple(m.speed_fraction for m in motions),
        _durations(run, motions),
        min(rests[0], MARGIN_S),
        min(rests[1], MARGIN_S),
    )


def _turns(run: Run, motion: Motion, length_m: float) -> bool:
    """Return whether turning the tool, not its way, may decide how long a line takes."""
    arm = run.scene.robot.arm
    R0 = (forward(arm, motion.start) @ motion.X_FT).rotation
    cosine = 0.5 * (sum(a * b for a, b in zip(R0, motion.X_WT.rotation, strict=True)) - 1.0)
    angle = math.acos(min(max(cosine, -1.0), 1.0))
    return 2.0 * angle / arm.angular_speed > length_m / arm.linear_speed


def _durations(run: Run, motions: Sequence[Motion]) -> tuple[float, ...]:
    """Return T of every motion: between the nominal instants at its ends."""
    arm = run.scene.robot.arm
    rise = 0.5 * arm.acceleration_time
    width = 0.5 * (arm.blend_time or 2.0 * arm.acceleration_time)
    arrivals = [m.end_s + width for m in motions[:-1]] + [motions[-1].end_s - rise]
    departures = [motions[0].start_s + rise, *arrivals[:-1]]
    return tuple(b - a for a, b in zip(departures, arrivals, strict=True))


def located(
    run: Run, log: RobotLog, chains: Sequence[Chain], shift_s: float, acceleration_s: float
) -> list[Located]:
    """Return the chains that a log shows, found one after another.

    Speeds may be other than in the run, so what comes later is looked for where it begins after
    what came before; only the first is looked for about its time in the run.

    Args:
        run: The run.
        log: The log.
        chains: Of the run, in time order.
        shift_s: What to add to times of the log to have those of the run [s].
        acceleration_s: From rest to full speed, about: no more is looked at than a chain.
    """
    found: list[Located] = []
    tools = None
    if log.joints is not None and log.positions is None:
        _, tools = tool_poses(run, log.times + shift_s, commanded(run, log.joints))
    points = log.positions if log.positions is not None else tools
    begin = 0
    for chain in chains:
        values = log.joints if chain.in_joints else points
        if values is None:
            continue
        one = _located(log.times[begin:], values[begin:], chain, acceleration_s)
        if one is not None:
            found.append(one)
            end_s = one.departure_s + sum(one.durations)
            begin = int(np.searchsorted(log.times, end_s))
    return found


def _located(times: Array, values: Array, chain: Chain, acceleration_s: float) -> Located | None:
    known = np.isfinite(values).all(axis=1)
    times, values = times[known], values[known]
    passed: list[tuple[float, float]] = []  # early and late on every way
    corner, after = chain.start, 0
    for way in chain.ways:
        share = (values - corner) @ way / float(way @ way)
        off = np.linalg.norm(values - corner - np.clip(share, 0, 1)[:, None] * way, axis=1)
        near = off < 0.5 * float(np.linalg.norm(way))
        early = _first_passage(times, share, near, EARLY, after)
        late = None if early is None else _first_passage(times, share, near, LATE, early[1])
        if early is None or late is None:
            return None
        passed.append((early[0], late[0]))
        corner, after = corner + way, late[1]
    durations = tuple((b - a) / (LATE - EARLY) for a, b in passed)
    departure = passed[0][0] - EARLY * durations[0]
    end = passed[-1][1] + (1.0 - LATE) * durations[-1]
    moving = np.abs(chain.ways).max(axis=0) > 1e-9
    begin_s = departure - 0.5 * (acceleration_s + chain.rest_before_s)
    end_s = end + 0.5 * (acceleration_s + chain.rest_after_s)
    first, last = np.searchsorted(times, [begin_s, end_s])
    if last - first < FEWEST:
        return None
    return Located(
        chain,
        times[first:last],
        values[first:last][:, moving],
        chain.ways[:, moving],
        departure,
        durations,
    )


def _first_passage(
    times: Array, share: Array, near: npt.NDArray[np.bool_], level: float, after: int
) -> tuple[float, int] | None:
    """Return when a share of a way is passed upward first, from a row on, and the row before."""
    s = share[after:]
    upward = np.flatnonzero((s[:-1] < level) & (s[1:] >= level) & near[after:][1:])
    if not len(upward):
        return None
    k = after + int(upward[0])
    part = (level - share[k]) / (share[k + 1] - share[k])
    return float(times[k] + part * (times[k + 1] - times[k])), k
