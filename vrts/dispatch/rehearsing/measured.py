"""How far LinuxCNC's motion is from the run's, from each stop of the arm to the next."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.base.units import DEG, MM
from vrts.dispatch.linuxcnc.sheet import (
    DURATION_S,
    EQUAL_MM,
    PATH_MM,
    ROUND_DURATION_S,
    ROUND_EQUAL_MM,
    ROUND_PATH_MM,
)
from vrts.dispatch.rehearsing.samples import STEP_S, Samples
from vrts.engine.batch import batch_of
from vrts.engine.memory.records import Motion
from vrts.engine.run import Run
from vrts.ir.instructions import Interpolation
from vrts.robots.kinematics.batch import flange_frames

Array = npt.NDArray[np.float64]

FINE_S = 0.5e-3  # between points of the run's path
NEAR = 24  # points before and after, among which the nearest is looked for
ENDS = (0.01, 0.99)  # of the way: between them durations are compared
NO_TURN = 1e-5  # [rad] of the hand along a line


class Stretch(NamedTuple):
    """A motion from rest to rest, or several with rounded corners between."""

    first: int  # motion, from 1
    last: int
    line: str  # program and step of the first
    rounded: bool  # or a line that turns the hand
    path_mm: float  # farthest from the run's path
    equal_mm: float  # farthest apart at equal times
    end_mm: float
    joints_deg: float  # of a joint at equal times
    longer_s: float  # by which LinuxCNC takes longer
    begins_s: float  # in LinuxCNC's time, from its first sample
    missing: bool = False  # LinuxCNC made no such motion

    @property
    def holds(self) -> bool:
        """Whether it is as near as the sheet claims."""
        path, equal, longer = (
            (ROUND_PATH_MM, ROUND_EQUAL_MM, ROUND_DURATION_S)
            if self.rounded
            else (PATH_MM, EQUAL_MM, DURATION_S)
        )
        return (
            not self.missing
            and self.path_mm <= path
            and self.equal_mm <= equal
            and self.end_mm <= PATH_MM
            and abs(self.longer_s) <= longer
        )


def measured(run: Run, samples: Samples) -> tuple[Stretch, ...]:
    """Return all stretches of a run in which anything moves, beside what LinuxCNC did."""
    motions, moving = run.motions, samples.moving
    found: list[Stretch] = []
    first = 0
    while first < len(motions):
        last = first
        while motions[last].blended:
            last += 1
        if motions[last].end_s > motions[first].start_s:
            chosen = (samples.motions > first) & (samples.motions <= last + 1) & moving
            found.append(_stretch(run, samples, np.flatnonzero(chosen), (first, last)))
        first = last + 1
    return tuple(found)


class Course(NamedTuple):
    """How far LinuxCNC is from the run while a stretch lasts, each millisecond."""

    stretch: Stretch
    times: Array  # of the run, shape (n,) [s]
    joints: Array  # LinuxCNC's minus the run's at equal times, shape (n, 6) [rad]
    equal: Array  # of the tip from where it is at equal times, shape (n,) [m]
    path: Array  # of the tip from the run's path, shape (n,) [m]


def courses(run: Run, samples: Samples, stretches: tuple[Stretch, ...]) -> tuple[Course, ...]:
    """Return the course of every stretch that LinuxCNC made."""
    moving = samples.moving
    found: list[Course] = []
    for one in stretches:
        if not one.missing:
            chosen = (samples.motions >= one.first) & (samples.motions <= one.last) & moving
            beside = _beside_run(
                run, samples, np.flatnonzero(chosen), (one.first - 1, one.last - 1)
            )
            found.append(Course(one, beside.times, beside.joints, beside.equal, beside.path))
    return tuple(found)


def extra(run: Run, samples: Samples) -> int:
    """Return how many motions LinuxCNC made beyond those of the run."""
    highest = int(samples.motions.max()) if len(samples.motions) else 0
    return max(highest - len(run.motions), 0)


def _stretch(
    run: Run, samples: Samples, at: npt.NDArray[np.intp], motions: tuple[int, int]
) -> Stretch:
    first = run.motions[motions[0]]
    rounded = motions[0] != motions[1] or _turns(run, first)
    line = f"{first.cause.program} {first.cause.step}"
    named = (motions[0] + 1, motions[1] + 1, line, rounded)
    if not len(at):
        far = float("inf")
        return Stretch(*named, far, far, far, far, far, 0.0, missing=True)
    found = _beside_run(run, samples, at, motions)
    return Stretch(
        *named,
        path_mm=float(found.path.max()) / MM,
        equal_mm=float(found.equal.max()) / MM,
        end_mm=found.end / MM,
        joints_deg=float(np.abs(found.joints).max()) / DEG,
        longer_s=found.longer_s,
        begins_s=STEP_S * found.begun,
    )


class _Beside(NamedTuple):
    times: Array  # of the run [s]
    joints: Array  # at equal times [rad]
    equal: Array  # [m]
    path: Array  # [m]
    end: float  # [m]
    longer_s: float
    begun: int  # sample


def _beside_run(
    run: Run, samples: Samples, at: npt.NDArray[np.intp], motions: tuple[int, int]
) -> _Beside:
    first, last = run.motions[motions[0]], run.motions[motions[1]]
    begun, ended = int(at[0]) - 1, int(at[-1])
    theirs = samples.joints[begun : ended + 1]
    their_times = STEP_S * np.arange(len(theirs), dtype=np.float64)
    duration = last.end_s - first.start_s
    count = round(duration / FINE_S)
    times = (duration / count) * np.arange(count + 1, dtype=np.float64)
    batch = batch_of(run.timeline)
    ours = batch.values(first.start_s + times)[:, :6]
    spans = [_passed(theirs, their_times), _passed(ours, times)]
    shift = float(spans[1].mean() - spans[0].mean())
    then = np.clip(their_times + shift, 0.0, duration)
    beside = batch.values(first.start_s + then)[:, :6]
    path = _tips(run, first, ours)
    tips = _tips(run, first, theirs)
    return _Beside(
        first.start_s + then,
        theirs - beside,
        np.linalg.norm(tips - _tips(run, first, beside), axis=1),
        _from_path(tips, path, _beside(theirs, ours)),
        float(np.linalg.norm(tips[-1] - path[-1])),
        float(np.ptp(spans[0]) - np.ptp(spans[1])),
        begun,
    )


def _way(joints: Array) -> Array:
    """Return how far the joints have gone at each instant [rad]."""
    steps = np.linalg.norm(np.diff(joints, axis=0), axis=1)
    way: Array = np.zeros(len(joints))
    way[1:] = np.cumsum(steps)
    return way


def _passed(joints: Array, times: Array) -> Array:
    """Return when the joints have gone the shares `ENDS` of their way."""
    way = _way(joints)
    return np.array([_when(share * float(way[-1]), way, times) for share in ENDS])


def _beside(theirs: Array, ours: Array) -> npt.NDArray[np.intp]:
    """Return which of our points has gone the same share of the way, for each of theirs."""
    way, own = _way(theirs), _way(ours)
    share = float(own[-1]) / max(float(way[-1]), 1e-30)
    return np.asarray(np.searchsorted(own, way * share), np.intp)


def _when(wanted: float, way: Array, times: Array) -> float:
    """Return when a way that grows comes to a length, on straight lines between its points."""
    k = min(max(int(np.searchsorted(way, wanted)), 1), len(way) - 1)
    gone = (wanted - way[k - 1]) / max(way[k] - way[k - 1], 1e-30)
    return float(times[k - 1] + gone * (times[k] - times[k - 1]))


def _tips(run: Run, motion: Motion, joints: Array) -> Array:
    """Return the tip of the tool in force, shape (n, 3) [m]."""
    rotations, origins = flange_frames(run.scene.robot.arm, joints)
    tips: Array = origins + rotations @ np.array(motion.X_FT.translation)
    return tips


def _from_path(tips: Array, path: Array, near: npt.NDArray[np.intp]) -> Array:
    """Return the distances of tips from a path of which the nearest points are known."""
    if len(path) < 2:
        return np.asarray(np.linalg.norm(tips - path[0], axis=1), np.float64)
    window = near[:, None] + np.arange(-NEAR, NEAR + 1)
    window = np.clip(window, 0, len(path) - 2)
    starts, steps = path[window], path[window + 1] - path[window]
    lengths = np.maximum((steps**2).sum(axis=2), 1e-30)
    shares = ((tips[:, None] - starts) * steps).sum(axis=2) / lengths
    feet = starts + np.clip(shares, 0.0, 1.0)[:, :, None] * steps
    return np.asarray(np.sqrt(((feet - tips[:, None]) ** 2).sum(axis=2).min(axis=1)), np.float64)


def _turns(run: Run, motion: Motion) -> bool:
    if motion.interpolation is not Interpolation.LINEAR:
        return False
    ends = np.array([motion.start, motion.goal])
    rotations, _ = flange_frames(run.scene.robot.arm, ends)
    return float(np.abs(rotations[1] - rotations[0]).max()) > NO_TURN
