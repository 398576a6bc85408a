"""A run as the browser's replay takes it: segments to evaluate, not samples.

Every row has as many coefficients as it needs: most are constants, linear or cubic. They travel as
float32, in powers of the share of the segment that has passed, so none is out of range however
short a segment is: a joint at 3 rad is right to 0.2 µrad, the tool to 0.5 µm.
"""

import base64
import zlib
from collections.abc import Iterable, Sequence
from itertools import chain
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.source import SourceFile
from vrts.check.collision.of_run import motion_of
from vrts.check.verdict import ContactEvent, NearMiss
from vrts.engine.memory.events import Cause
from vrts.engine.memory.records import COORDINATES, GRAVITY, Placement, Segment
from vrts.engine.run import Run
from vrts.report.event_words import event_text
from vrts.report.page.replay_lanes import (
    by_process,
    line_of,
    process_lines,
    process_programs,
    robot_lines,
    signal_spans,
)
from vrts.report.page.viewer_data import Json, pose_numbers
from vrts.report.plain import one_line
from vrts.report.quantities import millimetres, seconds

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

MOST_EVENTS = 2000  # rows of the list
LEVEL = 1  # of zlib: higher ones save a hundredth of the bytes


def run_data(run: Run, source: SourceFile | None) -> Json:
    """Return everything a replay needs to answer any time, and the events to jump to."""
    return {
        "horizon": _end(run),
        "ended": run.ended_s,
        "gravity": GRAVITY,
        "segments": _segments(run),
        "motions": [{"start": seconds(m.start_s), "end": seconds(m.end_s)} for m in run.motions],
        "tools": _tools(run),
        "placements": {
            body: [placement_data(p) for p in placements]
            for body, placements in run.placements.items()
        },
        "lines": robot_lines(run, source),
        "processLines": process_lines(run, source),
        "signals": [{"signal": n, "on": on} for n, on in signal_spans(run).items()],
        "events": _event_rows(run, source),
    }


def contact_rows(contacts: Iterable[ContactEvent], source: SourceFile | None) -> list[Json]:
    """Return contact events for the time bar and the marks in the scene."""
    return [
        {
            "first": c.first,
            "second": c.second,
            "parts": list(c.parts),
            "text": contact_sentence(c),
            "start": seconds(c.start_s),
            "end": seconds(c.end_s),
            "deepest": seconds(c.deepest_s),
            "depthMm": millimetres(c.depth_m),
            "point": [round(x, 5) for x in c.point],
            "held": c.held,
            "line": _line(c.cause, source),
        }
        for c in contacts
    ]


def contact_sentence(c: ContactEvent) -> str:
    """Return `left finger touches base1, 3.1 mm deep`."""
    first, second = (one_line(part) for part in c.parts)
    return f"{first} touches {second}, {millimetres(c.depth_m):g} mm deep"


def near_rows(misses: Iterable[NearMiss], source: SourceFile | None) -> list[Json]:
    """Return near misses for the time bar and the events; the point lies between the two parts."""
    return [
        {
            "first": m.first,
            "second": m.second,
            "parts": list(m.parts),
            "text": near_sentence(m),
            "start": seconds(m.start_s),
            "end": seconds(m.end_s),
            "deepest": seconds(m.nearest_s),
            "distanceMm": millimetres(m.distance_m),
            "point": [round((a + b) / 2, 5) for a, b in zip(*m.witnesses, strict=True)],
            "held": m.held,
            "line": _line(m.cause, source),
        }
        for m in misses
    ]


def near_sentence(m: NearMiss) -> str:
    """Return `can1 passes base1 at 1.4 mm`."""
    first, second = (one_line(part) for part in m.parts)
    return f"{first} passes {second} at {millimetres(m.distance_m):g} mm"


def _end(run: Run) -> float:
    segments = run.timeline.segments
    last = segments[-1].end_s if segments else 0.0
    return run.horizon_s if run.horizon_s < float("inf") else max(last, run.ended_s or 0.0)


def segment_data(segments: Sequence[Segment]) -> Json:
    """Return polynomials that follow one another, at least one."""
    rows = [row for segment in segments for row in segment.coefficients]
    assert len(rows) == COORDINATES * len(segments)
    lengths = np.array([segment.end_s - segment.start_s for segment in segments])
    counts, coefficients = _of_share(rows, np.repeat(lengths, COORDINATES))
    knots = np.array([segments[0].start_s, *(segment.end_s for segment in segments)])
    return _sent(knots, counts, coefficients)


