"""Joint limits and joint speeds, judged on the polynomials and not at samples.

The evidence tells how near straight lines come to singularities, too.
"""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.diagnostic import Diagnostic, Label, Moment, Rule, Severity
from vrts.base.units import deg
from vrts.check.collision.of_run import motion_of
from vrts.check.curves.extremes import fastest, first_outside
from vrts.check.curves.timeline_arrays import Curves, lasting_of
from vrts.check.verdict import Answer, Verdict
from vrts.check.verdicts.singularity import measured
from vrts.engine.memory.records import Motion, Segment
from vrts.engine.run import Run
from vrts.ir.instructions import Interpolation
from vrts.robots.kinematics.singular import singular_at

JOINT_SPEED = Rule("V302", "joint-speed")
JOINT_POSITION = Rule("V430", "joint-position")

SPEED_TOLERANCE = 1e-6  # share of the limit; rounding of the polynomials
POSITION_TOLERANCE = math.radians(0.005)  # half of what a measurement is rounded to


Array: TypeAlias = npt.NDArray[np.float64]


class _Fastest(NamedTuple):
    """The largest share of its speed limit that a joint reaches on a motion."""

    motion: Motion
    share: float
    joint: int  # from 0
    speed: float  # [rad/s]
    moment: Moment


def check_limits(run: Run) -> Verdict:
    """Return whether every joint stays within its position and speed limits."""
    segments = lasting_of(run.timeline.segments)
    if all(segment.motion is None for segment in segments):
        return _verdict((), 0.0, {})
    known = motion_of(run)
    bounds = known.pieces
    moving = known.motions >= 0
    shares: Array = bounds.speed[:, :6] / np.array(run.scene.robot.arm.speed)
    shares[~moving] = 0.0
    findings = [_too_fast(run, found) for found in _over(run, segments, known, shares)]
    lower, upper = _range(run)
    out = (bounds.lower[:, :6] < lower) | (bounds.upper[:, :6] > upper)
    out[~moving] = False
    for piece, joint in np.argwhere(out).tolist():
        outside = _outside(run, segments[piece], known, joint)
        if outside is not None:
            findings.append(outside)
            break
    return _verdict(findings, float(shares.max()), measured(run, known))


def _verdict(
    findings: Sequence[Diagnostic], largest: float, singularities: Mapping[str, float]
) -> Verdict:
    evidence = {"largest_speed_share": round(largest, 4), **singularities}
    if findings:
        return Verdict("limits", Answer.VIOLATED, findings[0].headline, tuple(findings), evidence)
    return Verdict(
        "limits",
        Answer.HOLDS,
        f"every joint stays within its limits; the fastest reaches {largest:.0%}",
        (),
        evidence,
    )


def _over(run: Run, segments: Sequence[Segment], known: Curves, shares: Array) -> list[_Fastest]:
    """Return of every motion with a joint above its limit the one most above."""
    too_fast = (shares > 1.0 + SPEED_TOLERANCE).any(axis=1)
    found: list[_Fastest] = []
    for motion in np.unique(known.motions[too_fast]).tolist():
        own = np.nonzero(known.motions == motion)[0]
        best, joint = divmod(int(np.argmax(shares[own])), 6)
        segment = segments[int(own[best])]
        speed, at = fastest(segment.coefficients[joint], segment.end_s - segment.start_s)
        share = speed / run.scene.robot.arm.speed[joint]
        moment = _moment(known, segment.start_s + at)
        found.append(_Fastest(run.motions[motion], share, joint, speed, moment))
    return found


def _too_fast(run: Run, found: _Fastest) -> Diagnostic:
    motion, share, joint, speed, moment = found
    limit = run.scene.robot.arm.speed[joint]
    percent = math.floor(100.0 * motion.speed_fraction / share)
    remedy = f"lower SPEED to {percent} or less" if percent >= 1 else "go round the singularity"
    if motion.interpolation is Interpolation.LINEAR:  # whose set points fall elsewhere when slower
        remedy = remedy.replace(" or less", ", or still less")
        remedy += ", or use MOVE instead of MOVES"
    q = moment.configuration[:6]
    near = singular_at(run.scene.robot.arm, q)  # type: ignore[arg-type]
    where = "a singularity" if near == "singular" else f"the {near} singularity"
    return Diagnostic(
        JOINT_SPEED,
        Severity.ERROR,
        f"joint {joint + 1} exceeds its speed limit on this move",
        Label(
            motion.cause.span, f"needs {deg(speed):.0f} deg/s; the limit is {deg(limit):.0f} deg/s"
        ),
        notes=(f"the arm is near {where} there",) if near is not None else (),
        help=(remedy,),
        moment=moment,
        data={"joint": joint + 1, "speed_deg_s": deg(speed), "limit_deg_s": deg(limit)},
    )


def _range(run: Run) -> tuple[Array, Array]:
    """Return the least and the largest positions that count as within limits, both (6,) [rad]."""
    arm = run.scene.robot.arm
    return np.array(arm.lower) - POSITION_TOLERANCE, np.array(arm.upper) + POSITION_TOLERANCE


def _outside(run: Run, segment: Segment, known: Curves, joint: int) -> Diagnostic | None:
    assert segment.motion is not None
    lower, upper = _range(run)
    row, length = segment.coefficients[joint], segment.end_s - segment.start_s
    found = first_outside(row, length, float(lower[joint]), float(upper[joint]))
    if found is None:  # the bounds of pieces are wider by rounding
        return None
    at, position = found
    return Diagnostic(
        JOINT_POSITION,
        Severity.ERROR,
        f"joint {joint + 1} leaves its range on this move",
        Label(run.motions[segment.motion].cause.span, f"reaches {deg(position):.1f} degrees"),
        moment=_moment(known, segment.start_s + at),
        data={"joint": joint + 1, "value_deg": deg(position)},
    )


def _moment(known: Curves, time_s: float) -> Moment:
    coordinates: list[float] = known.values(np.array([time_s]))[0].tolist()
    return Moment(time_s, tuple(coordinates))
