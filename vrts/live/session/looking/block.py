"""A stretch of a session's past as the browser's player takes it: polynomials, bodies, lines.

It answers any moment in it: where arm, hand and bodies were, which line was at work, which outputs
were on, and what happened. Lengths are in m, angles in rad, times in s of the session; poses are
twelve numbers, as the viewer takes them.
"""

import gzip
from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import Final, NamedTuple

import msgspec

from vrts.base.pose import Pose
from vrts.engine.memory.events import Cause, ProgramEnded, ProgramStarted, SignalChanged
from vrts.engine.memory.records import GRAVITY, ProgramStatus, Segment
from vrts.engine.run import Run, State
from vrts.engine.timeline import Timeline
from vrts.ir.commands import Panic
from vrts.live.session.channel.messages import BLOCK, Json
from vrts.live.session.views.frame import output_bits
from vrts.monitor.desk import ALONE
from vrts.report.event_words import event_text
from vrts.report.page.replay_data import placement_data, segment_data
from vrts.report.page.viewer_data import pose_numbers
from vrts.report.plain import one_line

MOST_MARKS: Final = 2000  # rows of what happened
MOST_CHANGES: Final = 6000  # moments at which the line at work may change
LONGEST_LINE: Final = 200  # characters of a step's text
LEVEL: Final = 1  # of gzip

STOPPED: Final = "everything was stopped"


class _Doing(NamedTuple):
    """What is constant between two changes."""

    cause: Cause | None
    running: bool
    X_FT: Pose
    base: Pose


def block_bytes(run: Run, number: int, reaches_s: float) -> bytes:
    """Return a block as compressed JSON.

    Args:
        run: It knows the block from its beginning, or from `reaches_s`, to its own end.
        number: Of the block: it begins at `number * BLOCK`.
        reaches_s: The earliest time that anything is known of [s].
    """
    return gzip.compress(msgspec.json.encode(block(run, number, reaches_s)), LEVEL, mtime=0)


def block(run: Run, number: int, reaches_s: float) -> Json:
    """Return a block as plain data."""
    begin_s, end_s = max(number * BLOCK, reaches_s), (number + 1) * BLOCK
    until_s = min(end_s, run.until_s)
    begin_s = min(begin_s, until_s)
    doings = list(_changes(run, begin_s, until_s))
    steps: dict[Cause, int] = {}
    lines = [(t, _number(steps, d.cause), d.running) for t, d in doings]
    marks, left_out = _marks(run, begin_s, until_s)
    return {
        "begin": begin_s,
        "until": until_s,
        "whole": until_s == end_s,
        "reaches": reaches_s,
        "gravity": GRAVITY,
        "segments": segment_data(_segments(run, begin_s, until_s)),
        "placements": {
            body: [placement_data(p) for p in track if p.end_s > begin_s and p.start_s <= until_s]
            for body, track in run.placements.items()
        },
        "tools": _poses((t, d.X_FT) for t, d in doings),
        "bases": _poses((t, d.base) for t, d in doings),
        "steps": [_step(cause) for cause in steps],
        "lines": _changed(lines),
        "outputs": _outputs(run, begin_s, until_s),
        "marks": marks,
        "leftOut": left_out,
    }


def _segments(run: Run, begin_s: float, until_s: float) -> Sequence[Segment]:
    """Return the polynomials of a stretch; only its own pieces are looked at."""
    arm, hand = run.history.arm, run.history.hand
    begin, until = (arm.scale.path(t) for t in (begin_s, until_s))
    first = max(bisect_right(arm.pieces, begin, key=lambda piece: piece.start_s) - 1, 0)
    last = bisect_right(arm.pieces, until, key=lambda piece: piece.start_s)
    stroke = max(bisect_right(hand.strokes, begin_s, key=lambda one: one.start_s) - 1, 0)
    timeline = Timeline(
        arm.pieces[first:last],
        arm.scale,
        hand.strokes[stroke:],
        arm.configuration,
        hand.opening_m,
        until_s,
    )
    found = [s for s in timeline.segments if s.end_s > begin_s]
    if found:
        return found
    rows = (*((q,) for q in timeline.configuration(until_s)), (timeline.opening(until_s),))
    return [Segment(until_s, until_s, rows, None)]


