"""The task of a program: beside it, or in a folder above; never one that was handed in with it.

Programs may be anybody's, and so may what stands beside them. A folder of hand-ins is known by its
name: whatever is in it, a task too, was handed in. Two different tasks on the way up are a question
for whoever asks, not a choice of ours. Where everybody may write, as in `/tmp`, in a home, and too
far above, no task is taken, unless the program itself stands there; but one that stands there makes
it a question, too, whether the task below it was handed in.
"""

import os
import stat
from collections.abc import Iterator
from filecmp import cmp
from pathlib import Path
from typing import NamedTuple

from vrts.pipeline.files import STAFF, TASK_FILE, CannotRead

HAND_INS = ("submissions", "hand-ins", "handins")  # names of folders of what was handed in
MOST_LEVELS = 4  # how far above a program its task may be


class _Found(NamedTuple):
    """A task on the way up."""

    task: Path
    may_be_meant: bool  # it is not only there to be asked about


def task_of(program: Path) -> Path | None:
    """Return the file of the task that a program belongs to.

    Raises:
        CannotRead: Different tasks may be meant, or one of them cannot be read.
    """
    try:
        found = list(_tasks(_real(program.parent)))
        meant = [k for k, one in enumerate(found) if one.may_be_meant]
        if not meant:
            return None
        last = meant[-1]
        task = found[last].task
        for nearer in meant[:-1]:
            if not cmp(found[nearer].task, task, shallow=False):
                raise _question(found[nearer].task, task, program)
        if found[last + 1 :]:  # the same text would not do: a task names files beside it
            raise _question(task, found[last + 1].task, program)
        return _shown(task, program)
    except OSError as problem:
        reason = (problem.strerror or "unreadable").lower()
        where = "" if problem.filename is None else f": `{problem.filename}`"
        raise CannotRead(f"cannot tell the task of `{program}`: {reason}{where}") from problem


def is_beside(task: Path, program: Path) -> bool:
    """Return whether a task stands in the folder of a program."""
    return _real(task.parent) == _real(program.parent)


def _question(near: Path, far: Path, program: Path) -> CannotRead:
    return CannotRead(
        f"two tasks may be meant: `{_shown(near, program)}` and `{_shown(far, program)}`",
        ("say which with `--task FILE`: one may have been handed in with the program",),
    )


def _tasks(folder: Path) -> Iterator[_Found]:
    """Yield the tasks from a folder upward that were not handed in, the nearest first."""
    above = [folder, *folder.parents]
    handed_in = [k for k, at in enumerate(above) if at.name.lower() in HAND_INS]
    first = handed_in[-1] + 1 if handed_in else int(folder.name == STAFF)
    home = _real(Path(os.path.expanduser("~")))
    for levels, at in enumerate(above[first:], first):
        ends = at == home != folder
        if os.path.isfile(at / TASK_FILE):
            is_ours = levels <= MOST_LEVELS and not ends and not _for_everybody(at)
            yield _Found(at / TASK_FILE, at == folder or is_ours)
        if ends:
            return


def _for_everybody(folder: Path) -> bool:
    """Return whether everybody may put files there."""
    return os.name != "nt" and bool(folder.stat().st_mode & stat.S_IWOTH)


def _real(folder: Path) -> Path:
    return Path(os.path.realpath(folder))


def _shown(task: Path, program: Path) -> Path:
    """Return a path as whoever named the program would write it."""
    if is_beside(task, program):
        return program.parent / TASK_FILE
    return task if program.is_absolute() else Path(os.path.relpath(task))
