"""The lessons that come with vrts, and copies of them."""

import os
import secrets
import shutil
from pathlib import Path
from typing import NamedTuple

from vrts.learn.lesson import Lesson
from vrts.learn.lesson_file import load_lesson
from vrts.learn.standing import LESSON_FILE
from vrts.pipeline.files import CannotRead, library_folders


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
    """Copy the files of a lesson to a new place, whole or not at all.

    What somebody has made in its folder stays behind, and what only tests of vrts read.

    Raises:
        CannotRead: Something is there already, or the place is inside the lesson itself.
        OSError: It cannot be written.
    """
    if target.exists() or target.is_symlink():
        hint = f"`cd {target}` and `vrts learn next` go on with it; `-o` names another folder"
        raise CannotRead(f"`{target}` is there already, and nothing is overwritten", (hint,))
    if Path(os.path.realpath(target)).is_relative_to(os.path.realpath(one.folder)):
        hint = "go to another folder first, or name one with `-o`"
        raise CannotRead(f"`{target}` is inside the lesson itself", (hint,))
    target.parent.mkdir(parents=True, exist_ok=True)
    draft = target.with_name(f".{secrets.token_hex(8)}.part")
    try:
        for pattern in (LESSON_FILE, *one.lesson.files):
            for path in sorted(one.folder.glob(pattern)):
                copy = draft / path.relative_to(one.folder)
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(path, copy)  # not its mode: an installed package may be read-only
        draft.rename(target)
    finally:
        shutil.rmtree(draft, ignore_errors=True)
