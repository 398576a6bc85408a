"""Time as an effect: the speeds under which it went, and the steps that wait."""

from collections.abc import Iterator

from vrts.base.source import Span
from vrts.ir.motion import Delay
from vrts.why.chain import Link
from vrts.why.shown import point
from vrts.why.slicing.executed import MOTIONS, Executed, Steps
from vrts.why.ways import speed_of

MUCH = 0.15  # of the whole time: a step that takes so long is named
NEAR = 6  # steps back in which a DELAY is looked for


def too_slow(steps: Steps) -> Iterator[Link]:
    """Yield where the time went: the speed under which most of it passed, and long waits."""
    run = steps.run
    total = (run.ended_s or run.horizon_s) - run.started_s or 1.0
    by_speed: dict[Span | None, tuple[float, Link | None]] = {}
    for number, motion in enumerate(run.motions):
        link = speed_of(steps, number)
        key = None if link is None else link.span
        spent, _ = by_speed.get(key, (0.0, None))
        by_speed[key] = (spent + motion.end_s - motion.start_s, link)
    order = sorted(by_speed.values(), key=lambda one: one[0], reverse=True)
    for spent, link in order[:2]:
        if link is None or spent < MUCH * total:
            continue
        says = f"{spent:.1f} of {total:.1f} s pass at this speed"
        yield Link(link.time_s, link.span, says, "too slow", "")
    slowest = max(range(len(run.motions)), key=lambda n: _lasts(steps, n), default=None)
    if slowest is not None and _lasts(steps, slowest) > 0.0:
        one = run.motions[slowest]
        says = (
            f"the longest motion: {_lasts(steps, slowest):.1f} s to {point(one.X_WT.translation)}"
        )
        yield Link(one.start_s, one.cause.span, says)
    yield from _waits(steps, total)


def _lasts(steps: Steps, number: int) -> float:
    one = steps.run.motions[number]
    return one.end_s - one.start_s


def _waits(steps: Steps, total: float) -> Iterator[Link]:
    """Yield steps that wait for long: for a signal, a time."""
    history = steps.history
    moving = [(m.start_s, m.end_s) for m in steps.run.motions]
    for before, after in zip(history.ticks, [*history.ticks[1:], None], strict=False):
        start = before * history.tick_s
        end = (steps.run.ended_s or start) if after is None else after * history.tick_s
        idle = end - start - sum(max(0.0, min(e, end) - max(s, start)) for s, e in moving)
        if idle > MUCH * total:
            step = steps.step(history.finished_at(start) + 1) or steps.step(
                history.finished_at(start)
            )
            if step is not None:
                at = _delay_before(steps, step)
                yield Link(start, at.cause.span, f"{idle:.1f} s pass here without a motion")


def _delay_before(steps: Steps, step: Executed) -> Executed:
    """Return the DELAY that a step waits for, which is a motion to nowhere; the step, if none."""
    for number in range(step.number, max(step.number - NEAR, 0), -1):
        found = steps.step(number)
        if found is None or isinstance(found.instruction, MOTIONS):
            break
        if isinstance(found.instruction, Delay):
            return found
    return step
