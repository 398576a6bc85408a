"""What stands between the two places of a way: a point is missing, beside it or above it."""

import math
from collections.abc import Iterator

from vrts.base.pose import Vector, distance
from vrts.check.verdict import ContactEvent, sides
from vrts.engine.memory.events import Released
from vrts.engine.memory.records import pose_of
from vrts.geometry.support import bounds
from vrts.scene.clearance import placed_hand
from vrts.why.chain import Link
from vrts.why.shown import point
from vrts.why.slicing.executed import Steps

NEAR = 0.05  # [m] from an end of a way: what is touched there is not between its ends [assumed]
LEVEL = 1e-3  # [m] ends that differ less are equally high


def both_ends_free(steps: Steps, event: ContactEvent, number: int) -> bool:
    """Return whether a way touches something only between its ends."""
    run, motion = steps.run, steps.run.motions[number]
    if event.second not in {body.name for body in run.scene.bodies}:
        return False

    def tool(time_s: float) -> Vector:
        return run.at(min(time_s, run.horizon_s)).X_WT.translation

    before = distance(tool(motion.start_s), tool(event.start_s))
    after = distance(tool(event.end_s), tool(motion.end_s))
    return event.end_s < motion.end_s and min(before, after) > NEAR


def stands_between(
    steps: Steps, event: ContactEvent, number: int, *, beneath: bool
) -> Iterator[Link]:
    """Yield that a point is missing between the ends of a way, and from which height on it is free.

    Args:
        steps: Of the run.
        event: The contact.
        number: Of the motion.
        beneath: Whether the way leads beneath something, so that going over it is no help.
    """
    motion = steps.run.motions[number]
    says = f"`{event.second}` stands between the two places"
    toward, amount = "a point on the way is missing", ""
    height = None if beneath else clear_height(steps, event)
    if height is not None:
        amount = (
            f"a point beside it is missing, or above it with the tool at Z {_up(height)} or more"
        )
    yield Link(None, motion.cause.span, says, toward, amount)


def clear_height(steps: Steps, event: ContactEvent) -> float | None:
    """Return from which Z of the tool on all that the hand is and holds is above a thing [m]."""
    run = steps.run
    time_s = min(event.deepest_s, run.horizon_s)
    state = run.at(time_s)
    if event.second == "robot":
        return None
    body = run.scene.body(event.second)
    placement = state.placements.get(event.second)
    X_WO = body.X_WO if placement is None else pose_of(placement, time_s, state.X_WF)
    top = bounds(body.pieces, X_WO).upper[2]
    hand = placed_hand(run.scene.robot.gripper, state.X_WF, state.hand_opening)
    lowest = min(bounds(part.pieces, part.X_WO).lower[2] for part in hand)
    if state.held is not None:
        X_WH = pose_of(state.placements[state.held], time_s, state.X_WF)
        lowest = min(lowest, bounds(run.scene.body(state.held).pieces, X_WH).lower[2])
    return state.X_WT.translation[2] + top - lowest


def equally_high(start: Vector, end: Vector) -> bool:
    """Return whether a way is level."""
    return abs(start[2] - end[2]) <= LEVEL


def put_there(steps: Steps, event: ContactEvent) -> Iterator[Link]:
    """Yield that what is touched was put there by the program itself."""
    touched = [name for name in sides(event) if name not in {"robot", event.held}]
    for e in reversed(steps.run.events):
        if isinstance(e, Released) and e.body in touched and e.time_s < event.start_s - 1.0:
            span = None if e.cause is None else e.cause.span
            at = steps.run.at(event.start_s)
            X_WO = pose_of(at.placements[e.body], event.start_s, at.X_WF)
            says = f"`{e.body}` was put here before, at {point(X_WO.translation)}"
            yield Link(e.time_s, span, says)
            return


def _up(height: float) -> str:
    return f"{math.ceil(round(height * 1000, 3)) + 0:g}"
