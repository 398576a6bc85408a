"""When each motion of a program ends, from a run within bounds.

`python -m vrts.lsp.timing` reads one JSON document from stdin and writes one to stdout, so that
the server never waits for a run and loses nothing with it.
"""

import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

MOST_TIMES = 3  # of one step that are told
_STATEMENTS, _MOTIONS, _SIMULATED_S, _CPU_S = 200_000, 5_000, 600.0, 20


class Timing(NamedTuple):
    """The motions of one line."""

    line: int  # from 1
    ends_s: tuple[float, ...]  # the first few times, since the program began [s]
    takes_s: float  # how long the first one takes [s]
    times: int  # how often the line moved the arm


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
    by_line: dict[int, list[tuple[float, float]]] = {}
    for motion in run.motions:
        span = motion.cause.span
        if span.source.name == path:
            times = motion.start_s - run.started_s, motion.end_s - run.started_s
            by_line.setdefault(span.line, []).append(times)
    return [
        Timing(line, tuple(end for _, end in m[:MOST_TIMES]), m[0][1] - m[0][0], len(m))
        for line, m in sorted(by_line.items())
    ]


def hint(timing: Timing) -> str:
    """Return what to show behind a motion."""
    shown = ", ".join(f"{end:.1f}" for end in timing.ends_s)
    return f"{shown}{' ...' if timing.times > len(timing.ends_s) else ''} s"


def main() -> None:
    """Answer one request."""
    from vrts.marking.supervise.limits import Limits, impose

    asked = json.loads(sys.stdin.read())
    impose(Limits(cpu_s=_CPU_S))
    found = timings(asked["path"], asked["text"], [(p, t) for p, t in asked["others"]])
    json.dump(found, sys.stdout)


if __name__ == "__main__":
    main()
