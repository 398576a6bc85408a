"""What students are told: the mark, how it came to be, what cost points; nothing hidden."""

import csv
from html.parser import HTMLParser

import msgspec
import pytest

from tests.support_exports import HOSTILE, SECRET, hostile, result, row, secret
from tests.support_hostile import steering
from vrts.marking.exports.feedback import feedback_html, feedback_text
from vrts.marking.exports.given import Returned
from vrts.marking.exports.marks_table import marks_csv
from vrts.marking.result import Kind
from vrts.marking.row import Change, Class, HandedIn, Lateness, Row


def told(one: Row) -> Returned:
    return Returned(one, one.result)


def test_a_mark_as_computed() -> None:
    assert feedback_text(told(row())).decode() == (
        "Cans on bases\n"
        "Final mark: 8.5 of 10\n"
        "\n"
        "What cost points:\n"
        "   -1.5  line 17, the held `can1` hits `base1`\n"
        "         Hint: look\n"
    )


def test_lateness_and_changes_by_hand_stand_beside_the_computed_mark() -> None:
    late, change = Lateness(3600, "1", "1 h late: 1 point less"), Change("1/2", "seen", "r", "d")
    text = feedback_text(told(row(late=late, change=change))).decode()
    assert (
        "Final mark: 8.0 of 10\n"
        "\n"
        "How the mark came to be:\n"
        "    8.5  computed\n"
        "   -1.0  lateness: 1 h late: 1 point less\n"
        "   +0.5  change by hand: seen\n"
    ) in text


@pytest.mark.parametrize(
    ("why", "told_of"),
    [
        ("the best of 3 attempts, number 1; 3 of 4 hand-ins count: 1 came after the first 3", True),
        ("1 of 2 hand-ins counts: 1 came after it closed", True),
        ("the only file", False),
        ("the latest of 2 attempts; the only file", False),
    ],
)
def test_which_of_several_hand_ins_counts_is_told(why: str, told_of: bool) -> None:
    one = msgspec.structs.replace(row(), handed_in=HandedIn("a.v2", why))
    line = f"What counts: {why}."
    assert (line in feedback_text(told(one)).decode()) == told_of
    assert (line in feedback_html(told(one))) == told_of
    (found,) = csv.DictReader(marks_csv(Class("vrts.class/1", "L", (one,))).decode().splitlines())
    assert found["why"] == why


def test_no_mark_says_why() -> None:
    text = feedback_text(told(row(mark=None, kind=Kind.MISSING))).decode()
    assert text.startswith("Cans on bases\nNo mark yet\n")
    assert "hits" in text


def test_a_mark_that_does_not_count_says_so() -> None:
    stamped = msgspec.structs.replace(result(), stamps=("another scene",))
    one = msgspec.structs.replace(row(), result=stamped)
    assert b"This mark does not count: another scene." in feedback_text(told(one))


def test_hidden_checks_change_the_mark_and_are_not_named() -> None:
    public = result()
    one = msgspec.structs.replace(row(mark=7.0), result=secret(public, 7.0))
    text = feedback_text(Returned(one, public)).decode()
    assert "Final mark: 7.0 of 10" in text
    assert "    8.5  computed from what you can see\n" in text
    assert "   -1.5  checks that are not shown here\n" in text
    assert SECRET not in text + feedback_html(Returned(one, public))


class Tags(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.tags: set[str] = set()
        self.attributes = 0

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        self.attributes += len(attrs)


@pytest.mark.parametrize("words", HOSTILE)
def test_foreign_words_steer_nothing(words: str) -> None:
    html = feedback_html(told(hostile(words)))
    parser = Tags()
    parser.feed(html)
    parser.close()
    assert parser.tags <= {"p", "ul", "li", "code"}
    assert parser.attributes == 0
    assert html.startswith("<p>Final mark: ")
    assert not {"\n", "\r"} & set(html)
    assert not steering(feedback_text(told(hostile(words))).decode())
