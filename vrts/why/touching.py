"""Contacts as effects: which way led there, which end of it is wrong, and by how much."""

import math
from collections.abc import Iterator
from dataclasses import replace

from vrts.base.pose import Vector, subtract
from vrts.check.verdict import ContactEvent, sides
from vrts.engine.memory.events import Grasped, HandCommanded, Released
from vrts.engine.memory.records import pose_of
from vrts.geometry.shapes import Piece
from vrts.geometry.support import bounds, extent_of
from vrts.scene.clearance import Placed, placed_hand
from vrts.scene.handling.places import BY_ITS_EDGE
from vrts.why.between import (
    both_ends_free,
    clear_height,
    equally_high,
    put_there,
    stands_between,
)
from vrts.why.chain import Link
from vrts.why.hands import SOON, box_at, gap, let_go, moving_then
from vrts.why.shown import length, point
from vrts.why.slicing.entered import called
from vrts.why.slicing.executed import Steps
from vrts.why.ways import decided

ROBOT = "robot"
FARTHEST = 0.3  # [m] a way out that is longer is no help
OVER = 2.5  # a thing that is held is rather carried over something than beside it [assumed]
LEANS = 0.38  # of a direction along an axis: below it the axis is not named


def contact(steps: Steps, event: ContactEvent) -> Iterator[Link]:
    """Yield why two things touched: the way on which they did, then what decided it."""
    run = steps.run
    number = steps.motion_at(event.start_s)
    if number is None:
        return
    motion = run.motions[number]
    late = list(_late_grip(steps, event, number))
    if late:
        yield from late
        return
    closed = list(_hand_closed(steps, event))
    yield from closed
    if event.start_s >= motion.end_s + 1e-6:
        yield from _hand_moves(steps, event)
        return
    start, end = _start(steps, number), motion.X_WT.translation
    toward, amount = ("", "") if closed else _out(steps, event, subtract(end, start))
    says = f"the tool is on its way from {point(start)} to {point(end)}"
    yield Link(motion.start_s, motion.cause.span, says, toward, amount)
    put = list(put_there(steps, event))
    yield from put
    found = [] if closed else list(_decided(steps, number, event, toward))
    yield from found
    step = steps.of_motion(number)
    call = None if step is None or found else called(steps, step)
    if call is not None:
        yield call


def _decided(steps: Steps, number: int, event: ContactEvent, toward: str) -> Iterator[Link]:
    """Yield what decided where a way leads along: a point that is missing, or one of its ends."""
    start, end = _start(steps, number), steps.run.motions[number].X_WT.translation
    low, high = "too low" in toward, "too high" in toward
    across = math.dist(start[:2], end[:2]) > abs(start[2] - end[2])
    if across and both_ends_free(steps, event, number) and (not low or equally_high(start, end)):
        yield from stands_between(steps, event, number, beneath=high)
    else:
        lower = low or not (across or high)  # straight up or down, things stand at the lower end
        yield from _end_to_blame(steps, number, event, toward, low=lower)


def _start(steps: Steps, number: int) -> Vector:
    """Return where a way begins: the end of the one before, also where that is rounded."""
    motion = steps.run.motions[number]
    if number > 0 and steps.run.motions[number - 1].blended:
        return steps.run.motions[number - 1].X_WT.translation
    return steps.run.at(motion.start_s).X_WT.translation


def _end_to_blame(
    steps: Steps, number: int, event: ContactEvent, toward: str, *, low: bool
) -> Iterator[Link]:
    """Yield what decided the end of the way that is to blame: the lower one, or the nearer one."""
    run = steps.run
    motion = run.motions[number]
    start, end = _start(steps, number), motion.X_WT.translation
    if low and abs(start[2] - end[2]) > 1e-3:
        from_start = start[2] < end[2]
    else:
        from_start = event.deepest_s < (motion.start_s + motion.end_s) / 2
    if from_start and number > 0:
        before = run.motions[number - 1]
        says = f"the way begins at {point(start)}, where this step leads"
        height = (
            clear_height(steps, event) if low and both_ends_free(steps, event, number) else None
        )
        over = (
            ""
            if height is None
            else f"the tool passes over `{event.second}` from Z {_mm(height)} on"
        )
        yield Link(before.start_s, before.cause.span, says, "", over)
        yield from decided(steps, number - 1, toward)
    elif not from_start:
        found = list(decided(steps, number, toward))
        yield from found or _where_it_begins(steps, number)


def _where_it_begins(steps: Steps, number: int) -> Iterator[Link]:
    """Yield the step that led to where a way begins: its end is right as far as anybody knows."""
    if number == 0:
        return
    before = steps.run.motions[number - 1]
    says = f"the way begins at {point(_start(steps, number))}, where this step leads"
    yield Link(before.start_s, before.cause.span, says, minor=True)


