"""Programs as commands are given them, and how they are to be read."""

from pathlib import Path
from typing import NoReturn

from vrts.api.given import Given
from vrts.cli.shared.console import fail, say
from vrts.cli.shared.options import Language
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.files import STDIN, read_bytes, read_stdin, shown
from vrts.pipeline.where import Where

__all__ = ["STDIN", "Given", "given_program", "reading_of"]


def given_program(name: str) -> Given:
    """Return a program by the name of its file; `-` is stdin.

    Raises:
        CannotRead: There is no such file, or stdin is too large.
    """
    if name == STDIN:
        return Given(ProgramFile(read_stdin(), "stdin"), None)
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


def tell_task(path: Path | None, where: Where) -> None:
    """Say by which task a program is taken, where nobody named one and it is not beside it."""
    from vrts.pipeline.finding.task_of import is_beside, task_of

    if path is None or where.task is not None or where.scene is not None:
        return
    task = task_of(path)
    if task is not None and not is_beside(task, path):
        say(f"by the task `{task}`")


def task_is_beside(path: Path | None) -> bool:
    """Return whether the task of a program stands in its folder."""
    from vrts.pipeline.finding.task_of import is_beside, task_of

    task = None if path is None else task_of(path)
    return path is not None and task is not None and is_beside(task, path)


def no_setting(path: Path | None, doing: str) -> NoReturn:
    """Say that nothing tells in which scene to do something, and what would.

    Args:
        path: Of the program; None: it came from stdin.
        doing: Such as "to verify the program".
    """
    from vrts.pipeline.files import TASK_FILE, scene_names

    hints = ("give `--scene NAME` or `--task FILE`", f"scenes: {', '.join(scene_names())}")
    beside = None if path is None else path.parent / TASK_FILE
    if beside is not None and beside.is_file():
        why = f"`{beside}` may have been handed in with it"
        hints = (f"if it is yours: `--task {beside}`", *hints)
    else:
        why = f"there is no {TASK_FILE} beside it or above it"
    fail(f"nothing says in which scene {doing}: {why}", hints)
