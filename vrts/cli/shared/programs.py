"""Programs as commands are given them, and how they are to be read."""

import sys
from pathlib import Path

from vrts.api.given import Given
from vrts.cli.shared.console import fail
from vrts.cli.shared.options import Language
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.files import read_bytes, shown
from vrts.pipeline.where import Where

__all__ = ["STDIN", "Given", "given_program", "reading_of", "require_scene_of_lab"]

STDIN = "-"


def given_program(name: str) -> Given:
    """Return a program by the name of its file; `-` is stdin.

    Raises:
        CannotRead: There is no such file.
    """
    if name == STDIN:
        return Given(ProgramFile(sys.stdin.buffer.read(), "stdin"), None)
    path = Path(name)
    return Given(ProgramFile(read_bytes(path), shown(path)), path)


def reading_of(language: Language, default: str = "auto") -> Reading:
    """Return how programs are to be read.

    Args:
        language: What the options say.
        default: The dialect where none is named; `auto` is as name and content tell.

    Raises:
        CannotRead: A file that belongs to the program is not there.
    """
    dialect = language.dialect or default
    files = tuple(given_program(name).program for name in language.others)
    known = None if dialect == "auto" else dialect
    return Reading(known, language.prec, language.replace, files)


def require_scene_of_lab(where: Where) -> None:
    """Refuse a lab without a scene that it is laid over."""
    if where.lab is not None and where.scene is None:
        fail("a lab is laid over a scene", ("give `--scene NAME`, too",))
