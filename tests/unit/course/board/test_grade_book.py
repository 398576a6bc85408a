"""The grade book of the board is what `vrts grade export` writes, and is refused as there."""

import base64
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from tests.support_commands import vrts_text
from tests.support_handing import course_folder, example
from tests.support_live import Answer, LiveServer
from vrts.course.course_file import open_course
from vrts.course.handing import deposit
from vrts.course.handing.deposit import HandIn
from vrts.marking.by_hand.decisions.files import add_decisions
from vrts.marking.by_hand.decisions.records import ChangeMark
from vrts.marking.layout import Layout
from vrts.marking.row import class_from_bytes

pytestmark = pytest.mark.thorough
CY = "cy@example.org"
WORKSHEET = (
    '"Identifier";"Full name";"Email address";"Grade";"Maximum Grade";"Feedback comments"\n'
    '"Participant 1";"Cy Dahl";"cy@example.org";"";"10,00";""\n'
    '"Participant 2";"Di Ek";"di@example.org";"";"10,00";""\n'
)


class Taught(NamedTuple):
    """A course that is served and marked."""

    server: LiveServer
    teacher: str
    out: Path

    def ask(self, cookie: str | None = None, **asked: Any) -> Answer:
        """Ask for a grade book."""
        body = {"assignment": "cans", "to": "csv"} | asked
        who = self.teacher if cookie is None else cookie
        return self.server.request("POST", "/course/board/grades", body, cookie=who)


@pytest.fixture(scope="module")
def taught(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Taught]:
    home = tmp_path_factory.mktemp("graded")
    course = open_course(course_folder(home / "course", assignment='marked = "marked/cans"\n'))
    (course.handed_in / deposit.PENDING).mkdir(parents=True)
    words = example("hits-base").encode()
    hand_in = HandIn("cans", 0, "2026-11-27-12-00-00", 1, ((1, CY),), "", words)
    deposit.place(course.handed_in, hand_in)
    out = course.folder / "marked" / "cans"
    done = vrts_text("course", "mark", str(course.folder), "cans", "-o", str(out))
    assert done.returncode == 0, done.stderr
    with LiveServer(home / "kept", scenes=(str(course.folder),)) as server:
        yield Taught(server, server.supervisor(), out)


def test_it_is_what_the_command_writes(taught: Taught) -> None:
    answer = taught.ask()
    assert answer.status == 200, answer.body
    path = taught.out.parent / "export.csv"
    done = vrts_text("grade", "export", str(taught.out), "--to", "csv", "-o", str(path))
    assert done.returncode == 0, done.stderr
    assert answer.body == path.read_bytes()
    assert b"Cy Dahl" in answer.body


def test_a_worksheet_is_filled_in(taught: Taught) -> None:
    answer = taught.ask(to="moodle", fill=base64.b64encode(WORKSHEET.encode()).decode())
    assert answer.status == 200, answer.body
    (row,) = [line for line in answer.body.decode().splitlines() if "cy@" in line]
    assert row.startswith('"Participant 1";"Cy Dahl";"cy@example.org";"7,00"')
    wrong = taught.ask(to="canvas", fill=base64.b64encode(b"nothing").decode())
    assert (wrong.status, wrong.json["code"]) == (409, "export")
    assert wrong.json["text"]
    assert str(taught.out.parents[3]) not in wrong.json["text"]


def test_nobody_else_gets_it_and_only_of_what_was_marked(taught: Taught) -> None:
    for cookie in ("", taught.server.enter("Guest")):
        refused = taught.ask(cookie)
        assert (refused.status, refused.json["code"]) == (403, "role")
    assert taught.ask(assignment="nosuch").status == 404
    for key, value in (("to", "../x"), ("more", "1"), ("fill", "?"), ("column", "x" * 300)):
        assert taught.ask(None, **{key: value}).status == 400, key


def test_unsafe_marks_are_kept_back_until_somebody_takes_them(taught: Taught) -> None:
    rows = class_from_bytes(Layout(taught.out).results.read_bytes()).rows
    cy = next(one.id for one in rows if one.student.email == CY)
    now = datetime(2026, 12, 1, 12, tzinfo=UTC)
    for who, mark in (("A. Berg", "4"), ("B. Dahl", "9")):
        other = ChangeMark(0, "", (cy,), "seen in the lab", mark=mark)
        add_decisions(Layout(taught.out).decisions, who, (other,), now)
    kept = taught.ask()
    assert (kept.status, kept.json["code"]) == (409, "unsafe")
    assert "unsafe" in kept.json["text"]
    assert taught.ask(despite=True).status == 200
    left = [path.name for path in (taught.server.folder).glob("grades-*")]
    assert left == []
