"""The hand as a cause: where it closes and lets go, and how far that is from where it should."""

import math
from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.pose import IDENTITY, Pose, Vector, distance, dot, subtract
from vrts.engine.hand.told import CLOSED_ON_NOTHING
from vrts.engine.memory.events import Found, Grasped, HandCommanded, Released
from vrts.engine.memory.records import pose_of
from vrts.geometry.support import Bounds, bounds
from vrts.ir.motion import HandAction, MoveHand
from vrts.scene.handling.places import BY_ITS_EDGE
from vrts.scene.model import Body
from vrts.why.chain import Link
from vrts.why.shown import STRAIGHT_DOWN, length, offset, point, value
from vrts.why.slicing.executed import MOTIONS, Executed, Steps
from vrts.why.slicing.sources import written
from vrts.why.ways import decided, leads

SOON = 1.0  # [s] in which the hand has closed on what it closes on
NEAR = 0.15  # [m] from the pads to a thing that is meant [assumed]
AT_GOAL = 0.01  # [m] from its goal: a thing that was there had been put right
OFF = 2e-3  # [m] a grip that is less high or low on a thing than this is where it should be
HELD_CLOSED = 2e-3  # [m] an opening within this of the smallest is closed
TILT = math.radians(1.0)  # from upright: less is upright


class Closing(NamedTuple):
    """The hand was told to close."""

    event: HandCommanded
    at: Vector  # the middle between the pads, in W [m]
    gripped: str | None


def closings(steps: Steps) -> list[Closing]:
    """Return every time that a step told the hand to close, and what it took hold of."""
    run = steps.run
    grasped = [e for e in run.events if isinstance(e, Grasped)]
    found: list[Closing] = []
    for e in run.events:
        if not isinstance(e, HandCommanded) or e.action != "close" or e.cause is None:
            continue
        body = next(
            (g.body for g in grasped if g.cause == e.cause and 0.0 <= g.time_s - e.time_s < SOON),
            None,
        )
        found.append(Closing(e, pads_at(steps, e.time_s).translation, body))
    return found


def pads_at(steps: Steps, time_s: float) -> Pose:
    """Return the pose of the middle between the pads, X_WP."""
    run = steps.run
    return run.at(min(time_s, run.horizon_s)).X_WF @ run.scene.robot.gripper.X_FP


def box_at(steps: Steps, name: str, time_s: float) -> Bounds:
    """Return the box about a body at a time, in W [m]."""
    run = steps.run
    time_s = min(time_s, run.horizon_s)
    body = run.scene.body(name)
    placement = run.at(time_s).placements.get(name)
    X_WO = body.X_WO if placement is None else pose_of(placement, time_s, run.at(time_s).X_WF)
    return bounds(body.pieces, X_WO)


def gap(box: Bounds, at: Vector) -> float:
    """Return how far a point is from a box [m]; 0 inside."""
    inside = [min(max(x, a), b) for x, a, b in zip(at, box.lower, box.upper, strict=True)]
    return math.dist(at, inside)


def nearest_closing(steps: Steps, body: str) -> Closing | None:
    """Return the closing that was nearest to a body among those that took hold of nothing else."""
    found = [c for c in closings(steps) if c.gripped is None]
    if not found:
        return None
    return min(found, key=lambda c: gap(box_at(steps, body, c.event.time_s), c.at))


def closed(steps: Steps, closing: Closing, body: str) -> Iterator[Link]:
    """Yield why the hand did not take hold of a body when it closed."""
    event = closing.event
    assert event.cause is not None
    time_s = event.time_s
    already = any(
        isinstance(e, Found)
        and e.diagnostic.rule == CLOSED_ON_NOTHING
        and "already" in e.diagnostic.headline
        and e.cause == event.cause
        and abs(e.time_s - time_s) < SOON
        for e in steps.run.events
    )
    box = box_at(steps, body, time_s)
    if already:
        opening = steps.run.at(time_s).hand_opening
        says = f"the hand is {length(opening)} mm open already when it is told to close"
        yield Link(time_s, event.cause.span, says)
        yield _opened_last(steps, time_s)
        return
    says = f"the hand closes on nothing, at {point(closing.at)}"
    toward, amount = _beside(steps, steps.run.scene.body(body), box, closing.at, time_s)
    yield Link(time_s, event.cause.span, says, toward, amount)
    moving = list(moving_then(steps, time_s))
    yield from moving or brought(steps, time_s, toward)


