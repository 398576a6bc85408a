"""A run told line by line, from an earlier time to a later one or backward."""

from collections.abc import Iterator
from itertools import groupby
from typing import NamedTuple

from vrts.engine.memory.events import (
    Cause,
    Event,
    MotionEnded,
    MotionStarted,
    Printed,
    ProgramEnded,
    ProgramStarted,
)
from vrts.engine.run import Run
from vrts.engine.statements import Statement, statements
from vrts.report.event_words import event_text
from vrts.report.plain import one_line, plain_text

MOST_STEPS = 20  # told of one instant; a loop makes 100 in a tick
INSTANT = 1e-9  # [s]


FIRST, BEGINNING, STEP, THEN, LAST = range(5)  # order within an instant


class Told(NamedTuple):
    """A line of the replay, and when it is due."""

    time_s: float
    text: str
    order: int = STEP


def replay(run: Run, from_s: float, to_s: float) -> Iterator[Told]:
    """Yield a line for every step and event; where `to_s` is the earlier time, going backward.

    Both times are inside. What the program writes is told as it appears (`+`) or, backward, as it
    disappears (`-`).
    """
    backward = to_s < from_s
    lines = _forward(run, min(from_s, to_s), max(from_s, to_s), backward=backward)
    return iter(list(lines)[::-1]) if backward else lines


def _forward(run: Run, first_s: float, last_s: float, *, backward: bool) -> Iterator[Told]:
    moments = sorted(
        [*_steps(run, first_s, last_s), *_events(run, first_s, last_s, backward=backward)],
        key=lambda told: (round(told.time_s / INSTANT), told.order),
    )
    yield from moments


def _steps(run: Run, first_s: float, last_s: float) -> Iterator[Told]:
    history = run.history
    begin = history.finished_at(first_s - INSTANT) if first_s > 0.0 else 0
    steps = statements(history, begin, history.finished_at(last_s))
    for time_s, together in groupby(steps, key=lambda step: history.time_of(step.number)):
        told = list(_apart(together))
        for statement in told[:MOST_STEPS]:
            sign = "p " if statement.process else "  "
            yield Told(time_s, _line(time_s, sign, statement.cause, statement.cause.span.text))
        if len(told) > MOST_STEPS:
            yield Told(
                time_s, _line(time_s, "  ", None, f"and {len(told) - MOST_STEPS} more steps")
            )


def _apart(steps: Iterator[Statement]) -> Iterator[Statement]:
    """Leave out instructions of the step before."""
    before: tuple[Cause, bool] | None = None
    for statement in steps:
        if (statement.cause, statement.process) != before:
            yield statement
        before = (statement.cause, statement.process)


def _events(run: Run, first_s: float, last_s: float, *, backward: bool) -> Iterator[Told]:
    for event in run.events:
        if event.time_s > last_s:
            break
        if event.time_s < first_s:
            continue
        if isinstance(event, Printed):
            sign = "- " if backward else "+ "
            for text in event.text.replace("\r\n", "\n").rstrip("\n").split("\n"):
                yield Told(event.time_s, _line(event.time_s, sign, event.cause, text), THEN)
        elif words := _words(run, event):
            told = _line(event.time_s, "* ", event.cause, words)
            yield Told(event.time_s, told, _order(run, event))


def _order(run: Run, event: Event) -> int:
    match event:
        case MotionEnded(time_s=time_s, motion=motion):
            takes_time = run.motions[motion].start_s < time_s - INSTANT
            return FIRST if takes_time else THEN  # after its own start
        case ProgramStarted():
            return BEGINNING
        case ProgramEnded():
            return LAST
        case _:
            return THEN


def _words(run: Run, event: Event) -> str:
    match event:
        case MotionStarted(cause=cause):
            return f"the arm starts: {one_line(cause.span.text)}"
        case MotionEnded(motion=motion, cause=cause):
            ends = "arrives" if run.motions[motion].arrives else "is stopped"
            return f"the arm {ends}: {one_line(cause.span.text)}"
        case _:
            found = event_text(event)
            return found[1] if found is not None else ""


def _line(time_s: float, sign: str, cause: Cause | None, words: str) -> str:
    where = f"line {cause.span.line}" if cause is not None else ""
    return plain_text(f"{time_s:9.3f} s  {where:<10}{sign}{one_line(words)}")
