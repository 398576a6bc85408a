"""Joint limits and joint speeds, judged on the polynomials and not at samples."""

import math
from collections.abc import Iterable

from vrts.base.diagnostic import Diagnostic, Label, Moment, Rule, Severity
from vrts.base.units import deg
from vrts.check.verdict import Answer, Verdict
from vrts.engine.records import Motion, Segment
from vrts.engine.run import Run
from vrts.engine.timeline import rate, value
from vrts.ir.instructions import Interpolation

JOINT_SPEED = Rule("V302", "joint-speed")
JOINT_POSITION = Rule("V430", "joint-position")

SPEED_TOLERANCE = 1e-6  # share of the limit; rounding of the polynomials
POSITION_TOLERANCE = math.radians(0.005)  # half of what a measurement is rounded to


def check_limits(run: Run) -> Verdict:
    """Return whether every joint stays within its position and speed limits."""
    arm = run.scene.robot.arm
    worst: dict[int, tuple[float, int, float, float]] = {}  # motion: share, joint, speed, time
    outside: list[Diagnostic] = []
    largest = 0.0
    for segment in run.timeline.segments:
        if segment.motion is None:
            continue
        motion = run.motions[segment.motion]
        for joint, row in enumerate(segment.coefficients[:6]):
            speed, at = _fastest(row, segment.end_s - segment.start_s)
            share = speed / arm.speed[joint]
            largest = max(largest, share)
            if share > 1.0 + SPEED_TOLERANCE and share > worst.get(segment.motion, (0.0,))[0]:
                worst[segment.motion] = (share, joint, speed, segment.start_s + at)
            outside += _outside(run, segment, motion, joint, row)
    findings = [
        *(_too_fast(run, run.motions[k], *found) for k, found in sorted(worst.items())),
        *outside[:1],
    ]
    evidence = {"largest_speed_share": round(largest, 4)}
    if findings:
        return Verdict("limits", Answer.VIOLATED, findings[0].headline, tuple(findings), evidence)
    return Verdict(
        "limits",
        Answer.HOLDS,
        f"every joint stays within its limits; the fastest reaches {largest:.0%}",
        (),
        evidence,
    )


def _too_fast(
    run: Run, motion: Motion, share: float, joint: int, speed: float, time_s: float
) -> Diagnostic:
    limit = run.scene.robot.arm.speed[joint]
    percent = math.floor(100.0 * motion.speed_fraction / share)
    remedy = f"lower SPEED to {percent} or less" if percent >= 1 else "go round the singularity"
    if motion.interpolation is Interpolation.LINEAR:
        remedy += ", or use MOVE instead of MOVES"
    return Diagnostic(
        JOINT_SPEED,
        Severity.ERROR,
        f"joint {joint + 1} exceeds its speed limit on this move",
        Label(
            motion.cause.span, f"needs {deg(speed):.0f} deg/s; the limit is {deg(limit):.0f} deg/s"
        ),
        help=(remedy,),
        moment=_moment(run, time_s),
        data={"joint": joint + 1, "speed_deg_s": deg(speed), "limit_deg_s": deg(limit)},
    )


def _outside(
    run: Run, segment: Segment, motion: Motion, joint: int, row: tuple[float, ...]
) -> Iterable[Diagnostic]:
    arm = run.scene.robot.arm
    lower, upper = arm.lower[joint] - POSITION_TOLERANCE, arm.upper[joint] + POSITION_TOLERANCE
    for t in (0.0, *_turns(row, segment.end_s - segment.start_s), segment.end_s - segment.start_s):
        position = value(row, t)
        if not lower <= position <= upper:
            yield Diagnostic(
                JOINT_POSITION,
                Severity.ERROR,
                f"joint {joint + 1} leaves its range on this move",
                Label(motion.cause.span, f"reaches {deg(position):.1f} degrees"),
                moment=_moment(run, segment.start_s + t),
                data={"joint": joint + 1, "value_deg": deg(position)},
            )
            return


def _moment(run: Run, time_s: float) -> Moment:
    state = run.at(time_s)
    return Moment(time_s, (*state.configuration, state.hand_opening))


def _fastest(row: tuple[float, ...], length: float) -> tuple[float, float]:
    """Return the largest speed of a polynomial of degree at most 3, and when."""
    c = (*row, 0.0, 0.0, 0.0, 0.0)[:4]
    times = [0.0, length]
    if c[3]:
        turn = -c[2] / (3.0 * c[3])
        if 0.0 < turn < length:
            times.append(turn)
    return max((abs(rate(c, t)), t) for t in times)


def _turns(row: tuple[float, ...], length: float) -> list[float]:
    """Return where a polynomial of degree at most 3 turns round."""
    c = (*row, 0.0, 0.0, 0.0, 0.0)[:4]
    a, b, d = 3.0 * c[3], 2.0 * c[2], c[1]
    roots: list[float] = []
    if a == 0.0:
        roots = [-d / b] if b else []
    else:
        disc = b * b - 4.0 * a * d
        if disc >= 0.0:
            s = -0.5 * (b + math.copysign(math.sqrt(disc), b))
            roots = [s / a, *([d / s] if s else [])]
    return [t for t in roots if 0.0 < t < length]
