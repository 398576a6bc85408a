"""Programs run without a task, and the files of their runs: read here, and made into bytes.

What is wrong in a saved run is a diagnostic, raised as `Refused`.
"""

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeVar

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.pipeline.assess import no_program, scenario_for, without_repeats
from vrts.pipeline.files import CannotRead, find_scene
from vrts.pipeline.programs import STRICT, Reading, compile_bytes
from vrts.pipeline.settings import Refused, Setting

if TYPE_CHECKING:
    from vrts.engine.run import Run
    from vrts.engine.storage.load import SavedRun
    from vrts.engine.storage.origin import Origin, SceneText
    from vrts.ir.module import Module
    from vrts.lang.compiler import Compilation
    from vrts.scene.model import Scene


Value = TypeVar("Value")

MOST_NOTES = 3


class Simulated(NamedTuple):
    """A program that was executed, as far as it could be."""

    run: "Run | None"
    origin: "Origin | None"  # what a file of the run has to tell
    diagnostics: tuple[Diagnostic, ...]  # of the compiler, then of the run


def simulate(
    data: bytes,
    name: str,
    setting: Setting,
    *,
    entry: str | None = None,
    reading: Reading = STRICT,
) -> Simulated:
    """Compile and execute a program, without judging it.

    Args:
        data: The bytes of the program.
        name: As shown.
        setting: Scene, and scenario if there is one.
        entry: Program to execute; None: the first.
        reading: Dialect, and files compiled together with the program.
    """
    from vrts.engine.controller import execute
    from vrts.engine.storage.origin import Origin, Programs

    source, compilation, found = compile_bytes(data, name, reading)
    if source is None or compilation is None or compilation.module is None:
        return Simulated(None, None, found)
    module = compilation.module
    if module.main is None:
        return Simulated(None, None, found)
    if entry is not None and entry.lower() not in module.programs:
        return Simulated(None, None, (*found, no_program(module, entry)))
    run = execute(
        module, setting.scene, scenario_for(None, setting.scenario), entry and entry.lower()
    )
    programs = Programs(
        _files(compilation), compilation.dialect.name, reading.precedence, reading.replace
    )
    kept = without_repeats(found, run.findings)
    return Simulated(run, Origin(programs, _scene_text(setting)), (*kept, *run.findings))


def saved_bytes(simulated: Simulated) -> bytes:
    """Return the file of a run.

    Raises:
        Refused: It cannot be saved.
    """
    from vrts.engine.storage.save import run_bytes

    assert simulated.run is not None
    assert simulated.origin is not None
    found = run_bytes(simulated.run, simulated.origin)
    if isinstance(found, Diagnostic):
        raise Refused((found,))
    return found


def load_run(data: bytes, name: str, folder: Path | None = None) -> Simulated:
    """Return the run of a file, without executing anything.

    Args:
        data: The bytes of the file.
        name: As shown.
        folder: Where files that its scene names may be.

    Raises:
        Refused: The file is not sound, or its programs and scene cannot be made again.
    """
    from vrts.engine.storage.load import opened, restored

    saved = _accepted(opened(data, name))
    module = _module(saved)
    scene = _scene(saved, folder)
    run = _accepted(restored(saved, module, scene))
    return Simulated(run, saved.origin, run.findings)


def executed_again(loaded: Simulated) -> "Run":
    """Return a saved run as executing everything makes it now: one that can be advanced."""
    from vrts.engine.controller import advance, start

    run = loaded.run
    assert run is not None
    begun = start(run.module, run.scene, run.scenario)
    history = run.history
    return advance(begun, run.until_s, history.issued, closed=history.closed)


def check_again(loaded: Simulated) -> Diagnostic | None:
    """Execute the programs of a saved run again; return how that differs, if it does."""
    from vrts.engine.storage.compare import difference

    assert loaded.run is not None
    return difference(loaded.run, executed_again(loaded))


def _accepted(found: "Value | Diagnostic") -> "Value":
    if isinstance(found, Diagnostic):
        raise Refused((found,))
    return found


def _scene_text(setting: Setting) -> "SceneText":
    from vrts.engine.storage.origin import SceneText

    source = setting.scene_source
    if source is None:
        return SceneText(setting.scene.name.removesuffix(" alone"), None, setting.scene.digest)
    return SceneText(source.name, source.text, setting.scene.digest)


def _module(saved: "SavedRun") -> "Module":
    from vrts.engine.storage.damage import not_remade
    from vrts.lang.compiler import Options, compile_sources
    from vrts.lang.dialect import DIALECTS, Precedence

    programs = saved.origin.programs
    dialect = DIALECTS.get(programs.dialect)
    module = None
    if dialect is not None:
        precedence = None if programs.precedence is None else Precedence(programs.precedence)
        options = Options(dialect, precedence, programs.replace)
        module = compile_sources(programs.sources, options).module
    if module is None or module.main is None:
        raise Refused((not_remade(saved.name, "its programs cannot be compiled any more"),))
    return module


def _files(compilation: "Compilation") -> tuple[SourceFile, ...]:
    """Return every text that was compiled."""
    from vrts.lang.joined import Joined

    source = compilation.source
    assert source is not None
    return source.files if isinstance(source, Joined) else (source,)


def _scene(saved: "SavedRun", folder: Path | None) -> "Scene":
    """Return the scene of a saved run, with files that it names from where they are found."""
    from vrts.engine.storage.damage import not_remade
    from vrts.scene.default import robot_alone
    from vrts.scene.reading.scene_file import read_scene, scene_name

    said = saved.origin.scene
    if said.text is None:
        try:
            return robot_alone(said.name)
        except KeyError as missing:
            what = f"there is no robot `{said.name}`"
            raise Refused((not_remade(saved.name, what),)) from missing
    source = SourceFile(said.name, said.text)
    places = [folder, Path(said.name).parent, _library_folder(scene_name(said.name))]
    scene, found = None, ()
    for place in places:
        scene, found = read_scene(source, place)
        if scene is not None and scene.digest == said.digest:
            return scene
    if scene is None:
        errors = [problem.headline for problem in found if problem.is_error]
        raise Refused((not_remade(saved.name, "its scene cannot be read", *errors[:MOST_NOTES]),))
    return scene


def _library_folder(name: str) -> Path | None:
    try:
        return find_scene(name).parent
    except CannotRead:
        return None
