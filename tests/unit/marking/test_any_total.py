"""Marks are out of whatever the task says, in every list, export and page."""

import json
import re
from datetime import UTC, datetime, timedelta
from fractions import Fraction
from pathlib import Path

import msgspec
import pytest

from tests.places import ROOT
from tests.support_commands import vrts_text
from tests.support_exports import given, result, row
from vrts.base.source import SourceFile
from vrts.check.task.late_rules import LateRules
from vrts.marking.appeals.evidence import Contents
from vrts.marking.appeals.evidence_readme import readme
from vrts.marking.by_hand.by_hand import ByHand, rows_by_hand
from vrts.marking.by_hand.overrides import read_overrides
from vrts.marking.exports.autograders.classroom50 import scores
from vrts.marking.exports.autograders.gradescope import results as gradescope
from vrts.marking.exports.autograders.prairielearn import results as prairielearn
from vrts.marking.exports.feedback import feedback_text
from vrts.marking.exports.given import Options, Page, Returned
from vrts.marking.exports.grade_books.canvas import canvas
from vrts.marking.exports.steps import steps
from vrts.marking.lateness import lateness, marks
from vrts.marking.overview.figures import spread
from vrts.marking.overview.page import overview_page
from vrts.marking.result import Damaged, Result, from_bytes, to_bytes
from vrts.marking.row import Class, Row, Student, class_from_bytes, class_to_bytes, counted, row_of
from vrts.marking.row_words import row_words
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SHOWN = (".csv", ".json", ".txt", ".xml", ".html")
OF_20 = msgspec.structs.replace(result(mark=8.5), mark=17.0, total=20.0)


def of(found: Result, **more: object) -> Row:
    plain = row()
    return row_of(found, plain.student, plain.handed_in, **more)  # type: ignore[arg-type]


def test_a_result_says_so_only_where_it_is_not_10() -> None:
    assert "total" not in json.loads(to_bytes(result()))
    assert json.loads(to_bytes(OF_20))["total"] == 20
    assert from_bytes(to_bytes(OF_20)) == OF_20
    with pytest.raises(Damaged, match="a mark of 17 of 10"):
        from_bytes(to_bytes(msgspec.structs.replace(OF_20, total=10.0)))
    whole = Class("vrts.class/1", "Lab", (of(OF_20),))
    assert class_from_bytes(class_to_bytes(whole)) == counted(whole)
    assert whole.total == 20
    broken = msgspec.structs.replace(of(OF_20), final=20.1)
    with pytest.raises(Damaged):
        class_from_bytes(class_to_bytes(Class("vrts.class/1", "Lab", (broken,))))


def test_lateness_and_changes_by_hand_end_at_the_total() -> None:
    due = datetime(2030, 1, 1, tzinfo=UTC)
    late = lateness(LateRules(due, per_day=Fraction(2)), due + timedelta(hours=30))
    assert marks(Fraction(17), late, Fraction(20)).final == 13
    change = '[[change]]\nstudent = "anna"\n{}\nreason = "seen"\nwho = "r"\ndate = "2030-01-01"\n'
    more = SourceFile("overrides.toml", change.format("delta = 12"))
    assert read_overrides(more, ["anna"]).wrong
    found = read_overrides(more, ["anna"], Fraction(20))
    assert not found.wrong
    (changed,) = rows_by_hand(Class("vrts.class/1", "Lab", (of(OF_20),)), ByHand(found)).rows
    assert changed.final == 20
    (step,) = steps(changed)
    assert (step.points, step.sentence) == (3, "seen (+12, in tenths from 0 to 20)")
    too_much = SourceFile("overrides.toml", change.format("mark = 20.5"))
    assert read_overrides(too_much, ["anna"], Fraction(20)).wrong


