"""What a straight line does that its programmer should know, although it can be followed."""

import math
from enum import Enum

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.base.source import Span
from vrts.engine.motion.paths import LinePath
from vrts.engine.motion.set_points import SetPoints

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


def worded(remark: Remark, span: Span) -> Diagnostic:
    """Return a remark as a diagnostic."""
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


WHY = {
    Remark.NEAR_WRIST: "joint 5 is within a degree of zero",
    Remark.NEAR_ELBOW: "the elbow is within a degree of straight",
    Remark.NEAR_SHOULDER: "the wrist is within 10 mm of the axis of joint 1",
    Remark.NEAR_SINGULAR: "the arm can hardly move in some direction",
}
