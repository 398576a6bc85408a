"""Runs from the bytes of their files, and executed again."""

from collections.abc import Mapping
from pathlib import Path
from typing import TypeVar

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.controllers.models import MODELS
from vrts.controllers.values import digest
from vrts.engine.controller import advance, start
from vrts.engine.run import Run
from vrts.engine.storage.compare import difference
from vrts.engine.storage.damage import not_remade
from vrts.engine.storage.load import SavedRun, opened, restored
from vrts.ir.module import Module
from vrts.lang.compiler import Options, compile_sources
from vrts.lang.dialect import DIALECTS, Precedence
from vrts.pipeline.files import CannotRead, asked_scene
from vrts.pipeline.refused import Refused
from vrts.report.plain import one_line
from vrts.run_files.simulated import Simulated, told_of
from vrts.scene.default import robot_alone
from vrts.scene.model import Scene, controlled
from vrts.scene.reading.scene_file import read_scene, scene_name

Value = TypeVar("Value")

MOST_NOTES = 3


def load_run(data: bytes, name: str, folder: Path | None = None) -> Simulated:
    """Return the run of a file, without executing anything.

    Args:
        data: The bytes of the file.
        name: As shown.
        folder: Where files that its scene names may be.

    Raises:
        Refused: The file is not sound, or its programs and scene cannot be made again.
    """
    saved = _accepted(opened(data, name))
    module, scene = made_again(saved, folder)
    run = _accepted(restored(saved, module, scene))
    return Simulated(run, saved.origin, told_of(run))


def made_again(
    saved: SavedRun, folder: Path | None, files: Mapping[str, bytes] | None = None
) -> tuple[Module, Scene]:
    """Return the programs of a saved run, compiled again, and its scene, read again.

    Args:
        saved: What is known of the run.
        folder: Where files that its scene names may be.
        files: Those that it names, where they came with it; then no folder is opened.

    Raises:
        Refused: They cannot be made again.
    """
    return _module(saved), _controlled(saved, _scene(saved, folder, files))


def executed_again(loaded: Simulated) -> Run:
    """Return a saved run as executing everything makes it now: one that can be advanced."""
    run = loaded.run
    assert run is not None
    begun = start(run.module, run.scene, run.scenario)
    history = run.history
    return advance(begun, run.until_s, history.issued, closed=history.closed)


def check_again(loaded: Simulated) -> Diagnostic | None:
    """Execute the programs of a saved run again; return how that differs, if it does."""
    assert loaded.run is not None
    return difference(loaded.run, executed_again(loaded))


def _accepted(found: Value | Diagnostic) -> Value:
    if isinstance(found, Diagnostic):
        raise Refused((found,))
    return found


def _module(saved: SavedRun) -> Module:

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


def _scene(saved: SavedRun, folder: Path | None, files: Mapping[str, bytes] | None) -> Scene:
    """Return the scene of a saved run, with files that it names from where they are found."""
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
    for place in places if files is None else [None]:
        scene, found = read_scene(source, place, files=files)
        if scene is not None and scene.digest == said.digest:
            return scene
    if scene is None:
        errors = [problem.headline for problem in found if problem.is_error]
        raise Refused((not_remade(saved.name, "its scene cannot be read", *errors[:MOST_NOTES]),))
    return scene


def _controlled(saved: SavedRun, scene: Scene) -> Scene:
    """Return the scene under the controller model that the run went by.

    Raises:
        Refused: There is no such model, or it says something else now.
    """
    said = saved.origin.scene
    own = scene.controller
    model = own if own.name == said.controller else MODELS.get(said.controller)
    if model is None:
        what = f"there is no controller model `{one_line(said.controller)}`"
        raise Refused((not_remade(saved.name, what, f"known are {', '.join(MODELS)}"),))
    if digest(model) != said.controller_digest:
        what = f"the controller model `{model.name}` says something else now"
        raise Refused((not_remade(saved.name, what),))
    return controlled(scene, model)


def _library_folder(name: str) -> Path | None:
    try:
        return asked_scene(name).parent
    except CannotRead:
        return None
