"""What the lanes under the time bar show: lines at work, when signals were on, goals reached."""

from bisect import bisect_right

from vrts.base.source import SourceFile, Span
from vrts.check.goals.over_time import reached_over_time
from vrts.check.goals.reached import judged_at
from vrts.check.task.task import Task
from vrts.engine.memory.events import (
    Cause,
    Event,
    Landed,
    MotionEnded,
    MotionStarted,
    ProgramStarted,
    SignalChanged,
    Toppled,
)
from vrts.engine.run import Run
from vrts.report.quantities import seconds

Rows = list[tuple[float, int]]


def line_of(span: Span | None, source: SourceFile | None) -> int:
    """Return the line, from 1, of a span in the program shown; 0 when it lies elsewhere."""
    return span.line if span is not None and span.source is source else 0


def robot_lines(run: Run, source: SourceFile | None) -> Rows:
    """Return which line of the robot program is at work from when [s] on.

    That is the line of the motion under way, else of the last event. Where a corner is rounded,
    the next motion is under way from the instant the arm leaves the first line.
    """
    of_process = process_programs(run)
    marks = [(m.start_s, 1, line_of(m.cause.span, source)) for m in run.motions]
    busy = [(m.start_s, m.end_s) for m in run.motions]
    marks += [
        (event.time_s, 0, _line(event, source))
        for event in run.events
        if not isinstance(event, (MotionStarted, MotionEnded, Landed, Toppled))
        and not by_process(event, of_process)
        and not _under_way(busy, event.time_s)
    ]
    return _changes(marks)


def process_lines(run: Run, source: SourceFile | None) -> Rows:
    """Return which line of the process control program last did something, from when [s] on."""
    of_process = process_programs(run)
    marks = [
        (event.time_s, 0, _line(event, source))
        for event in run.events
        if by_process(event, of_process)
    ]
    return _changes(marks)


def process_programs(run: Run) -> frozenset[str]:
    """Return the programs that ran as process control programs and never as robot programs."""
    started = [event for event in run.events if isinstance(event, ProgramStarted)]
    robot = {event.program for event in started if not event.process}
    return frozenset(event.program for event in started if event.process) - robot


def by_process(event: Event, of_process: frozenset[str]) -> bool:
    """Return whether an instruction of a process control program caused an event."""
    return event.cause is not None and event.cause.program in of_process


def signal_spans(run: Run) -> dict[int, list[tuple[float, float]]]:
    """Return for every signal that changed the intervals in which it was on [s]."""
    changes: dict[int, list[tuple[float, bool]]] = {}
    for event in run.events:
        if isinstance(event, SignalChanged):
            changes.setdefault(event.signal, []).append((seconds(event.time_s), event.on))
    end = seconds(run.horizon_s)
    return {number: _on(rows, end) for number, rows in sorted(changes.items())}


def _on(changes: list[tuple[float, bool]], end: float) -> list[tuple[float, float]]:
    """Return the intervals in which a signal was on; before its first change it was the other."""
    spans: list[tuple[float, float]] = []
    since = None if changes[0][1] else 0.0
    for time_s, on in changes:
        if on and since is None:
            since = time_s
        elif not on and since is not None:
            spans.append((since, time_s))
            since = None
    return spans if since is None else [*spans, (since, end)]


def _changes(marks: list[tuple[float, int, int]]) -> Rows:
    rows: Rows = []
    for exact, _, line in sorted(marks):
        time_s = seconds(exact)
        if rows and rows[-1][0] == time_s:
            rows.pop()  # of steps without duration only the last shows
        if line and (not rows or rows[-1][1] != line):
            rows.append((time_s, line))
    return rows


def _line(event: Event, source: SourceFile | None) -> int:
    cause: Cause | None = event.cause
    return line_of(cause.span if cause else None, source)


def _under_way(busy: list[tuple[float, float]], time_s: float) -> bool:
    at = bisect_right(busy, time_s, key=lambda motion: motion[0]) - 1
    return at >= 0 and time_s < busy[at][1]


def goal_times(run: Run, task: Task | None) -> dict[str, object]:
    """Return when goals are reached, as the picture beside the text of an editor takes it.

    There is a row for each place that is drawn: a goal that may be reached in several ways has
    several, which share its times [s].
    """
    if task is None:
        return {}
    spans = reached_over_time(run, task)
    rows = [
        {"title": goal.title, "spans": [[seconds(start), seconds(end)] for start, end in of_goal]}
        for goal, of_goal in zip(task.goals, spans, strict=True)
        for _ in goal.choices
    ]
    return {"reached": rows, "judged": seconds(judged_at(run, task))}
