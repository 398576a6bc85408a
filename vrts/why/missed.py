"""Goals not reached as effects: never gripped, let go at the wrong place, still in the hand."""

from collections.abc import Iterator

from vrts.base.pose import Vector
from vrts.base.source import Span
from vrts.check.goals.reached import Reached
from vrts.check.task.goals import Goal
from vrts.engine.memory.events import Grasped, HandCommanded, Released
from vrts.why.chain import Link
from vrts.why.hands import (
    NEAR,
    SOON,
    box_at,
    closed,
    closings,
    gap,
    let_go,
    nearest_closing,
    pads_at,
)
from vrts.why.left_out import never_reached
from vrts.why.shown import length, point
from vrts.why.slicing.executed import Steps

AT_IT = 0.02  # [m] from a body: the hand is there to grip it [assumed]


def missed(steps: Steps, result: Reached, at: Span | None = None) -> Iterator[Link]:
    """Yield why a thing is not where it should be; `at` is the step that is told of, if one is."""
    run, body = steps.run, result.body
    released = [e for e in run.events if isinstance(e, Released) and e.body == body]
    grasped = [e for e in run.events if isinstance(e, Grasped) and e.body == body]
    if grasped and (not released or released[-1].time_s < grasped[-1].time_s):
        last = grasped[-1]
        span = last.cause.span if last.cause else None
        yield Link(
            last.time_s, span, f"the hand takes hold of `{body}` here, and never lets go of it"
        )
        yield from _closed_again(steps, body, last.time_s)
        return
    if released:
        goal = result.goal.X_WG if isinstance(result.goal, Goal) else None
        yield from let_go(steps, released[-1], goal)
        return
    yield from never(steps, body, at)


def never(steps: Steps, body: str, at: Span | None = None) -> Iterator[Link]:
    """Yield why a thing was never gripped."""
    for closing in closings(steps):
        cause = closing.event.cause
        if at is not None and cause is not None and cause.span == at and closing.gripped is None:
            yield from closed(steps, closing, body)
            return
    nearest = nearest_closing(steps, body)
    if nearest is not None and gap(box_at(steps, body, nearest.event.time_s), nearest.at) < NEAR:
        yield from closed(steps, nearest, body)
        return
    found = list(never_reached(steps, body))
    if found:
        yield from found
        return
    if nearest is not None:
        yield from closed(steps, nearest, body)
        return
    everything = closings(steps)
    if not everything:
        yield Link(None, None, "the hand is never told to close")
        yield from _opened_there(steps, body)
        return
    here = min(everything, key=lambda c: _apart(steps, body, c.at, c.event.time_s))
    apart = _apart(steps, body, here.at, here.event.time_s)
    span = here.event.cause.span if here.event.cause else None
    says = f"the hand closes nowhere nearer to `{body}` than here"
    if here.gripped is not None:
        says += f", where it takes hold of `{here.gripped}`"
    yield Link(here.event.time_s, span, says, "", f"{length(apart)} mm from it")


def _closed_again(steps: Steps, body: str, since_s: float) -> Iterator[Link]:
    """Yield that the hand was told to close while it held a body: to open may have been meant."""
    for e in steps.run.events:
        again = isinstance(e, HandCommanded) and e.action == "close" and e.time_s > since_s + SOON
        if again and e.cause is not None:
            says = f"the hand is told to close here, while it holds `{body}`"
            yield Link(e.time_s, e.cause.span, says)
            return


def _opened_there(steps: Steps, body: str) -> Iterator[Link]:
    """Yield that the hand was told to open beside a body: to close may have been meant."""
    for e in steps.run.events:
        if not isinstance(e, HandCommanded) or e.action != "open" or e.cause is None:
            continue
        at = pads_at(steps, e.time_s).translation
        if gap(box_at(steps, body, e.time_s), at) < AT_IT:
            says = f"the hand is told to open here, at {point(at)}, where it could grip `{body}`"
            yield Link(e.time_s, e.cause.span, says)
            return


def _apart(steps: Steps, body: str, at: Vector, time_s: float) -> float:
    return gap(box_at(steps, body, time_s), at)
