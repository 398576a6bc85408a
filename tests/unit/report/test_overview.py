"""The page of a class."""

from fractions import Fraction

from tests.support_reports import broken, compiled, contact_loss, grade
from tests.unit.report.test_audience import disputed
from tests.unit.report.test_html import Reader
from vrts.report.overview import overview


def test_every_submission_has_a_row_with_mark_cause_and_link() -> None:
    read = Reader(overview([compiled(grade(contact_loss())), broken()], "Group 3"))
    links = [a["href"] for tag, a in read.elements if tag == "a"]
    assert links == ["submission-07.html", "broken.html"]
    assert "the held can1 hits base1 (−1.5)" in read.text
    assert "Line 3: unexpected THEN" in read.text
    assert "2 submissions · 0 ready for the real robot · mean mark 4.25 · median 4.25" in read.text


def test_losses_are_added_up_by_kind_costliest_first() -> None:
    marked = [compiled(grade(contact_loss(Fraction(n)))) for n in (1, 2)]
    text = Reader(overview([*marked, broken()], "Group 3")).text
    worst = text[text.index("Points lost in all") :]
    assert worst.index("Programs that do not compile or run") < worst.index("Contacts")
    assert "Contacts2−3.0" in worst


def test_marks_are_counted_in_ten_bars() -> None:
    full, low = compiled(grade()), broken()
    read = Reader(overview([full, full, low], "Group 3"))
    label = next(a["aria-label"] for _, a in read.elements if a.get("role") == "img")
    assert label == "Marks: 0 to 1: 1, 9 to 10: 2"


def test_a_class_without_submissions_or_marks_is_a_page_too() -> None:
    assert "0 submissions" in Reader(overview([], "Nobody")).text
    assert "1 submission ·" in Reader(overview([compiled()], "No task")).text


def test_what_is_to_be_reviewed_says_so() -> None:
    reviewed = overview([disputed()], "Group 3")
    assert "gradedreview" in Reader(reviewed).text
    assert "gradedreview" not in Reader(overview([compiled(grade())], "Group 3")).text
