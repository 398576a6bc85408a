"""The file of a course: what it tells, and every fault where it stands."""

from pathlib import Path

from vrts.base.source import SourceFile
from vrts.course.course_file import read_course

GOOD = """
[course]
title = "Robotics"
roster = "roster.csv"
rooms = ["Class", "Lab"]

[[teacher]]
name = "Ada Lind"
email = "Ada@example.org"

[[assistant]]
name = "Bo Berg"
email = "bo@example.org"
rooms = ["Lab"]

[[team]]
name = "Red"
members = ["C@example.org", "d@example.org"]

[[assignment]]
task = "tasks/pick"
opens = 2026-10-01T08:00:00+02:00
attempts = 3
"""


def folder_with_task(tmp_path: Path) -> Path:
    (tmp_path / "tasks" / "pick").mkdir(parents=True)
    (tmp_path / "tasks" / "pick" / "task.toml").write_text("")
    return tmp_path


def headlines(text: str, folder: Path) -> list[str]:
    course, found = read_course(SourceFile("course.toml", text), folder)
    assert (course is None) == any(one.is_error for one in found)
    return [one.headline for one in found]


def test_a_course_is_read_whole(tmp_path: Path) -> None:
    course, found = read_course(SourceFile("course.toml", GOOD), folder_with_task(tmp_path))
    assert found == ()
    assert course is not None
    assert (course.title, course.rooms, course.guests) == ("Robotics", ("Class", "Lab"), False)
    assert course.roster == tmp_path / "roster.csv"
    assert [(one.rank, one.email, one.rooms) for one in course.staff] == [
        ("teacher", "ada@example.org", ()),
        ("assistant", "bo@example.org", ("Lab",)),
    ]
    assert course.teams[0].members == ("c@example.org", "d@example.org")
    assert [(one.id, one.attempts) for one in course.assignments] == [("pick", 3)]


def test_every_fault_is_told_at_once(tmp_path: Path) -> None:
    wrong = (
        GOOD.replace('rooms = ["Lab"]', 'rooms = ["Attic"]')
        .replace("Ada@example.org", "nobody")
        .replace('task = "tasks/pick"', 'task = "../pick"')
        .replace("[[team]]", '[[team]]\nname = "Blue"\nmembers = ["d@example.org"]\n\n[[team]]')
    )
    assert headlines(wrong, folder_with_task(tmp_path)) == [
        "`nobody` is no e-mail address",
        "there is no room `Attic`",
        "`d@example.org` is in team `Blue` already",
        "`../pick` lies outside of the course's folder",
    ]


def test_two_assignments_need_two_names(tmp_path: Path) -> None:
    twice = GOOD + '\n[[assignment]]\ntask = "tasks/pick"\n'
    assert headlines(twice, folder_with_task(tmp_path)) == ["there are two assignments `pick`"]


def test_a_task_that_is_not_there_is_told(tmp_path: Path) -> None:
    assert headlines(GOOD, tmp_path) == ["there is no `task.toml` in `tasks/pick`"]
