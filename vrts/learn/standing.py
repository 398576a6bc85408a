"""What works from where somebody stands: three to five commands for a folder, ready to type."""

import os
import shlex
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import NamedTuple

from vrts.check.task.task_places import scene_name
from vrts.pipeline.files import (
    SCENE_FILE,
    STAFF,
    TASK_FILE,
    CannotRead,
    read_toml_source,
    scene_names,
)

LESSON_FILE = "lesson.toml"
SUBMISSIONS = "submissions"
SOLUTION = "solution.v2"
PROGRAM = ".v2"
MOST_LOOKED_AT = 2_000  # files of a folder
SCENE = "cans-on-bases"  # which comes with vrts
LESSONS = (  # the usual names of copies
    *("01-cans-on-bases", "lesson1", "02-dish-on-stand", "03-around-obstacles"),
    *("04-final-project", "05-validation", "07-own-assignment"),
)


class Suggestion(NamedTuple):
    """A command and what it is for."""

    says: str
    command: str


class Standing(NamedTuple):
    """What is in a folder, in a few words, and what works there."""

    where: str
    suggestions: tuple[Suggestion, ...]

    @property
    def text(self) -> str:
        """The lines to print."""
        widest = max(len(one.says) for one in self.suggestions) + 1
        rows = (f"{one.says + ':':{widest}} {one.command}\n" for one in self.suggestions)
        return f"{self.where}. What works here:\n" + "".join(rows)


def standing(folder: Path) -> Standing:
    """Return what works in a folder."""
    programs = _programs(folder)
    if (folder / LESSON_FILE).is_file():
        return Standing("A lesson", tuple(_lesson(folder, programs)))
    if (folder / TASK_FILE).is_file():
        return Standing("A task", tuple(_task(folder, programs)))
    parent = folder.resolve().parent
    if folder.resolve().name == SUBMISSIONS and programs and (parent / TASK_FILE).is_file():
        return Standing("Submissions", tuple(_submissions(folder, programs)))
    if programs:
        return Standing("Programs", tuple(_alone(programs)))
    if (folder / SCENE_FILE).is_file():
        return Standing("A scene", tuple(_scene()))
    return Standing("No program, task or lesson yet", tuple(_nothing(folder)))


def _lesson(folder: Path, programs: list[str]) -> Iterator[Suggestion]:
    own = [name for name in programs if name != SOLUTION]
    yield Suggestion("what to do next", "vrts learn next")
    if own:
        yield Suggestion("check your program", f"vrts verify {own[0]}")
        yield Suggestion("see it move", f"vrts view {own[0]}")
    else:
        yield Suggestion("find places", f"vrts scene show {_scene_of(folder)}")
    yield Suggestion("understand an error", "vrts explain V301")
    yield Suggestion("all lessons", "vrts learn")


def _task(folder: Path, programs: list[str]) -> Iterator[Suggestion]:
    if programs:
        yield Suggestion("mark a program", f"vrts verify {programs[0]}")
        yield Suggestion("see it move", f"vrts view {programs[0]}")
    if _programs(folder / SUBMISSIONS):
        yield Suggestion("mark the class", f"vrts grade . -o {_free(folder, 'out')}")
    if (folder / STAFF / SOLUTION).is_file() or SOLUTION in programs:
        yield Suggestion("check the task", "vrts task check .")
    yield Suggestion("understand an error", "vrts explain V301")
    if not programs:
        yield Suggestion("look words up", "vrts support MOVES")
        yield Suggestion("learn, step by step", "vrts learn")


def _submissions(folder: Path, programs: list[str]) -> Iterator[Suggestion]:
    out = _free(folder.resolve().parent, "out")
    yield Suggestion("mark one", f"vrts verify {programs[0]} --task ..")
    yield Suggestion("why points are lost", f"vrts why {programs[0]} --task ..")
    yield Suggestion("mark the class", f"vrts grade .. -o ../{out}")


def _alone(programs: list[str]) -> Iterator[Suggestion]:
    first = programs[0]
    yield Suggestion("find mistakes", f"vrts compile {first}")
    yield Suggestion("run it", f"vrts run {first}")
    yield Suggestion("check it in a scene", f"vrts verify {first} --scene {SCENE}")
    yield Suggestion("look words up", "vrts support MOVES")
    yield Suggestion("learn, step by step", "vrts learn")


def _scene() -> Iterator[Suggestion]:
    yield Suggestion("see what is where", "vrts scene show .")
    yield Suggestion("find mistakes", "vrts scene check .")
    yield Suggestion("make a task of it", "vrts new task .")


def _nothing(folder: Path) -> Iterator[Suggestion]:
    lessons = (name for name in LESSONS if (folder / name / LESSON_FILE).is_file())
    begun = next(lessons, None)
    if begun is not None:
        yield Suggestion("go on learning", f"cd {begun} && vrts learn next")
    else:
        yield Suggestion("learn, step by step", f"vrts learn 1 -o {_free(folder, 'lesson1')}")
    yield Suggestion("find places", f"vrts scene show {SCENE}")
    yield Suggestion("write a program", f"vrts new program mine.v2 --from {SCENE}")
    yield Suggestion("mark an example", f"vrts grade {LESSONS[0]} -o {_free(folder, 'out')}")
    yield Suggestion("understand an error", "vrts explain V301")


def _scene_of(folder: Path) -> str:
    """Return the scene of a folder's task, if it is one that comes with vrts; else the first."""
    try:
        named, _ = scene_name(read_toml_source(folder / TASK_FILE))
    except CannotRead:
        return SCENE
    return named if named is not None and named in scene_names() else SCENE


def _programs(folder: Path) -> list[str]:
    """Return the programs of a folder as a shell takes them, the newest first.

    A folder that cannot be read has none; names that a terminal cannot show are left out.
    """
    try:
        with os.scandir(folder) as entries:
            files = [
                (-entry.stat().st_mtime_ns, entry.name)
                for entry in islice(entries, MOST_LOOKED_AT)
                if entry.name.lower().endswith(PROGRAM)
                and entry.name.isprintable()
                and entry.is_file()
            ]
    except OSError:
        return []
    return [shlex.quote(f"./{name}" if name.startswith("-") else name) for _, name in sorted(files)]


def _free(folder: Path, name: str) -> str:
    """Return a name that nothing in a folder has."""
    taken = (name, *(f"{name}{number}" for number in range(2, 100)))
    return next((one for one in taken if not (folder / one).exists()), f"{name}-new")
