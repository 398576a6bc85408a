"""What marking is called with: the task, what was handed in, where results go; or what is wrong."""

from collections.abc import Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING

from vrts.cli.shared.console import fail

if TYPE_CHECKING:
    from vrts.marking.submission.setting import Place

SUBCOMMANDS = (  # what a first word may be, beside a task
    *("intake", "plan", "run", "merge", "export", "init", "evidence", "reproduce", "diff"),
    *("change", "desk", "session"),
)
NAME_THEM = "name files, a folder or a zip after the task"


def what_to_mark(
    task: str, submissions: tuple[Path, ...], lab: Path | None
) -> "tuple[Place, Path | Sequence[Path]]":
    """Return where the task is, and what is to be marked."""
    from vrts.marking.submission.setting import Place
    from vrts.marking.submission.submissions import of_example
    from vrts.pipeline.files import TASK_FILE, find_example

    folder = find_example(task)
    path = folder / TASK_FILE if folder is not None else Path(task)
    if not path.is_file():
        _no_task(task, folder)
    place = Place(str(path), lab=None if lab is None else str(lab))
    if not submissions:
        own = [] if folder is None else of_example(folder)
        if not own:
            fail("no submissions given", (NAME_THEM,))
        return place, own
    for given in submissions:
        if not given.exists():
            fail(f"there is no `{given}`")
        if not (given.is_file() or given.is_dir()):
            fail(f"`{given}` is neither a file nor a folder")
    alone = len(submissions) == 1 and (
        submissions[0].is_dir() or submissions[0].suffix.lower() == ".zip"
    )
    return place, submissions[0] if alone else submissions


def require_folder(place: Path | None) -> None:
    """Refuse to write results below what is no folder."""
    if place is not None and place.exists() and not place.is_dir():
        fail(f"`{place}` is a file, and results want a folder", ("name another one with `-o`",))


def _no_task(task: str, folder: Path | None) -> None:
    from vrts.pipeline.files import example_names

    if folder is not None:
        fail(f"there is no `task.toml` in `{task}`", ("`vrts new task` writes one",))
    known = example_names()
    ending = [name for name in known if name.partition("-")[2] == task]
    close = ending or get_close_matches(task, known, 1, 0.6)
    word = get_close_matches(task, SUBCOMMANDS, 1, 0.6)
    hints = (f"did you mean the example `{close[0]}`?",) if close else ()
    hints = (f"did you mean `vrts grade {word[0]}`?",) if word else hints
    fail(f"there is no task `{task}`", (*hints, f"examples: {', '.join(known)}"))