def _out(steps: Steps, event: ContactEvent, along: Vector) -> tuple[str, str]:
    """Return in which direction one thing would have to be elsewhere not to touch, and how far.

    Up, or to a side of the way; what lies ahead on it is no way out.
    """
    moving = _moving(steps, event)
    if moving is None:
        return "", ""
    other = _touched(steps, event)
    ways = [((0.0, 0.0, 1.0), "low"), ((0.0, 0.0, -1.0), "high")]
    level = math.hypot(along[0], along[1])
    if level > abs(along[2]):
        x, y = along[1] / level, -along[0] / level
        ways += [((sign * x, sign * y, 0.0), "") for sign in (1.0, -1.0)]
    else:
        ways += [((s, 0.0, 0.0), "") for s in (1.0, -1.0)] + [
            ((0.0, s, 0.0), "") for s in (1.0, -1.0)
        ]

    def needed(way: Vector) -> float:
        beyond = extent_of(other.pieces, other.X_WO, way).upper
        return beyond - extent_of(moving.pieces, moving.X_WO, way).lower

    beside = OVER if sides(event)[0] != ROBOT else 1.0
    way, word = min(ways, key=lambda each: needed(each[0]) * (1.0 if each[1] else beside))
    size = needed(way)
    if not 0.0 < size < FARTHEST:
        return "", ""
    if word == "high":
        amount = f"{moving.name} is {length(size)} mm too high to pass under `{event.second}`"
        return f"{moving.name} is too high", amount
    if word:
        lowest, top = (
            extent_of(moving.pieces, moving.X_WO, way).lower,
            extent_of(other.pieces, other.X_WO, way).upper,
        )
        amount = (
            f"{moving.name} is {length(size)} mm too low: its underside is at Z {_mm(lowest)},"
            f" the top of `{event.second}` there at Z {_mm(top)}"
        )
        return f"{moving.name} is too low", amount
    side = _side(way)
    toward = f"{moving.name} is too far {side} to pass `{event.second}`"
    return toward, f"{moving.name} is {length(size)} mm too far {side} to pass `{event.second}`"


def _touched(steps: Steps, event: ContactEvent) -> Placed:
    """Return the piece of the other thing that is touched: the one at the point of contact."""
    other = _placed(steps, event.second, event.deepest_s)

    def apart(piece: Piece) -> float:
        box = bounds((piece,), other.X_WO)
        return gap(box, event.point)

    return replace(other, pieces=(min(other.pieces, key=apart),))


def _side(out: Vector) -> str:
    """Return on which side something is that would have to go a way to be free."""
    names = [
        f"{'-' if x > 0 else '+'}{name}"
        for x, name in zip(out, "XY", strict=False)
        if abs(x) > LEANS
    ]
    return f"in {' and '.join(names)}"


def _placed(steps: Steps, name: str, time_s: float) -> Placed:
    run = steps.run
    time_s = min(time_s, run.horizon_s)
    body, state = run.scene.body(name), run.at(time_s)
    placement = state.placements.get(name)
    X_WO = body.X_WO if placement is None else pose_of(placement, time_s, state.X_WF)
    return Placed(f"`{name}`", body.pieces, X_WO)


def _moving(steps: Steps, event: ContactEvent) -> Placed | None:
    """Return what moves into the other thing: what is held, or the part of the hand."""
    run = steps.run
    first, _ = sides(event)
    if event.second == ROBOT:
        return None
    if first != ROBOT:
        return _placed(steps, first, event.deepest_s)
    state = run.at(min(event.deepest_s, run.horizon_s))
    for placed in placed_hand(run.scene.robot.gripper, state.X_WF, state.hand_opening):
        if placed.name == event.parts[0] or (event.parts[0] == "palm" and placed.name == "hand"):
            return replace(placed, name=f"the {event.parts[0]}")
    return None


def _late_grip(steps: Steps, event: ContactEvent, number: int) -> Iterator[Link]:
    """Yield that what is held was gripped on the way, while the arm moved on."""
    run = steps.run
    if event.held is None:
        return
    last = [
        e
        for e in run.events
        if isinstance(e, Grasped) and e.body == event.held and e.time_s <= event.start_s + 1e-6
    ]
    if not last or last[-1].cause is None:
        return
    grip = last[-1]
    for motion in (run.motions[number], *([run.motions[number - 1]] if number else [])):
        if motion.start_s + 1e-6 < grip.time_s < motion.end_s - 1e-6 and grip.cause is not None:
            at = box_at(steps, event.held, grip.time_s)
            where = f"`{event.held}` is gripped on the way, its underside at Z {_mm(at.lower[2])}"
            yield Link(grip.time_s, grip.cause.span, where)
            yield from moving_then(steps, grip.time_s)
            return


def _hand_closed(steps: Steps, event: ContactEvent) -> Iterator[Link]:
    """Yield that the hand comes down on a thing with its fingers closed, or not open enough."""
    run = steps.run
    part = event.parts[0]
    if "finger" not in part or event.second not in run.at(event.start_s).placements:
        return
    if run.scene.body(event.second).kind in BY_ITS_EDGE:
        return
    opening = run.at(event.start_s).hand_opening
    body = box_at(steps, event.second, event.start_s)
    width = min(body.upper[0] - body.lower[0], body.upper[1] - body.lower[1])
    if opening > width or run.at(event.start_s).held is not None:
        return
    told = [e for e in run.events if isinstance(e, HandCommanded) and e.time_s <= event.start_s]
    last = told[-1] if told else None
    span = None if last is None or last.cause is None else last.cause.span
    time_s = None if last is None else last.time_s
    says = f"the hand is {length(opening)} mm open when it comes to `{event.second}`"
    if last is None:
        says = f"no step before opens the hand: it is {length(opening)} mm open"
    amount = f"`{event.second}` is {length(width)} mm wide"
    yield Link(time_s, span, says, "not open enough", amount)


def _hand_moves(steps: Steps, event: ContactEvent) -> Iterator[Link]:
    """Yield why two things touch though the arm stands still: by what the hand lets go."""
    first, second = sides(event)
    for e in steps.run.events:
        late = isinstance(e, Released) and -SOON < e.time_s - event.start_s < SOON
        if late and isinstance(e, Released) and e.body in {first, second}:
            yield from let_go(steps, e, None)
            return
    span = event.cause.span if event.cause else None
    yield Link(event.start_s, span, "the arm stands still, and the hand moves")


def _mm(value: float) -> str:
    return f"{round(value * 1000, 1) + 0.0:g}"