def test_grade_books_and_autograders_are_filled_in_proportion() -> None:
    told = Returned(of(OF_20), OF_20)
    assert prairielearn(told)["score"] == 0.85
    assert (scores(told)["score"], scores(told)["max-score"]) == (170, 200)
    assert gradescope(told)["score"] == 17
    assert "Final mark: 17.0 of 20" in feedback_text(told).decode()
    head = "Student,ID,SIS User ID,SIS Login ID,Section,Lab 1 (1)\n"
    book = f'{head}    Points Possible,,,,,50\n"Ady, Anna",501,,anna,A,\n'.encode()
    plain = row()
    known = row_of(OF_20, Student("", ids={"canvas": "501"}), plain.handed_in)
    product = canvas(given([known]), Options(fill=Page("book.csv", book)))
    ((_, filled),) = product.files
    assert b",A,42.5\n" in filled.replace(b"\r\n", b"\n")  # 17 of 20 is 42.5 of 50


def test_the_histogram_has_tenths_of_the_total() -> None:
    rows = tuple(
        of(msgspec.structs.replace(OF_20, id=f"s{n}", mark=mark))
        for n, mark in enumerate((0.0, 1.9, 2.0, 19.9, 20.0))
    )
    found = spread(rows)
    assert found is not None
    assert found.counts == (2, 1, 0, 0, 0, 0, 0, 0, 0, 2)
    page = overview_page(Class("vrts.class/1", "Lab", rows))
    assert "with a mark from 18 to 20" in page
    assert re.search(r"full marks</dt><dd>20</dd>", page)


@pytest.mark.parametrize(("mark", "total"), [(4.2, 5.0), (7.5, 7.5), (100.0, 100.0), (83.1, 100.0)])
def test_an_appeal_and_a_line_of_a_class_have_the_total(mark: float, total: float) -> None:
    one = of(msgspec.structs.replace(result(mark=mark), total=total))
    place = Place("")
    told = readme(one, Contents("vrts.evidence/1", "", "", "", place, Wanted(), "", (), {}, {}))
    assert told.count(f"{mark} of {total:g}") == 2, told
    assert "of 10\n" not in told
    line = row_words(one, "anna.v2")
    assert line.startswith(f"{mark:{max(4, len(str(total)))}.1f}  anna")


@pytest.mark.thorough
@pytest.mark.parametrize("total", [5, 7.5, 100])
def test_from_the_task_to_every_export(total: float, tmp_path: Path) -> None:
    task = (EXAMPLE / "task.toml").read_text().partition("[mark]")[0]
    (tmp_path / "task.toml").write_text(f"{task}[mark]\ntotal = {total}\n")
    (tmp_path / "hand").mkdir()
    (tmp_path / "hand" / "anna.v2").write_bytes((EXAMPLE / "solution.v2").read_bytes())
    row_of_anna = "Participant 11,Anna,anna@a.b,Submitted,,50.00,Yes,-,"
    head = "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,"
    sheet = f"{head}Last modified (grade),Feedback comments\n{row_of_anna}\n"
    (tmp_path / "sheet.csv").write_text(sheet)
    made = vrts_text("grade", "task.toml", "hand", "-o", "out", "--no-pages", cwd=tmp_path)
    assert made.returncode == 0, made.stderr
    assert made.stdout.strip().startswith(f"{total:.1f}  anna")
    formats = ("csv", "json", "moodle", "gradescope", "prairielearn", "junit")
    words = [word for name in formats for word in ("--to", name)]
    told = vrts_text("grade", "export", "out", *words, "--fill", "sheet.csv", cwd=tmp_path)
    assert told.returncode == 0, told.stderr
    found = {p.name: p.read_text() for p in (tmp_path / "out").rglob("*") if p.suffix in SHOWN}
    assert f",{total:.1f},,,{total:.1f}," in found["marks.csv"]
    assert ",50.00,50.00,Yes" in found["moodle-worksheet.csv"]
    assert f"Final mark: {total:.1f} of {total:g}" in found["moodle-worksheet.csv"]
    assert f"Final mark: {total:.1f} of {total:g}" in found["feedback.txt"]
    assert json.loads(found["class.json"])["rows"][0]["final"] == total
    assert [name for name, text in found.items() if re.search(r"of 10\b", text)] == []
