"""In which laboratory a task is set, before anything else of it is read."""

from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml


def lab_name(source: SourceFile) -> str | None:
    """Return the file named by `lab` in `[task]`; None where it names none, or no text.

    What is wrong there is told when the task is read.
    """
    top, _ = read_toml(source)
    section = None if top is None else top.table("task")
    return None if section is None else section.string("lab")
