"""In which scene, laboratory and under which controller a task is set, before the rest is read."""

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml
from vrts.controllers.models import MODELS


def scene_name(source: SourceFile) -> tuple[str | None, tuple[Diagnostic, ...]]:
    """Return which scene a task is set in, with what is wrong there."""
    top, problems = read_toml(source)
    if top is None:
        return None, problems.in_order()
    section = top.table("task", required=True)
    name = section.string("scene", required=True) if section is not None else None
    return name, problems.in_order()


def lab_name(source: SourceFile) -> str | None:
    """Return the file named by `lab` in `[task]`; None where it names none, or no text.

    What is wrong there is told when the task is read.
    """
    top, _ = read_toml(source)
    section = None if top is None else top.table("task")
    return None if section is None else section.string("lab")


def controller_name(source: SourceFile) -> str | None:
    """Return the controller model named by `controller` in `[task]`; None where it names none.

    What is wrong there is told when the task is read.
    """
    top, _ = read_toml(source)
    section = None if top is None else top.table("task")
    named = None if section is None else section.string("controller")
    return named if named in MODELS else None
