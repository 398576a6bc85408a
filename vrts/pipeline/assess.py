"""One program compiled, executed, checked and marked: the stages composed, each at most once."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.pipeline.files import CannotRead, read_bytes, scene_names, shown
from vrts.pipeline.programs import STRICT, Reading, compile_bytes
from vrts.pipeline.settings import Setting, setting_for

if TYPE_CHECKING:
    from vrts.check.task.task import Task
    from vrts.ir.module import Module
    from vrts.report.assessment import Assessment
    from vrts.scene.model import Scenario
    from vrts.scene.reading.scenario_file import ScenarioFile

NO_SUCH_PROGRAM = Rule("V190", "no-such-program")
CURVE_STEP = 0.15  # [s] between samples of the clearance, for charts
CURVE_MOST = 400  # samples


def assess(
    program: Path | bytes,
    *,
    scene: str | None = None,
    task: Path | None = None,
    setting: Setting | None = None,
    identifier: str | None = None,
    title: str | None = None,
    collisions: bool = True,
    engine: str | None = None,
    judged: bool = True,
    entry: str | None = None,
    curve: bool = False,
    reading: Reading = STRICT,
    step_done: Callable[[str], None] = lambda _: None,
) -> "Assessment":
    """Compile, run, check and mark one program.

    Args:
        program: Its file, or its bytes.
        scene: Name or path of the scene; None: the task's.
        task: The task file; None: the one beside the program, or none.
        setting: Scene and task already read, in place of the two above.
        identifier: Safe for file names; None: the stem of the file.
        title: As shown; None: the name of the file.
        collisions: Whether to check them.
        engine: Name of what measures distances; None: the most exact there is.
        judged: Whether to check and mark at all.
        entry: Program to execute; None: the task's, else the first.
        curve: Whether to sample the clearance over time, for charts.
        reading: Dialect, and files compiled together with the program.
        step_done: Told the name of every stage that is done.

    Raises:
        CannotRead: A file is not there, or nothing says which scene to take.
        Refused: Scene or task have errors.
    """
    from vrts.report.assessment import Assessment

    path = program if isinstance(program, Path) else None
    data = read_bytes(program) if isinstance(program, Path) else program
    if setting is None:
        setting = setting_for(path, scene=scene, task=task)
    if setting is None:
        raise CannotRead(
            "nothing says in which scene to verify the program",
            (
                "give `--scene NAME`, or put a `task.toml` beside it",
                f"scenes: {', '.join(scene_names())}",
            ),
        )
    name = title or (shown(path) if path is not None else "program")
    source, compilation, diagnostics = compile_bytes(data, name, reading)
    step_done("compile")
    start = Assessment(
        identifier or (path.stem if path is not None else "program"),
        name if title or path is None else path.name,
        source,
        (*setting.stamps, *diagnostics),
        scene=setting.scene,
        task=setting.task,
    )
    if compilation is None or compilation.module is None or compilation.module.main is None:
        return _ungraded(start)
    start = replace(start, module=compilation.module)
    found = _run(
        start,
        scenario_for(setting.task, setting.scenario),
        judged=judged,
        collisions=collisions,
        engine=engine,
        entry=entry,
        step_done=step_done,
    )
    return with_curve(found) if curve and judged and collisions else found


def _run(
    a: "Assessment",
    scenario: "Scenario",
    *,
    judged: bool,
    collisions: bool,
    engine: str | None,
    entry: str | None,
    step_done: Callable[[str], None],
) -> "Assessment":
    from vrts.engine.controller import execute

    assert a.module is not None
    assert a.scene is not None
    name = entry or (a.task.program if a.task else None)
    if name is not None and name.lower() not in a.module.programs:
        missing = no_program(a.module, name)
        return _ungraded(replace(a, diagnostics=(*a.diagnostics, missing)))
    run = execute(a.module, a.scene, scenario, name.lower() if name else None)
    step_done("simulate")
    scene, task = a.scene, a.task
    a = replace(a, run=run, diagnostics=without_repeats(a.diagnostics, run.findings))
    if not judged:
        return a
    from vrts.check.judge import judge

    judgement = judge(scene, run, task, collisions=collisions, engine=engine)
    step_done("check")
    a = replace(a, judgement=judgement)
    if task is None:
        return a
    from vrts.check.mark.mark import grade

    return replace(a, grade=grade(task, run, judgement))


def with_curve(a: "Assessment") -> "Assessment":
    """Return the assessment with the clearance of its run over time."""
    if a.run is None or a.scene is None or a.run.horizon_s <= 0.0:
        return a
    import numpy as np

    from vrts.check.collision.clearance_curve import clearance_curve

    count = min(int(a.run.horizon_s / CURVE_STEP) + 2, CURVE_MOST)
    times = np.linspace(0.0, a.run.horizon_s, count)
    values = clearance_curve(a.scene, a.run, times, a.task.near_miss if a.task else None)
    return replace(a, clearance=tuple(zip(times.tolist(), values.tolist(), strict=True)))


def scenario_for(task: "Task | None", planned: "ScenarioFile | None" = None) -> "Scenario":
    """Return the scenario of a run: where there is a task, it is stopped at its longest time."""
    from vrts.scene.model import Scenario

    scenario = Scenario() if planned is None else planned.scenario
    if task is None:
        return scenario
    limits = replace(scenario.limits, time_s=min(scenario.limits.time_s, task.t_max))
    return replace(scenario, limits=limits)


def _ungraded(a: "Assessment") -> "Assessment":
    from vrts.check.mark.grade import Status
    from vrts.check.mark.mark import ungraded

    if a.task is None:
        return a
    status = Status.UNREADABLE if a.source is None else Status.DOES_NOT_COMPILE
    return replace(a, grade=ungraded(status, a.diagnostics))


def no_program(module: "Module", name: str) -> Diagnostic:
    """Return what to say when a program to execute is not among those of a module."""
    return error(
        NO_SUCH_PROGRAM,
        f"there is no program `{name}` to execute",
        help=(f"programs in the file: {', '.join(module.programs)}",),
    )


def without_repeats(
    compiled: tuple[Diagnostic, ...], run: tuple[Diagnostic, ...]
) -> tuple[Diagnostic, ...]:
    """Drop warnings of the compiler about a name whose run-time error says the same."""
    named = {d.data["name"] for d in run if d.is_error and "name" in d.data}
    return tuple(d for d in compiled if d.is_error or d.data.get("name") not in named)
