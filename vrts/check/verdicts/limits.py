"""Joint limits and joint speeds, judged on the polynomials and not at samples.

The evidence tells how near straight lines come to singularities, too.
"""

import math
from collections.abc import Mapping, Sequence
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.beside import beside
from vrts.base.diagnostic import Datum, Diagnostic, Label, Moment, Rule, Severity
from vrts.base.units import deg
from vrts.check.collision.of_run import motion_of
from vrts.check.curves.extremes import first_outside
from vrts.check.curves.timeline_arrays import Curves, lasting_of
from vrts.check.goals.too_fast import Fastest, over_limit, speed_shares
from vrts.check.rounding import exact_deg
from vrts.check.verdict import Answer, Verdict
from vrts.check.verdicts.singularity import measured
from vrts.engine.memory.events import Found
from vrts.engine.memory.records import INSTANT, Motion, Segment
from vrts.engine.motion.remarks import JOINT_SPEED, remedy_for
from vrts.engine.programs.locks import LOCKED_SETTING
from vrts.engine.run import Run
from vrts.ir.instructions import Interpolation
from vrts.robots.kinematics.singular import singular_at

LIMITS = "limits"  # name of the check
JOINT_POSITION = Rule("V430", "joint-position")

POSITION_TOLERANCE = math.radians(0.005)  # half of what a measurement is rounded to


Array: TypeAlias = npt.NDArray[np.float64]


def check_limits(run: Run) -> Verdict:
    """Return whether every joint stays within its limits, and the program moved none of them.

    Also a step that would have moved one, had it not been without effect, is a fault.
    """
    locked = tuple(
        event.diagnostic.headline
        for event in run.events
        if isinstance(event, Found) and event.diagnostic.rule == LOCKED_SETTING
    )
    segments = lasting_of(run.timeline.segments)
    if all(segment.motion is None for segment in segments):
        return _verdict((), 0.0, {}, locked)
    known = motion_of(run)
    bounds = known.pieces
    moving = known.motions >= 0
    shares = speed_shares(run, known)
    findings = [_too_fast(run, found) for found in over_limit(run, segments, known, shares)]
    lower, upper = _range(run)
    out = (bounds.lower[:, :6] < lower) | (bounds.upper[:, :6] > upper)
    out[~moving] = False
    for piece, joint in np.argwhere(out).tolist():
        outside = _outside(run, segments[piece], known, joint)
        if outside is not None:
            findings.append(outside)
            break
    return _verdict(findings, float(shares.max()), measured(run, known), locked)


def _verdict(
    findings: Sequence[Diagnostic],
    largest: float,
    singularities: Mapping[str, float],
    locked: Sequence[str],
) -> Verdict:
    evidence = {"largest_speed_share": round(largest, 4), **singularities}
    if findings or locked:
        summary = findings[0].headline if findings else locked[0]
        return Verdict(LIMITS, Answer.VIOLATED, summary, tuple(findings), evidence)
    return Verdict(
        LIMITS,
        Answer.HOLDS,
        f"every joint stays within its limits; the fastest reaches {largest:.0%}",
        (),
        evidence,
    )


def _too_fast(run: Run, found: Fastest) -> Diagnostic:
    motion, _, share, joint, speed, moment = found
    limit = run.scene.robot.arm.speed[joint]
    needed, allowed = beside(exact_deg(speed), exact_deg(limit), least=0)
    tried = _foretold(run, motion)
    linear = motion.interpolation is Interpolation.LINEAR
    data: dict[str, Datum] = {
        "joint": joint + 1,
        "speed_deg_s": deg(speed),
        "limit_deg_s": deg(limit),
    }
    if tried is None:  # as in runs that an earlier vrts saved
        percent = math.floor(100.0 * motion.speed_fraction / share)
        remedy = f"lower SPEED to {percent} or less" if percent >= 1 else "go another way"
        remedy += ", or use MOVE instead of MOVES" if linear else ""
    else:
        known = tried.data.get("speed_percent")
        after_break = bool(tried.data.get("after_break"))
        percent = known if isinstance(known, int) else None
        stopped = bool(tried.data.get("stopped"))
        remedy = remedy_for(percent, after_break=after_break, linear=linear, stopped=stopped)
        data |= {"speed_percent": percent, "after_break": after_break}
    q = moment.configuration[:6]
    near = singular_at(run.scene.robot.arm, q)  # type: ignore[arg-type]
    where = "a singularity" if near == "singular" else f"the {near} singularity"
    return Diagnostic(
        JOINT_SPEED,
        Severity.ERROR,
        f"joint {joint + 1} exceeds its speed limit on this move",
        Label(motion.cause.span, f"needs {needed} deg/s; the limit is {allowed} deg/s"),
        notes=(f"the arm is near {where} there",) if near is not None else (),
        help=(remedy,),
        moment=moment,
        data=data,
    )


def _foretold(run: Run, motion: Motion) -> Diagnostic | None:
    """Return what the engine said of a motion when it began: it has tried slower ones."""
    for event in run.events:
        if (
            isinstance(event, Found)
            and event.diagnostic.rule == JOINT_SPEED
            and event.cause == motion.cause
            and abs(event.time_s - motion.start_s) < INSTANT
        ):
            return event.diagnostic
    return None


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
