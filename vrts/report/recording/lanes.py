"""States that follow one another: the line at work, what the hand holds, signals."""

from collections.abc import Sequence

import rerun as rr

from vrts.engine.memory.records import Lie
from vrts.report.assessment import Assessment
from vrts.report.page.replay_lanes import Rows, process_lines, robot_lines, signal_spans
from vrts.report.plain import one_line
from vrts.report.recording.names import at_times


def send_lanes(a: Assessment) -> None:
    """Send one lane for each."""
    assert a.run is not None
    _lane("program", _lines(a, robot_lines(a.run, a.source)))
    _lane("process", _lines(a, process_lines(a.run, a.source)))
    held = [
        (p.start_s, p.end_s, one_line(body))
        for body, track in a.run.placements.items()
        for p in track
        if p.lie is Lie.HELD
    ]
    _lane("gripper", states(held, "empty", a.run.horizon_s))
    for number, on in signal_spans(a.run).items():
        spans = [(start, end, "on") for start, end in on]
        _lane(f"signal_{number}", states(spans, "off", a.run.horizon_s))


def numbered_line(a: Assessment, line: int) -> str:
    """Return `12  MOVES part`, as an editor shows it."""
    assert a.source is not None
    return f"{line}  {one_line(a.source.line_text(line).strip())}"


def states(
    spans: Sequence[tuple[float, float, str]], otherwise: str, end_s: float
) -> list[tuple[float, str]]:
    """Return the changes of state: the words of every span, and another word between them."""
    changes = {0.0: otherwise}
    for start, end, words in sorted(spans):
        changes[start] = words
        if end < end_s:
            changes[end] = otherwise
    return sorted(changes.items())


def _lines(a: Assessment, rows: Rows) -> list[tuple[float, str]]:
    return [(time_s, numbered_line(a, line)) for time_s, line in rows]


def _lane(name: str, rows: Sequence[tuple[float, str]]) -> None:
    if rows:
        rr.send_columns(
            f"lanes/{name}",
            at_times([time_s for time_s, _ in rows]),
            rr.StateChange.columns(state=[words for _, words in rows]),
        )
