"""A course on the live server: a folder with files, and people who have come in."""

import sqlite3
from pathlib import Path
from typing import Final

from tests.support_live import LiveServer
from vrts.live.lasting.clock import wall
from vrts.live.settings import DATABASE
from vrts.live.store.course.letters import new_letter
from vrts.live.store.course.people import people

COURSE: Final = """\
[course]
title = "Robotics"
roster = "roster.csv"
rooms = ["Class", "Lab"]
scenes = ["cans-on-bases"]
guests = {guests}

[[teacher]]
name = "Ada Lind"
email = "ada@example.org"

[[assistant]]
name = "Bo Berg"
email = "bo@example.org"
rooms = ["Lab"]
"""
ROSTER: Final = "name,email\nCy Dahl,cy@example.org\nDi Ek,di@example.org\n"
PASSWORD: Final = "a long password"


def course_folder(folder: Path, *, guests: bool = True, more: str = "") -> Path:
    """Write the files of a course."""
    folder.mkdir(exist_ok=True)
    (folder / "roster.csv").write_text(ROSTER)
    (folder / "course.toml").write_text(COURSE.format(guests=str(guests).lower()) + more)
    return folder


def letter(server: LiveServer, called: str) -> str:
    """Return the token of a new personal link."""
    server.request("GET", "/door")  # is answered when the server has begun
    connection = sqlite3.connect(server.folder / DATABASE, isolation_level=None, timeout=10.0)
    try:
        whose = next(one.account for one in people(connection) if one.called == called)
        return new_letter(connection, whose, wall())
    finally:
        connection.close()


def came_in(server: LiveServer, called: str, password: str = PASSWORD) -> str:
    """Come in by a personal link; return the cookie."""
    code = letter(server, called)
    answer = server.request("POST", "/course/password", {"code": code, "password": password})
    assert answer.status == 200, answer.body
    return answer.cookie
