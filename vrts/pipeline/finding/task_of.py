"""The task of a program: beside it, or in a folder above; never one that was handed in with it.

Programs may be anybody's, and so may what stands beside them. A folder of hand-ins is known by its
name: whatever is in it, a task too, was handed in. Two different tasks on the way up are a question
for whoever asks, not a choice of ours. Where everybody may write, as in `/tmp`, no task is looked
for, unless the program itself stands there.
"""

import os
import stat
from collections.abc import Iterator
from filecmp import cmp
from pathlib import Path

from vrts.pipeline.files import STAFF, TASK_FILE, CannotRead

HAND_INS = ("submissions", "hand-ins", "handins")  # names of folders of what was handed in
MOST_LEVELS = 4  # how far above a program its task may be


def task_of(program: Path) -> Path | None:
    """Return the file of the task that a program belongs to.

    Raises:
        CannotRead: Different tasks may be meant.
    """
    folder = program.parent.resolve()
    found = list(_tasks(folder))
    if not found or len(folder.parts) - len(found[0].parent.parts) > MOST_LEVELS:
        return None
    task = found[-1]
    for other in found[:-1]:
        if not cmp(other, task, shallow=False):
            raise CannotRead(
                f"two tasks may be meant: `{_shown(other, program)}` and `{_shown(task, program)}`",
                ("say which with `--task FILE`: one may have been handed in with the program",),
            )
    return _shown(task, program)


def is_beside(task: Path, program: Path) -> bool:
    """Return whether a task stands in the folder of a program."""
    return task.parent.resolve() == program.parent.resolve()


def _tasks(folder: Path) -> Iterator[Path]:
    """Yield the tasks from a folder upward that were not handed in, the nearest first."""
    above = [folder, *folder.parents]
    handed_in = [k for k, at in enumerate(above) if at.name.lower() in HAND_INS]
    first = handed_in[-1] + 1 if handed_in else int(folder.name == STAFF)
    home = Path(os.path.expanduser("~")).resolve()
    for at in above[first:]:
        if at != folder and at == home:
            return
        if _is_file(at / TASK_FILE) and (at == folder or not _for_everybody(at)):
            yield at / TASK_FILE


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except PermissionError:  # a folder above that we may not look into
        return False


def _for_everybody(folder: Path) -> bool:
    """Return whether everybody may put files there."""
    return os.name != "nt" and bool(folder.stat().st_mode & stat.S_IWOTH)


def _shown(task: Path, program: Path) -> Path:
    """Return a path as whoever named the program would write it."""
    if is_beside(task, program):
        return program.parent / TASK_FILE
    return task if program.is_absolute() else Path(os.path.relpath(task))
