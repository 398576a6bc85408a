"""What a motion does that its programmer should know, although it can be carried out."""

import math
from collections.abc import Iterable
from enum import Enum
from typing import NamedTuple, TypeAlias

from vrts.base.diagnostic import Datum, Diagnostic, Label, Rule, Severity
from vrts.base.source import Span
from vrts.base.units import deg
from vrts.engine.motion.lines.path import LinePath
from vrts.engine.motion.lines.set_points import SetPoints

JOINT_SPEED = Rule("V302", "joint-speed")
NEAR_SINGULARITY = Rule("V331", "near-singularity")
WRIST_CROSSES = Rule("V332", "wrist-crosses")
HALF_TURN = Rule("V333", "half-turn")

AMBIGUOUS = math.radians(179.5)  # a turn beyond may as well go the other way round [assumed]


class Remark(Enum):
    """What is remarkable about a line."""

    NEAR_WRIST = "wrist"
    NEAR_ELBOW = "elbow"
    NEAR_SHOULDER = "shoulder"
    NEAR_SINGULAR = "singular"  # of an arm without a spherical wrist
    WRIST_CROSSES = "crosses"
    HALF_TURN = "half turn"


class Overspeed(NamedTuple):
    """A joint that is asked for more speed than it has, and what would do."""

    joint: int  # from 1
    speed: float  # [rad/s]
    limit: float  # [rad/s]
    percent: int | None  # the SPEED that would do; None: none does, or none was tried
    after_break: bool = False  # it does only if the motion before is ended by BREAK
    linear: bool = True
    stopped: bool = False  # something else stops the motion on its way


Told: TypeAlias = Remark | Overspeed
"""What is told of a motion."""


def remarks_on(path: LinePath, points: SetPoints) -> tuple[Remark, ...]:
    """Return what is remarkable about a line that was followed."""
    found: list[Remark] = []
    if points.crossed_wrist:
        found.append(Remark.WRIST_CROSSES)
    elif points.near is not None:
        found.append(Remark(points.near))
    if path.turned > AMBIGUOUS:
        found.append(Remark.HALF_TURN)
    return tuple(found)


def worded(remark: Told, span: Span) -> Diagnostic:
    """Return a remark as a diagnostic."""
    if isinstance(remark, Overspeed):
        return _too_fast(remark, span)
    if remark is Remark.WRIST_CROSSES:
        return Diagnostic(
            WRIST_CROSSES,
            Severity.NOTE,
            "joint 5 passes through zero on this straight line",
            Label(span, "the wrist goes from FLIP to NOFLIP or back"),
            notes=("the wrist is singular there: a little to the side joint 4 would turn fast",),
        )
    if remark is Remark.HALF_TURN:
        return Diagnostic(
            HALF_TURN,
            Severity.WARNING,
            "this straight line turns the hand by half a turn",
            Label(span, "either way round is as short"),
            help=("give a location in between that says which way the hand turns",),
        )
    where = "a singularity" if remark is Remark.NEAR_SINGULAR else f"the {remark.value} singularity"
    return Diagnostic(
        NEAR_SINGULARITY,
        Severity.WARNING,
        f"this straight line passes near {where}",
        Label(span, WHY[remark]),
        notes=("a location a little to the side may need joint speeds that the arm does not have",),
        help=("choose other locations, or use MOVE instead of MOVES",),
    )


def without_forecasts(found: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """Return what a run found, without joint speeds: that is foretold when a motion begins.

    Checks of the whole run say what came of it.
    """
    return tuple(d for d in found if d.rule != JOINT_SPEED)


def remedy_for(
    percent: int | None, *, after_break: bool, linear: bool, stopped: bool = False
) -> str:
    """Return what to do about a joint that is too fast.

    Args:
        percent: The SPEED that would do, as it was tried; None: none does, or none was tried.
        after_break: It does if the motion before is ended by BREAK.
        linear: Whether it is a straight line.
        stopped: Something else stops it on its way, at whatever SPEED.
    """
    if stopped:
        first = "first look at what stops this motion"
        return first if percent is None else f"{first}; up to there SPEED {percent} would do"
    if percent is None:
        return "lower SPEED, or use MOVE instead of MOVES" if linear else "lower SPEED"
    before = "a BREAK before it and " if after_break else ""
    instead = ", or use MOVE instead of MOVES" if linear else ""
    return f"{before}SPEED {percent} would do{instead}"


def _too_fast(found: Overspeed, span: Span) -> Diagnostic:
    data: dict[str, Datum] = {
        "joint": found.joint,
        "speed_deg_s": deg(found.speed),
        "limit_deg_s": deg(found.limit),
    }
    if found.percent is not None:
        data["speed_percent"] = found.percent
        data["after_break"] = found.after_break
    if found.stopped:
        data["stopped"] = True
    remedy = remedy_for(
        found.percent, after_break=found.after_break, linear=found.linear, stopped=found.stopped
    )
    return Diagnostic(
        JOINT_SPEED,
        Severity.WARNING,
        f"joint {found.joint} exceeds its speed limit on this move",
        Label(
            span,
            f"needs {deg(found.speed):.0f} deg/s; the limit is {deg(found.limit):.0f} deg/s",
        ),
        help=(remedy,),
        data=data,
    )


WHY = {
    Remark.NEAR_WRIST: "joint 5 is within a degree of zero",
    Remark.NEAR_ELBOW: "the elbow is within a degree of straight",
    Remark.NEAR_SHOULDER: "the wrist is within 10 mm of the axis of joint 1",
    Remark.NEAR_SINGULAR: "the arm can hardly move in some direction",
}
