"""The lessons that come with vrts, and copies of them."""

import secrets
import shutil
import stat
from pathlib import Path
from typing import NamedTuple

from vrts.learn.lesson import Lesson
from vrts.learn.lesson_file import load_lesson
from vrts.learn.standing import LESSON_FILE
from vrts.pipeline.files import CannotRead, library_folders

NOT_COPIED = ("expected.json", "__pycache__")  # what tests of vrts read


class Bundled(NamedTuple):
    """A lesson and where it is."""

    lesson: Lesson
    folder: Path


def bundled() -> tuple[Bundled, ...]:
    """Return the lessons that come with vrts, by their numbers."""
    found: dict[str, Path] = {}
    for library in library_folders():
        for file in (library / "examples").glob(f"*/{LESSON_FILE}"):
            found.setdefault(file.parent.name, file.parent)
    lessons = (Bundled(load_lesson(folder), folder) for folder in found.values())
    return tuple(sorted(lessons, key=lambda one: (one.lesson.number, one.folder.name)))


def find_lesson(name: str) -> Bundled:
    """Return a lesson by its number, or by the name of its folder.

    Raises:
        CannotRead: There is no such lesson.
    """
    every = bundled()
    for one in every:
        if name in (str(one.lesson.number), one.folder.name):
            return one
    numbers = ", ".join(str(one.lesson.number) for one in every)
    raise CannotRead(f"there is no lesson `{name}`", (f"lessons: {numbers}; see `vrts learn`",))


def copy_lesson(one: Bundled, target: Path) -> None:
    """Copy the folder of a lesson to a new place, whole or not at all.

    Raises:
        CannotRead: Something is there already.
        OSError: It cannot be written.
    """
    if target.exists() or target.is_symlink():
        hint = f"`cd {target}` and `vrts learn next` go on with it; `-o` names another folder"
        raise CannotRead(f"`{target}` is there already, and nothing is overwritten", (hint,))
    target.parent.mkdir(parents=True, exist_ok=True)
    draft = target.with_name(f".{secrets.token_hex(8)}.part")
    try:
        shutil.copytree(one.folder, draft, ignore=shutil.ignore_patterns(*NOT_COPIED))
        for path in (draft, *draft.rglob("*")):
            path.chmod(path.stat().st_mode | stat.S_IWUSR)  # an installed package may be read-only
        draft.rename(target)
    finally:
        shutil.rmtree(draft, ignore_errors=True)