def _segments(run: Run) -> Json:
    """Return the same of a run, from the arrays that checks have made of it already."""
    segments, motion = run.timeline.segments_or_start, motion_of(run)
    if len(motion.starts) != len(segments):  # some take no time, and the arrays leave them out
        return segment_data(segments)
    table = motion.powers
    if motion.high is not None:
        high = motion.high.value.powers
        table = np.zeros((*table.shape[:2], high.shape[2]))
        table[:, :, : motion.powers.shape[2]] = motion.powers
        table[motion.high_at >= 0] = high
    table = table.reshape(len(segments) * COORDINATES, -1)
    each = np.repeat(motion.ends - motion.starts, COORDINATES)
    powers, scales = np.arange(table.shape[1]), np.ones(table.shape)
    for power in powers[1:].tolist():
        np.multiply(scales[:, power - 1], each, out=scales[:, power])
    last = np.where(table != 0.0, powers, 0).max(axis=1)
    sent = powers <= last[:, None]
    knots = np.concatenate([motion.starts[:1], motion.ends])
    return _sent(knots, last + 1, table[sent] * scales[sent])


def _sent(knots: Array, counts: Indices, coefficients: Array) -> Json:
    return {
        "knots": _packed(knots, "<f8"),
        "counts": _packed(counts, "u1"),
        "coefficients": _packed(coefficients, "<f4"),
    }


def _of_share(rows: Sequence[Sequence[float]], lengths: Array) -> tuple[Indices, Array]:
    """Return how many coefficients each row has, and all of them, in powers of t / length.

    Zeros at the end of a row are left out, but for its first coefficient.
    """
    counts = np.fromiter(map(len, rows), np.int64, len(rows))
    flat = np.fromiter(chain.from_iterable(rows), np.float64, int(counts.sum()))
    begins = np.cumsum(counts) - counts
    powers = np.arange(len(flat)) - np.repeat(begins, counts)
    last = np.maximum.reduceat(np.where(flat != 0.0, powers, 0), begins)
    sent = powers <= np.repeat(last, counts)
    flat, powers, lengths = flat[sent], powers[sent], np.repeat(lengths, counts)[sent]
    scales = np.ones(len(flat))
    for power in range(1, int(last.max()) + 1):
        higher = powers >= power
        scales[higher] *= lengths[higher]
    return last + 1, flat * scales


def _packed(numbers: Indices | Array, kind: str) -> str:
    """Return numbers of a kind, deflated (loops repeat themselves), in base64."""
    data = zlib.compress(numbers.astype(kind).tobytes(), LEVEL)
    return base64.b64encode(data).decode("ascii")


def _tools(run: Run) -> list[Json]:
    """Return the tool in force by time; a change shows from the motion that first uses it."""
    rows: list[Json] = []
    in_force = run.scene.X_FT
    for start_s, tool in ((0.0, in_force), *((m.start_s, m.X_FT) for m in run.motions)):
        if not rows or tool != in_force:
            rows.append({"start": start_s, "X": pose_numbers(tool)})
        in_force = tool
    return rows


def placement_data(p: Placement) -> Json:
    """Return how a body lies from a time on."""
    return {
        "start": p.start_s,
        "end": p.end_s if p.end_s < float("inf") else None,
        "lie": p.lie.value,
        "X": pose_numbers(p.X),
        "support": p.support,
    }


def _line(cause: Cause | None, source: SourceFile | None) -> int:
    return line_of(cause.span if cause else None, source)


def _event_rows(run: Run, source: SourceFile | None) -> list[Json]:
    """Return rows for the first events, and one that counts the rest (programs print at will)."""
    rows: list[Json] = []
    events, of_process = run.events, process_programs(run)
    for number, event in enumerate(events):
        if len(rows) == MOST_EVENTS:
            rest = f"{len(events) - number} more events are not listed"
            rows.append({"t": seconds(event.time_s), "kind": "note", "text": rest, "line": 0})
            break
        if (row := event_text(event)) is not None:
            kind, text = row
            line = _line(event.cause, source)
            fact: Json = {"t": seconds(event.time_s), "kind": kind, "text": text, "line": line}
            if by_process(event, of_process):
                fact["process"] = True
            rows.append(fact)
    return rows
