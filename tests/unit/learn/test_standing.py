"""Bare `vrts`: three to five commands that work from where somebody stands."""

import shlex
import shutil
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_commands import vrts_text
from vrts.learn.library import copy_lesson, find_lesson
from vrts.learn.standing import standing

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"


def nothing(folder: Path) -> Path:
    return folder


def lesson(folder: Path) -> Path:
    copy_lesson(find_lesson("2"), folder / "lesson")
    return folder / "lesson"


def begun(folder: Path) -> Path:
    copy_lesson(find_lesson("1"), folder / "01-cans-on-bases")
    return folder


def programs(folder: Path) -> Path:
    shutil.copy(EXAMPLE / "solution.v2", folder / "my own.v2")
    (folder / "odd\x1b[31m.v2").write_text("")
    return folder


def task(folder: Path) -> Path:
    for name in ("task.toml", "solution.v2"):
        shutil.copy(EXAMPLE / name, folder)
    (folder / "submissions").mkdir()
    shutil.copy(EXAMPLE / "submissions" / "hits-base.v2", folder / "submissions")
    (folder / "out").mkdir()
    return folder


def empty_task(folder: Path) -> Path:
    shutil.copy(EXAMPLE / "task.toml", folder)
    return folder


def submissions(folder: Path) -> Path:
    return task(folder) / "submissions"


def scene(folder: Path) -> Path:
    shutil.copytree(ROOT / "scenes" / "cans-on-bases", folder / "cell")
    return folder / "cell"


KINDS = (nothing, lesson, begun, programs, task, empty_task, submissions, scene)
FULL = (lesson, task)  # of which every command is typed in the usual run, too
WAITS = ("view",)  # serves a page until somebody ends it


def typed(folder: Path) -> None:
    shown = vrts_text(cwd=folder).stdout
    rows = [line.split(": ", 1)[1].strip() for line in shown.splitlines()[1:]]
    assert rows == [one.command for one in standing(folder).suggestions]
    for row in rows:
        place, words = folder, shlex.split(row)
        if words[0] == "cd":
            place, words = folder / words[1], words[3:]
        assert words[0] == "vrts"
        if words[1] not in WAITS:
            said = vrts_text(*words[1:], cwd=place)
            assert said.returncode in (0, 1), (row, said.stderr)
            assert "Usage" not in said.stderr


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_three_to_five_commands_are_told(kind: object, tmp_path: Path) -> None:
    folder = next(one for one in KINDS if one is kind)(tmp_path)
    found = standing(folder)
    assert 3 <= len(found.suggestions) <= 5
    assert found.text.isascii()


@pytest.mark.thorough
@pytest.mark.parametrize("kind", FULL, ids=lambda kind: kind.__name__)
def test_each_command_works_as_it_stands(kind: object, tmp_path: Path) -> None:
    typed(next(one for one in KINDS if one is kind)(tmp_path))


@pytest.mark.thorough
@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_each_command_works_wherever_one_stands(kind: object, tmp_path: Path) -> None:
    folder = next(one for one in KINDS if one is kind)(tmp_path)
    typed(folder)
    typed(folder)  # what the first ones wrote is in nobody's way


def test_the_newest_program_comes_first_and_solutions_are_not_pointed_at(tmp_path: Path) -> None:
    folder = lesson(tmp_path)
    assert "solution.v2" not in standing(folder).text
    (folder / "mine.v2").write_text("")
    assert "vrts verify mine.v2" in standing(folder).text


def test_a_folder_that_may_not_be_read_is_like_an_empty_one(tmp_path: Path) -> None:
    assert standing(tmp_path / "gone").suggestions == standing(tmp_path).suggestions