def moving_then(steps: Steps, time_s: float) -> Iterator[Link]:
    """Yield that the arm was on its way while the hand closed or opened, if it was."""
    run = steps.run
    number = steps.motion_at(time_s)
    if number is None:
        return
    motion = run.motions[number]
    before = run.motions[number - 1] if number > 0 else None
    rounded = before is not None and before.blended
    if not (rounded or motion.start_s + 1e-6 < time_s) or time_s >= motion.end_s - 1e-6:
        return
    says = "the arm moves on meanwhile: nothing waits until it stands still"
    yield Link(motion.start_s, motion.cause.span, says)
    yield from _parameter(steps, "HAND.TIME", time_s)
    if before is not None and rounded:
        says = f"the end of this way, at {point(before.X_WT.translation)}, is rounded into the next"
        yield Link(before.start_s, before.cause.span, says)


def _parameter(steps: Steps, name: str, time_s: float) -> Iterator[Link]:
    """Yield the step that set a parameter of the controller, if one did before a time."""
    cell = steps.history.memory.parameters.get(name)
    source = None if cell is None else written(steps, cell, steps.history.finished_at(time_s))
    if source is not None and source.step is not None and cell is not None:
        now = cell.at(steps.history.finished_at(time_s))
        yield Link(source.time_s, source.step.cause.span, f"`{name}` is set to {value(now)} here")


def _opened_last(steps: Steps, time_s: float) -> Link:
    told = [
        e
        for e in steps.run.events
        if isinstance(e, HandCommanded) and e.action == "open" and e.time_s < time_s
    ]
    waiting = _waits(steps, time_s)
    if waiting is not None and (not told or told[-1].cause != waiting.cause):
        says = "this step opens the hand with the next motion only, and none comes before it closes"
        return Link(steps.time_of(waiting), waiting.cause.span, says)
    if told and told[-1].cause is not None:
        return Link(told[-1].time_s, told[-1].cause.span, "the hand was opened here last")
    shut = [
        e
        for e in steps.run.events
        if isinstance(e, HandCommanded) and e.action == "close" and e.time_s < time_s and e.cause
    ]
    if shut and shut[0].cause is not None:
        says = "the hand is told to close here, and no step opens it after that"
        return Link(shut[0].time_s, shut[0].cause.span, says)
    return Link(None, None, "no step before opens the hand")


def _waits(steps: Steps, time_s: float) -> Executed | None:
    """Return an OPEN that still waits for a motion at a time."""
    for number in range(steps.history.finished_at(time_s), 0, -1):
        step = steps.step(number)
        if step is None or isinstance(step.instruction, MOTIONS):
            return None
        hand = step.instruction
        if isinstance(hand, MoveHand) and hand.action is HandAction.OPEN:
            return None if hand.immediate else step
    return None


def brought(steps: Steps, time_s: float, toward: str = "") -> Iterator[Link]:
    """Yield how the hand came to where it was at a time: the motion, and what decided it.

    Args:
        steps: Of the run.
        time_s: When [s].
        toward: In which direction that is wrong; "" where nobody knows.
    """
    number = steps.motion_at(time_s)
    if number is None:
        return
    yield leads(steps, number)
    yield from decided(steps, number, toward)


def _beside(steps: Steps, body: Body, box: Bounds, at: Vector, time_s: float) -> tuple[str, str]:
    """Return in which direction the pads are off a body that they should grip, and how far."""
    X_WP = pads_at(steps, time_s)
    edge = BY_ITS_EDGE.get(body.kind)
    if edge is not None or X_WP.rotation[8] > STRAIGHT_DOWN:
        by = f", which is gripped by its {edge}" if edge else ""
        apart = gap(box, at)
        where = f"{length(apart)} mm from" if apart > 0 else "within the box about"
        given = steps.run.scene.locations.get(f"{body.name}_grip".lower())
        place = (
            f"; `{body.name}_grip` of the scene is at {point(given.translation)}" if given else ""
        )
        return f"not where `{body.name}` can be gripped", f"{where} `{body.name}`{by}{place}"
    low, high = grip_heights(steps, box)
    x, y = ((a + b) / 2 for a, b in zip(box.lower[:2], box.upper[:2], strict=True))
    direction, amount = offset(subtract(at, (x, y, min(max(at[2], low), high))), least=2e-3)
    if not direction:
        return "", ""
    reach = f"`{body.name}` is at X {_mm(x)} Y {_mm(y)}, and can be gripped"
    reach += f" from Z {_mm(low)} to {_mm(high)}"
    return f"{direction} for `{body.name}`", f"{amount}: {reach}"


