"""A course with one assignment, its students, and what they hand in."""

import shutil
from contextlib import closing
from pathlib import Path
from typing import Final

from tests.support_live import Json, LiveServer
from vrts.live.lasting.clock import wall
from vrts.live.passwords import hashed
from vrts.live.settings import DATABASE
from vrts.live.store.accounts import add_account
from vrts.live.store.course.people import Person, keep_person
from vrts.live.store.database import opened

EXAMPLE: Final = Path("examples/01-cans-on-bases").resolve()
PASSWORD: Final = "a long password"
STUDENTS: Final = (("Cy Dahl", "cy@example.org", ""), ("Di Ek", "di@example.org", ""))
COURSE: Final = """\
[course]
title = "Robotics"
roster = "roster.csv"
guests = true

[[assignment]]
task = "tasks/cans"
"""
ROSTER: Final = "name,email\nCy Dahl,cy@example.org\nDi Ek,di@example.org\n"


def course_folder(folder: Path, assignment: str = "", task: str = "") -> Path:
    """Write the files of a course; `assignment` and `task` are added to what they say."""
    home = folder / "tasks" / "cans"
    home.mkdir(parents=True)
    for name in ("task.toml", "README.md", "solution.v2"):
        shutil.copy(EXAMPLE / name, home)
    (folder / "roster.csv").write_text(ROSTER)
    with (home / "task.toml").open("a") as file:
        file.write("\n" + task)
    (folder / "course.toml").write_text(COURSE + assignment)
    return folder


def enrol(
    folder: Path,
    students: tuple[tuple[str, str, str], ...] = STUDENTS,
    password: str = "",
) -> list[int]:
    """Give students an account in a server's folder: name, e-mail address, team."""
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    kept = hashed(password) if password else "x"  # to hash one takes long
    accounts: list[int] = []
    with closing(opened(folder / DATABASE)) as connection:
        for name, email, team in students:
            account = add_account(connection, name, wall(), password=kept).id
            keep_person(connection, Person(account, name, email, email, {}, "student", team))
            accounts.append(account)
    return accounts


def log_in(server: LiveServer, name: str) -> str:
    """Return the cookie of a student."""
    answer = server.request("POST", "/login", {"user": name, "password": PASSWORD})
    assert answer.status == 200, answer.body
    return answer.cookie


def work(server: LiveServer, cookie: str) -> Json:
    """Return the one assignment as somebody sees it."""
    answer = server.request("GET", "/course/work/now", cookie=cookie)
    assert answer.status == 200, answer.body
    return answer.json["assignments"][0]


def example(name: str) -> str:
    """Return the text of a program of the example."""
    place = EXAMPLE / "submissions" / f"{name}.v2"
    return (place if place.is_file() else EXAMPLE / f"{name}.v2").read_text()
