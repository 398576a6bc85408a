"""A motion joined to the one under way: on the timeline already, and still to be taken back."""

from collections.abc import Callable
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.controllers.model import NoLength
from vrts.engine.memory.records import INSTANT
from vrts.engine.motion.corner import Corner, Leg, fits, half_width, round_corner
from vrts.engine.motion.given import CutOff, Given
from vrts.engine.motion.lines.set_points import Piece
from vrts.engine.motion.plan import Intent
from vrts.robots.model import Arm


class Pending(NamedTuple):
    """Such a motion, and what it stands in for."""

    start_s: float  # in path time
    corner: Corner
    target: Pose | None  # X_VT
    intent: Intent
    replaced: CutOff  # by its pieces


class Joined(NamedTuple):
    """How a motion would be joined to the one under way."""

    start_s: float  # in path time
    corner: Corner
    slower: Callable[[Intent], list[Piece] | None]  # the pieces, if it were asked for so


def joined(
    leg: Leg, intent: Intent, given: Given, arm: Arm, X_FT: Pose, path_s: float
) -> Joined | None:
    """Return how a motion is joined to the one under way; None: it cannot be, or it is too late.

    Args:
        leg: The motion under way.
        intent: The one that is to follow without a stop.
        given: The motions so far.
        arm: Whose.
        X_FT: Pose of the tool in the flange frame.
        path_s: Now, in path time [s].
    """
    if intent.goal_branch is not None and intent.goal_branch != intent.start_branch:
        return None
    if intent.takes_no_time and intent.model.pace.no_length is NoLength.NO_TIME:
        return None
    half = half_width(leg, intent, arm)
    start = leg.arrival - half
    if path_s > start + INSTANT or not fits(leg, intent, half):
        return None
    state = (given.at(start), given.rate(start))
    corner = round_corner(arm, X_FT, leg, intent, state)
    if corner is None or corner.branch[:2] != intent.start_branch[:2]:
        return None

    def pieces(slower: Intent) -> list[Piece] | None:
        if not fits(leg, slower, half):
            return None
        other = round_corner(arm, X_FT, leg, slower, state)
        return None if other is None else other.pieces

    return Joined(start, corner, pieces)
