"""From hand-ins to what students read: marked with the list of the class, commented, published."""

from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest

from tests.support_commands import vrts_text
from tests.support_handing import course_folder, example
from vrts.course.course_file import open_course
from vrts.course.facts import facts_of
from vrts.course.handing import deposit
from vrts.course.handing.deposit import HandIn
from vrts.course.handing.granted import Grant, Granted
from vrts.course.handing.published import final_of, report_of
from vrts.course.handing.standing import standing
from vrts.marking.by_hand.decisions.files import add_decisions
from vrts.marking.by_hand.decisions.records import ChangeMark, Comment, Excuse, Extend
from vrts.marking.layout import Layout
from vrts.marking.row import class_from_bytes

CY, DI = "cy@example.org", "di@example.org"
LATE = "[late]\ndue = 2026-11-27T13:00:00+01:00\nper_day = 1\n[submissions]\nkeep = 'best'\n"


def hand_in(home: Path, folder: str, stamp: str, text: str) -> None:
    deposit.place(home, HandIn("cans", 0, stamp, 1, ((1, folder),), "", text.encode()))


@pytest.fixture(scope="module")
def marked(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Mark a course; return its folder and what was written."""
    home = tmp_path_factory.mktemp("published")
    course = open_course(course_folder(home / "course", task=LATE))
    (course.handed_in / deposit.PENDING).mkdir(parents=True)
    hand_in(course.handed_in, CY, "2026-11-27-12-00-00", example("hits-base"))
    hand_in(course.handed_in, CY, "2026-11-28-12-30-00", "no program")
    done = vrts_text("course", "mark", str(course.folder), "cans", "-o", str(home / "out"))
    assert done.returncode == 0, done.stderr
    assert f"vrts grade desk {home / 'out'}" in done.stdout + done.stderr
    return course.folder, home / "out"


@pytest.mark.thorough
def test_hand_ins_are_marked_under_the_right_names(marked: tuple[Path, Path]) -> None:
    _, out = marked
    rows = class_from_bytes(Layout(out).results.read_bytes()).rows
    named = {one.student.email: (one.student.name, one.final) for one in rows}
    assert named == {CY: ("Cy Dahl", 7.0), DI: ("Di Ek", None)}  # who handed in nothing too


def test_students_read_what_is_published_and_only_their_own(marked: tuple[Path, Path]) -> None:
    folder, out = marked
    course = open_course(folder)
    assert final_of(course, "cans", CY) is None
    rows = class_from_bytes(Layout(out).results.read_bytes()).rows
    cy = next(one.id for one in rows if one.student.email == CY)
    now = datetime(2026, 12, 1, 12, tzinfo=UTC)
    words = Comment(0, "", cy, "look at the height", 11, 4.9)
    kept = Comment(0, "", cy, "for us alone", private=True)
    add_decisions(Layout(out).decisions, "R. Huber", (words, kept), now)
    done = vrts_text("course", "publish", str(folder), "cans", str(out))
    assert done.returncode == 0, done.stderr
    found = final_of(course, "cans", CY)
    assert found is not None
    assert found.mark == "Final mark: 7.0 of 10"
    assert [(one.text, one.line, one.time_s) for one in found.comments] == [
        ("look at the height", 11, 4.9)
    ]
    report = report_of(course, "cans", CY)
    assert report is not None
    assert "look at the height" in report.read_text()
    other = final_of(course, "cans", DI)
    assert other is not None
    assert other.comments == ()
    assert final_of(course, "cans", "../cans") is None
    assert vrts_text("course", "publish", str(folder), "cans", "--withdraw").returncode == 0
    assert final_of(course, "cans", CY) is None
    assert report_of(course, "cans", CY) is None


def test_unsafe_marks_are_not_published_unless_somebody_says_so(
    marked: tuple[Path, Path],
) -> None:
    folder, out = marked
    rows = class_from_bytes(Layout(out).results.read_bytes()).rows
    cy = next(one.id for one in rows if one.student.email == CY)
    now = datetime(2026, 12, 1, 12, tzinfo=UTC)
    for who, mark in (("A. Berg", "4"), ("B. Dahl", "9")):
        other = ChangeMark(0, "", (cy,), "seen in the lab", mark=mark)
        add_decisions(Layout(out).decisions, who, (other,), now)
    refused = vrts_text("course", "publish", str(folder), "cans", str(out))
    assert "1 of 2 marks is unsafe" in refused.stderr
    assert final_of(open_course(folder), "cans", CY) is None
    despite = vrts_text("course", "publish", str(folder), "cans", str(out), "--despite", "all")
    assert despite.returncode == 0, despite.stderr
    found = final_of(open_course(folder), "cans", CY)
    assert found is not None
    assert any("may still change" in one for one in found.remarks)


def test_the_page_knows_later_deadlines_and_excuses_of_the_desk(
    marked: tuple[Path, Path],
) -> None:
    folder, out = marked
    (assignment,) = open_course(folder).assignments
    assignment, granted = replace(assignment, marked=out), Granted()
    assert granted.to(assignment, CY) == granted.to(assignment, DI) == Grant()
    ids = {
        one.student.email: one.id for one in class_from_bytes(Layout(out).results.read_bytes()).rows
    }
    later = Extend(0, "", (ids[CY],), "2026-11-30T13:00:00+01:00", "ill")
    excuse = Excuse(0, "", (ids[DI],), "ill, with a certificate")
    decided = datetime(2026, 12, 2, tzinfo=UTC)
    add_decisions(Layout(out).decisions, "L. Ek", (later,), decided)
    assert granted.to(assignment, CY) != Grant()
    assert granted.to(assignment, DI) == Grant(), "nobody has what was given to another"
    add_decisions(Layout(out).decisions, "L. Ek", (excuse,), decided)
    cy, di = granted.to(assignment, CY), granted.to(assignment, DI)
    assert (cy.due, cy.excused) == (datetime(2026, 11, 30, 12, tzinfo=UTC), False)
    assert (di.due, di.excused) == (None, True)
    facts = facts_of(assignment)
    at = datetime(2026, 11, 30, 11, tzinfo=UTC).timestamp()
    assert standing(facts, 0, at, due=cy.due).late == ""
    assert standing(facts, 0, at, due=di.due).late != ""
    earlier = datetime(2026, 11, 1, tzinfo=UTC)
    on_time = datetime(2026, 11, 20, tzinfo=UTC).timestamp()
    assert standing(facts, 0, on_time, due=earlier).late == "", "an earlier one costs nothing"