def _changes(run: Run, begin_s: float, until_s: float) -> Iterator[tuple[float, _Doing]]:
    """Yield what was done from when [s] on, at every moment at which it may have changed."""
    history, time = run.history, run.history.arm.scale.time
    tick = history.tick_s
    low, high = (bisect_left(history.ticks, t / tick - 1e-6) for t in (begin_s, until_s))
    moments = {begin_s, *(k * tick for k in history.ticks[low : high + 1])}
    for motion in history.arm.motions:
        moments.update((time(motion.start_s), time(motion.end_s)))
    moments.update(command.time_s for command in history.issued)
    moments.update(e.time_s for e in run.events if isinstance(e, ProgramStarted | ProgramEnded))
    known = sorted(t for t in moments if begin_s <= t <= until_s)
    before: _Doing | None = None
    for t in known[:MOST_CHANGES]:
        state = run.at(t)
        doing = _doing(run, state)
        if doing != before:
            before = doing
            yield t, doing


def _doing(run: Run, state: State) -> _Doing:
    robot = state.robot
    going = robot is not None and robot.status in (ProgramStatus.RUNNING, ProgramStatus.WAITING)
    motion = run.motion_begun(state.time_s)
    moves = motion is not None and state.time_s < motion.end_s
    cause = motion.cause if motion is not None and moves else state.instruction if going else None
    running = robot is not None and going and robot.program != ALONE
    tool = motion.X_FT if motion is not None and state.time_s <= motion.end_s else state.X_FT
    return _Doing(cause, running, tool, state.base)


def _number(steps: dict[Cause, int], cause: Cause | None) -> int:
    return -1 if cause is None else steps.setdefault(cause, len(steps))


def _changed(rows: Sequence[tuple[float, int, bool]]) -> list[tuple[float, int, bool]]:
    """Return the rows that say something else than the one before."""
    return [next(same) for _, same in groupby(rows, key=lambda row: row[1:])]


def _step(cause: Cause) -> Json:
    """Return a step as it is shown; of a single instruction its program has no name."""
    alone = cause.program == ALONE
    text = one_line(cause.span.text.strip())[:LONGEST_LINE]
    return {
        "program": "" if alone else cause.program,
        "line": 0 if alone else cause.step,
        "at": 0 if alone else cause.span.line,  # line of its file
        "text": text,
    }


def _poses(poses: Iterator[tuple[float, Pose]]) -> list[Json]:
    return [
        {"start": next(same)[0], "X": pose_numbers(X)}
        for X, same in groupby(poses, key=lambda row: row[1])
    ]


def _outputs(run: Run, begin_s: float, until_s: float) -> list[tuple[float, int]]:
    """Return which outputs, 1 to 32, were on from when [s] on, as bits."""
    on = set(run.at(begin_s).signals)
    rows = [(begin_s, output_bits(on))]
    for event in run.events:
        if isinstance(event, SignalChanged) and begin_s < event.time_s <= until_s:
            (on.add if event.on else on.discard)(event.signal)
            rows.append((event.time_s, output_bits(on)))
    return rows


def _marks(run: Run, begin_s: float, until_s: float) -> tuple[list[Json], int]:
    """Return what happened, in time order, and how many rows more there were."""
    rows: list[Json] = [
        _mark(command.time_s, "panic", STOPPED, None)
        for command in run.history.issued
        if isinstance(command.command, Panic) and begin_s <= command.time_s < until_s
    ]
    alone = False  # what executes is a single instruction, whose beginning and end say nothing
    for event in run.events:
        if isinstance(event, ProgramStarted) and not event.process:
            alone = event.program == ALONE
        if alone and isinstance(event, ProgramStarted | ProgramEnded) and not event.process:
            continue
        if begin_s <= event.time_s < until_s and (row := event_text(event)) is not None:
            rows.append(_mark(event.time_s, *row, event.cause))
    rows.sort(key=lambda row: float(str(row["t"])))
    return rows[:MOST_MARKS], max(len(rows) - MOST_MARKS, 0)


def _mark(time_s: float, kind: str, text: str, cause: Cause | None) -> Json:
    known = cause is not None and cause.program != ALONE
    return {
        "t": time_s,
        "kind": kind,
        "text": text[:LONGEST_LINE],
        "program": cause.program if cause is not None and known else "",
        "line": cause.step if cause is not None and known else 0,
    }