def grip_heights(steps: Steps, box: Bounds) -> tuple[float, float]:
    """Return from where to where the pads of a hand straight down can grip what stands [m].

    High enough that neither tips nor palm are in the way, low enough for the pads to overlap it.
    """
    gripper = steps.run.scene.robot.gripper
    pads = gripper.X_FP.translation[2]
    tips = max(bounds(f.pieces, IDENTITY).upper[2] for f in gripper.fingers)
    palm = bounds(gripper.body, IDENTITY).upper[2]
    low, high = box.lower[2], box.upper[2]
    lowest = max(low + tips - pads, high - (pads - palm))
    return lowest, high + gripper.pad_length / 2 - gripper.overlap_min


def _mm(value: float) -> str:
    return f"{round(value * 1000) + 0.0:g}"


def let_go(steps: Steps, event: Released, goal: Pose | None) -> Iterator[Link]:
    """Yield where a body was let go, and how the hand came there.

    Args:
        steps: Of the run.
        event: Of the letting go.
        goal: Where the body should have been, X_WG; None: nobody knows.
    """
    time_s = min(event.time_s, steps.run.horizon_s)
    box = box_at(steps, event.body, time_s)
    x, y = ((a + b) / 2 for a, b in zip(box.lower[:2], box.upper[:2], strict=True))
    says = f"`{event.body}` is let go with its underside at {point((x, y, box.lower[2]))}"
    X_WO = _pose(steps, event.body, time_s)
    tilt = 0.0
    if goal is not None:
        tilt = math.acos(max(-1.0, min(1.0, dot(X_WO.approach, goal.approach))))
    toward, amount = "", ""
    if tilt > TILT:
        toward, amount = (
            "tilted",
            f"tilted by {math.degrees(tilt):.0f} degrees from how it should stand",
        )
    elif event.height_m > HELD_CLOSED:
        below = box.lower[2] - event.height_m
        toward = "too high"
        amount = f"{length(event.height_m)} mm too high: what is below it begins at Z {_mm(below)}"
    elif goal is not None:
        toward, how_far = offset(subtract(X_WO.translation, goal.translation), least=2e-3)
        amount = f"{how_far} for its goal" if how_far else ""
    span = event.cause.span if event.cause else None
    yield Link(event.time_s, span, says, toward, amount)
    moving = list(moving_then(steps, event.time_s))
    again = [] if moving else list(_gripped_otherwise(steps, event, goal))
    yield from moving or again or brought(steps, time_s, toward)


def _gripped_otherwise(steps: Steps, event: Released, goal: Pose | None) -> Iterator[Link]:
    """Yield that a body was taken from its goal, or gripped higher or lower than it should be.

    What comes of the grip stands in the step that led there, not in the one that lets go.
    """
    run, body = steps.run, event.body
    grips = [
        e
        for e in run.events
        if isinstance(e, Grasped) and e.body == body and e.time_s <= event.time_s
    ]
    grip = grips[-1] if grips else None
    cause = None if grip is None else grip.cause
    if grip is None or cause is None:
        return
    X_WO = _pose(steps, body, grip.time_s)
    if len(grips) > 1:
        if goal is None or distance(X_WO.translation, goal.translation) > AT_GOAL:
            return  # to take a thing twice is no mistake of its own
        at = box_at(steps, body, grip.time_s)
        x, y = ((a + b) / 2 for a, b in zip(at.lower[:2], at.upper[:2], strict=True))
        where = point((x, y, at.lower[2]))
        says = f"the hand takes hold of `{body}` again here, at {where}"
        yield Link(grip.time_s, cause.span, says)
        yield from brought(steps, grip.time_s)
        return
    given = run.scene.locations.get(f"{body}_grip".lower())
    if given is None:
        return
    usual = given.translation[2] - run.scene.body(body).X_WO.translation[2]
    height = run.at(grip.time_s).X_WT.translation[2] - X_WO.translation[2]
    if abs(height - usual) < OFF or abs(abs(height - usual) - abs(event.height_m)) > OFF:
        return
    how = f"{length(abs(height - usual))} mm too {'high' if height > usual else 'low'}"
    says = f"the hand takes hold of `{body}` here"
    toward = f"too {'high' if height > usual else 'low'} on it"
    amount = f"{how} on it: `{body}_grip` of the scene is at Z {_mm(given.translation[2])}"
    yield Link(grip.time_s, cause.span, says, toward, amount)
    yield from brought(steps, grip.time_s, toward)


def _pose(steps: Steps, body: str, time_s: float) -> Pose:
    state = steps.run.at(time_s)
    placement = state.placements.get(body)
    if placement is None:
        return steps.run.scene.body(body).X_WO
    return pose_of(placement, time_s, state.X_WF)
