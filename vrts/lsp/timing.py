"""When each motion of a program ends and how near it comes, from a run within bounds.

`python -m vrts.lsp.timing` reads one JSON document from stdin and writes one to stdout, so that
the server never waits for a run and loses nothing with it.
"""

import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from vrts.engine.run import Run
    from vrts.pipeline.settings import Setting

MOST_TIMES = 3  # of one step that are told
_STATEMENTS, _MOTIONS, _SIMULATED_S, _CPU_S = 200_000, 5_000, 600.0, 20
STEP_S = 0.05  # between samples of the clearance
_SAMPLES = 1000


class Timing(NamedTuple):
    """The motions of one line."""

    line: int  # from 1
    ends_s: tuple[float, ...]  # the first few times, since the program began [s]
    takes_s: float  # how long the first one takes [s]
    times: int  # how often the line moved the arm
    clearance_mm: float | None = None  # the least that was sampled; None: far, or no scene


def timings(path: str, text: str, others: list[tuple[str, str]]) -> list[Timing]:
    """Run a program where its task says; return the motions by the lines of its own file.

    Args:
        path: Of the program; a task beside it tells scene and scenario.
        text: Of the buffer.
        others: Paths and texts of the files that belong together with it.
    """
    from vrts.engine.controller import execute
    from vrts.pipeline.assess import scenario_for
    from vrts.pipeline.files import CannotRead
    from vrts.pipeline.programs import ProgramFile, Reading, compile_bytes
    from vrts.pipeline.settings import Refused, robot_alone, setting_for

    try:
        setting = setting_for(Path(path)) or robot_alone()
    except (CannotRead, Refused):
        return []  # `vrts verify` says what is wrong with the task
    files = tuple(ProgramFile(t.encode("utf-8", "replace"), p) for p, t in others)
    data = text.encode("utf-8", "replace")
    compilation = compile_bytes(data, path, Reading(None, others=files)).compilation
    module = compilation.module if compilation is not None else None
    entry = setting.task.program if setting.task is not None else None
    if module is None or module.main is None:
        return []
    if entry is not None and entry.lower() not in module.programs:
        return []
    scenario = scenario_for(setting.task, setting.scenario)
    bounds = scenario.limits
    limits = replace(
        bounds,
        statements=min(bounds.statements, _STATEMENTS),
        motions=min(bounds.motions, _MOTIONS),
        time_s=min(bounds.time_s, _SIMULATED_S),
    )
    run = execute(
        module, setting.scene, replace(scenario, limits=limits), entry.lower() if entry else None
    )
    curve = _clearance_curve(setting, run)
    by_line: dict[int, list[tuple[float, float]]] = {}
    for motion in run.motions:
        span = motion.cause.span
        if span.source.name == path:
            times = motion.start_s - run.started_s, motion.end_s - run.started_s
            by_line.setdefault(span.line, []).append(times)
    return [
        Timing(
            line,
            tuple(end for _, end in moved[:MOST_TIMES]),
            moved[0][1] - moved[0][0],
            len(moved),
            _least(curve, moved),
        )
        for line, moved in sorted(by_line.items())
    ]


def _clearance_curve(setting: "Setting", run: "Run") -> list[tuple[float, float]]:
    """Return times since the program began [s] and clearances [mm]; none without a task."""
    if setting.task is None or run.horizon_s <= 0.0:
        return []
    import numpy as np

    from vrts.base.units import mm
    from vrts.check.clearance_curve import FAR, clearance_curve

    count = min(int(run.horizon_s / STEP_S) + 2, _SAMPLES)
    times = np.linspace(0.0, run.horizon_s, count)
    values = clearance_curve(setting.scene, run, times, setting.task.near_miss)
    rows = zip(times.tolist(), values.tolist(), strict=True)
    return [(time - run.started_s, mm(value)) for time, value in rows if value < FAR]


def _least(curve: list[tuple[float, float]], moved: list[tuple[float, float]]) -> float | None:
    """Return the least clearance [mm] sampled during some motions."""
    inside = (value for time, value in curve if any(start <= time <= end for start, end in moved))
    return min(inside, default=None)


def hint(timing: Timing) -> str:
    """Return what to show behind a motion."""
    shown = ", ".join(f"{end:.1f}" for end in timing.ends_s)
    text = f"{shown}{' ...' if timing.times > len(timing.ends_s) else ''} s"
    near = timing.clearance_mm
    return text if near is None else f"{text}, {near:.0f} mm"


def main() -> None:
    """Answer one request."""
    from vrts.marking.supervise.limits import Limits, impose

    asked = json.loads(sys.stdin.read())
    impose(Limits(cpu_s=_CPU_S))
    found = timings(asked["path"], asked["text"], [(p, t) for p, t in asked["others"]])
    json.dump(found, sys.stdout)


if __name__ == "__main__":
    main()
