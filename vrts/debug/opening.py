"""A debugging session ready to begin: program, scene and what happens in it, run to its end."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.remembered import Memory
from vrts.base.source import SourceFile
from vrts.check.rules.hints import Hints
from vrts.debug.console import Console
from vrts.debug.debugger import Debugger
from vrts.debug.files import Files
from vrts.debug.marks.links import Opener
from vrts.debug.marks.marks import SUFFIX, Marks
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.controllers import with_controller
from vrts.pipeline.execution import executed
from vrts.pipeline.files import SCENARIO_FILE, TASK_FILE, read_bytes
from vrts.pipeline.finding.task_of import task_of
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import ANYWHERE, Where


class Asked(NamedTuple):
    """What is to be debugged, and where."""

    program: Path
    where: Where = ANYWHERE  # without scene and task: the task beside it, else the robot alone
    entry: str | None = None  # program to execute; None: the task's, else the main one
    others: tuple[Path, ...] = ()  # compiled together with the program
    dialect: str | None = None  # None: as file name and content tell


class Opened(NamedTuple):
    """A session; without a debugger the program could not be executed."""

    debugger: Debugger | None
    console: Console | None
    sources: tuple[SourceFile, ...]  # named by their absolute paths
    diagnostics: tuple[Diagnostic, ...]
    files: Files


def opened(asked: Asked, near_miss_m: float | None = None) -> Opened:
    """Compile and execute a program.

    Args:
        asked: Which program, and where.
        near_miss_m: How near a near miss is [m]; None: as the task says, or as assumed.

    Raises:
        CannotRead: A file or the scene is not there.
        Refused: Scene, task, scenario or lab have errors.
    """
    path = asked.program.resolve()
    where = asked.where
    setting = setting_for(path, where) or with_controller(robot_alone(), where.controller)
    texts = [file.resolve() for file in (path, *asked.others)]
    files = Files(_read(asked, path, setting), texts)
    others = tuple(ProgramFile(read_bytes(p), str(p.resolve())) for p in asked.others)
    program = ProgramFile(read_bytes(path), str(path))
    reading = Reading(asked.dialect, others=others)
    request = Request(program, setting, reading, asked.entry)
    memory = Memory()
    with memory.in_use():
        found = executed(request)
    run, compilation, task = found.run, found.compiled.compilation, setting.task
    if run is None or compilation is None:
        return Opened(None, None, (), found.diagnostics, files)
    near = near_miss_m if task is None else task.near_miss
    hints = Hints.EDIT if task is None else task.hints
    told = None if hints is Hints.NOTHING else task  # where things belong is a hint
    debugger = Debugger(run, compilation.dialect, near, told, memory)
    sources = _sources(debugger)
    console = Console(debugger, path.parent, sources, hints, request, files)
    console.goals.marks = Marks(path.with_name(path.name + SUFFIX))
    console.marking.opener = opener_of(asked)
    return Opened(debugger, console, sources, found.diagnostics, files)


def why_not(diagnostics: Sequence[Diagnostic]) -> str:
    """Return in one line why nothing could be opened: the first error."""
    found = next((diagnostic for diagnostic in diagnostics if diagnostic.is_error), None)
    if found is None:
        return "there is no program to execute"
    where = f"line {found.primary.span.line}: " if found.primary is not None else ""
    return f"{where}{found.headline} ({found.rule.code})"


def opener_of(asked: Asked) -> Opener:
    """Return what opens the same again at a terminal, in whatever folder."""
    where = asked.where
    shown = [str(asked.program.resolve())]
    for name in ("scene", "task", "controller"):
        value = getattr(where, name)
        shown += [] if value is None else [f"--{name}", _absolute(value)]
    more: list[str] = []
    for name, value in (
        ("scenario", where.scenario),
        ("lab", where.lab),
        ("entry", asked.entry),
        ("dialect", asked.dialect),
        *(("with", other) for other in asked.others),
    ):
        more += [] if value is None else [f"--{name}", _absolute(value)]
    return Opener([*shown, *more], None if more else shown)


def _absolute(value: str | Path) -> str:
    """Return the name of a file from the root; any other name as it is."""
    return str(Path(value).resolve()) if Path(value).exists() else str(value)


def _read(asked: Asked, program: Path, setting: Setting) -> list[Path]:
    """Return the files that a session is made of."""
    found = [program, *asked.others]
    where = asked.where
    task = where.task or (task_of(program) if where.scene is None else None)
    if task is not None:
        folder = task if task.is_dir() else task.parent
        found += [folder / TASK_FILE if task.is_dir() else task, folder / SCENARIO_FILE]
    found += [path for path in (where.scenario, where.lab) if path is not None]
    if setting.scene_source is not None:
        found.append(Path(setting.scene_source.name))
    return [path.resolve() for path in found]


def _sources(debugger: Debugger) -> tuple[SourceFile, ...]:
    programs: Sequence[SourceFile] = [p.span.source for p in debugger.run.module.programs.values()]
    return tuple({source.name: source for source in programs}.values())
