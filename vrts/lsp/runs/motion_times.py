"""The motions of a run by the lines that gave them, with clearances sampled meanwhile."""

import numpy as np

from vrts.base.units import mm
from vrts.check.collision.clearance_curve import FAR, clearance_curve
from vrts.engine.run import Run
from vrts.lsp.channel.timing import MOST_TIMES, STEP_S, Timing
from vrts.pipeline.setting import Setting

_SAMPLES = 1000


def timings(setting: Setting, run: Run, path: str, *, near: bool) -> tuple[Timing, ...]:
    """Return the motions of a run by the lines of one file.

    Args:
        setting: What was run in.
        run: What happened.
        path: Of the file.
        near: Whether to measure clearances.
    """
    curve = _clearance_curve(setting, run) if near else []
    by_line: dict[int, list[tuple[float, float]]] = {}
    for motion in run.motions:
        span = motion.cause.span
        if span.source.name == path:
            times = motion.start_s - run.started_s, motion.end_s - run.started_s
            by_line.setdefault(span.line, []).append(times)
    return tuple(
        Timing(
            line,
            tuple(end for _, end in moved[:MOST_TIMES]),
            moved[0][1] - moved[0][0],
            len(moved),
            _least(curve, moved),
        )
        for line, moved in sorted(by_line.items())
    )


def _clearance_curve(setting: Setting, run: Run) -> list[tuple[float, float]]:
    """Return times since the program began [s] and clearances [mm]; none without a task."""
    if setting.task is None or run.horizon_s <= 0.0:
        return []
    count = min(int(run.horizon_s / STEP_S) + 2, _SAMPLES)
    times = np.linspace(0.0, run.horizon_s, count)
    values = clearance_curve(setting.scene, run, times, setting.task.near_miss)
    rows = zip(times.tolist(), values.tolist(), strict=True)
    return [(time - run.started_s, mm(value)) for time, value in rows if value < FAR]


def _least(curve: list[tuple[float, float]], moved: list[tuple[float, float]]) -> float | None:
    """Return the least clearance [mm] sampled during some motions."""
    inside = (value for time, value in curve if any(start <= time <= end for start, end in moved))
    return min(inside, default=None)
