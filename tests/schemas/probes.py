"""Files of every kind, read by their own readers."""

from collections.abc import Callable, Mapping
from pathlib import Path

from tests.places import ROOT
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.check.task.task_file import read_task
from vrts.ir.system import PARAMETERS
from vrts.prove.environment.reading import read_environment, read_inner
from vrts.scene.model import Scene
from vrts.scene.reading.scenario_file import read_scenario
from vrts.scene.reading.scene_file import read_scene, read_scene_in_lab
from vrts.schemas import KINDS
from vrts.validate.log.columns_file import ChosenColumns, read_columns

__all__ = ["KINDS", "PROBES", "READERS", "errors", "library", "scene_of", "source_of"]

PROBES = Path(__file__).parent / "probes"
IN_LAB = "cans-on-bases"  # the scene that labs are laid over


def library(name: str) -> Path:
    """Return the file of a scene of the library."""
    return ROOT / "scenes" / name / "scene.toml"


def source_of(path: Path) -> SourceFile:
    """Return a file as text."""
    return SourceFile(str(path), path.read_text("utf-8"))


def scene_of(path: Path) -> Scene:
    """Return a scene that is known to be right."""
    scene, found = read_scene(source_of(path), path.parent)
    assert scene is not None, found
    return scene


def errors(kind: str, source: SourceFile, scene: Scene | None, folder: Path) -> list[Diagnostic]:
    """Return what a reader has against a file.

    Args:
        kind: One of `KINDS`.
        source: The file.
        scene: In which a task or a scenario is set.
        folder: Where what the file names is.
    """
    found = READERS[kind](source, scene, folder)
    if kind == "task" and scene is not None:
        found += _inner(source, scene)
    return [one for one in found if one.is_error]


def _inner(source: SourceFile, scene: Scene) -> tuple[Diagnostic, ...]:
    """Return what is said of an environment that stands in a task: it is read when it is proven."""
    task, _ = read_task(source, scene)
    if task is None or task.proof is None or not task.proof.inline:
        return ()
    return read_inner(source, ("prove", "environment"))[1]


def _scene(source: SourceFile, scene: Scene | None, folder: Path) -> tuple[Diagnostic, ...]:
    return read_scene(source, folder)[1]


def _lab(source: SourceFile, scene: Scene | None, folder: Path) -> tuple[Diagnostic, ...]:
    below = library(IN_LAB)
    return read_scene_in_lab(source_of(below), source, below.parent, folder)[1]


def _task(source: SourceFile, scene: Scene | None, folder: Path) -> tuple[Diagnostic, ...]:
    assert scene is not None
    return read_task(source, scene)[1]


def _scenario(source: SourceFile, scene: Scene | None, folder: Path) -> tuple[Diagnostic, ...]:
    assert scene is not None
    return read_scenario(source, scene, sorted(PARAMETERS.keys() - {"NEST.POS"}))[1]


def _environment(source: SourceFile, scene: Scene | None, folder: Path) -> tuple[Diagnostic, ...]:
    return read_environment(source)[1]


def _columns(source: SourceFile, scene: Scene | None, folder: Path) -> tuple[Diagnostic, ...]:
    found = read_columns(source)
    return () if isinstance(found, ChosenColumns) else found


Reader = Callable[[SourceFile, Scene | None, Path], tuple[Diagnostic, ...]]
READERS: Mapping[str, Reader] = {
    "scene": _scene,
    "lab": _lab,
    "task": _task,
    "scenario": _scenario,
    "environment": _environment,
    "columns": _columns,
}
