"""The page of a class: who, what to look at first, and links that lead somewhere."""

import json

import pytest
from msgspec.structs import replace

from tests.places import TESTS
from tests.support_rows import plain_result, plain_row, some_class
from tests.unit.report.page.test_html import Reader
from vrts.marking.overview.page import overview_page
from vrts.marking.result import Kind, Mending, Metrics
from vrts.marking.row import Change, Class, HandedIn, Lateness, Row, Student, row_of

DATA = TESTS / "data" / "hostile_strings.json"
CORPUS: list[str] = json.loads(DATA.read_text(encoding="utf-8"))


def page(*rows: Row, **options: object) -> Reader:
    """Return the page of some rows, read."""
    return Reader(overview_page(Class("vrts.class/1", "Group 3", rows), **options))  # type: ignore[arg-type]


def section(read: Reader, start: str, end: str) -> str:
    """Return what is between two texts."""
    rest = read.text[read.text.index(start) + len(start) :]
    return rest[: rest.index(end)]


def links(read: Reader) -> list[str]:
    """Return the addresses of the page, but for those within it."""
    found = [a["href"] or "" for tag, a in read.elements if tag == "a"]
    return [address for address in found if not address.startswith("#")]


def test_a_row_links_to_both_reports_and_shows_final_and_computed_mark() -> None:
    late = Lateness(3600, "1/2", "1 h late: 0.5 points less")
    change = Change("-1", "done by hand", "jh", "2026-11-21")
    result = replace(plain_result("anna"), mark=8.5)
    row = row_of(result, Student("Anna Ady"), HandedIn(), late, change)
    read = page(row)
    assert "students/anna/report.html" in links(read)
    assert "../students/anna/report.html" in links(read)
    changed = section(read, "Late and changed marks", "All submissions")
    words = "8.5−0.51 h late: 0.5 points less−1.0done by hand (jh, 2026-11-21)7.0"
    assert words in changed
    assert "late changed" in {a.get("data-flags") for tag, a in read.elements if tag == "tr"}


def test_what_has_no_page_has_no_link() -> None:
    missing = plain_row("ben", kind=Kind.MISSING, program=None, mark=None, metrics=Metrics())
    assert links(page(missing)) == []
    assert links(page(plain_row("anna"), pages=False)) == []
    assert links(page(missing, similarity="similarity.html")) == ["similarity.html"]


def test_addresses_are_quoted() -> None:
    assert "students/a%20%23%3Fb%25/report.html" in links(page(plain_row("a #?b%")))


def test_what_is_to_be_reviewed_comes_widest_range_first_and_before_that_what_has_no_mark() -> None:
    doubt = ("to be reviewed: the mark is between 5.0 and 8.5", "to be reviewed: too close")
    rows = [
        plain_row("narrow", mark=8.5, lowest=8.0, review=doubt),
        plain_row("wide", mark=8.5, lowest=5.0, review=doubt),
        plain_row("nothing", mark=None, kind=Kind.RESOURCE, review=("memory was used up",)),
        plain_row("good"),
    ]
    read = page(*rows)
    first = section(read, "Look at these first", "Slowest programs")
    places = [first.index(text) for text in ("nothing", "no mark", "wide", "5.0 to 8.5", "narrow")]
    assert places == sorted(places)
    assert "too close" in first
    assert "memory was used up" in first
    assert "the mark is between" not in first
    assert "good" not in first
    assert "The mark as given is the higher one" in first


def test_of_two_marks_is_spoken_only_where_there_are_two_and_names_have_no_backticks() -> None:
    words = ("`a.v2` cannot be read",)
    for mark in (None, 7.0):
        read = page(plain_row("one", mark=mark, lowest=mark, review=words))
        first = section(read, "Look at these first", "Slowest programs")
        assert "a.v2 cannot be read" in first
        assert "`" not in first
        assert "the higher one" not in first


def test_the_slowest_and_those_that_touch_most_are_listed() -> None:
    rows = [
        plain_row(f"s{k}", metrics=Metrics(duration_s=10.0 + k, contacts=9 - k)) for k in range(10)
    ]
    read = page(*rows)
    slow = section(read, "Slowest programs", "Most contacts")
    assert slow.index("s919.0 s") < slow.index("s818.0 s")
    assert "s111.0 s" not in slow
    contacts = section(read, "Most contacts", "All submissions")
    assert contacts.index("s09") < contacts.index("s18")


@pytest.mark.parametrize("total", [10, 100])
def test_the_bar_of_a_doubtful_mark_lies_within_the_total(total: int) -> None:
    row = plain_row(mark=0.8 * total, lowest=0.6 * total, total=float(total))
    assert 'style="left:60%;width:20%"' in overview_page(Class("vrts.class/1", "Lab", (row,)))


def test_every_status_is_counted_and_can_be_chosen() -> None:
    rows = [plain_row(f"s{k}", kind=kind) for k, kind in enumerate(Kind)]
    read = page(*rows, plain_row("more"))
    buttons = [a["data-kind"] for tag, a in read.elements if tag == "button" and "data-kind" in a]
    assert set(buttons) == {kind.name.lower() for kind in Kind}
    options = [a["value"] for tag, a in read.elements if tag == "option"]
    assert set(options) == {"", *buttons}
    assert "graded (2)" in read.text
    assert "does not compile (1)" in read.text


def test_hidden_checks_say_so() -> None:
    result = plain_result()
    checks = tuple(replace(c, answer="violated") if c.hidden else c for c in result.checks)
    found = section(page(plain_row(checks=checks)), "Checks that fail most", "Slowest")
    assert "gentlehidden100 %1 of 1" in found


def test_a_class_without_rows_is_a_page_too() -> None:
    read = page()
    assert "All submissions" in read.text
    assert "Look at these first" not in read.text


@pytest.mark.parametrize("text", CORPUS)
def test_nothing_foreign_gets_through(text: str) -> None:
    def named(name: str) -> str:
        late = Lateness(1, "1/2", name)
        change = Change("1", name, name, name)
        result = replace(plain_result(), cause=name, lowest=1.0, review=(name,))
        checks = tuple(replace(c, title=name, answer="violated") for c in result.checks)
        student = Student(name, name, name)
        row = row_of(replace(result, checks=checks), student, HandedIn(name), late, change)
        return overview_page(Class("vrts.class/1", name, (row,)), where=name)

    written = named(text)
    read, harmless = Reader(written), Reader(named("harmless"))
    kinds = {(tag, tuple(a)) for tag, a in harmless.elements} | {("code", ()), ("span", ())}
    small = {("small", ())}  # beside a name that is not the id
    assert {(tag, tuple(a)) for tag, a in read.elements} <= kinds | small
    assert all(c.isprintable() or c == "\n" for c in read.text)
    written.encode("utf-8")


def test_the_same_rows_give_the_same_page() -> None:
    assert overview_page(some_class(50)) == overview_page(some_class(50))


def test_those_who_made_the_same_mistake_stand_together() -> None:
    one = Mending("`OPENI` is missing", "one change away: 10 with line 5", (5,), 1, 30)
    other = Mending("`SPEED 3` does not belong here", "look at line 9", (9,), 1, 60)
    rows = [
        plain_row("anna", mark=3.0, mending=other),
        plain_row("ben", mark=2.0, mending=one),
        plain_row("cara", mark=4.0, mending=one),
        plain_row("dora"),
    ]
    read = page(*rows)
    told = section(
        read, "Changes that would earn the full mark, or more points", "Slowest programs"
    )
    assert told.index("OPENI") < told.index("cara") < told.index("ben") < told.index("anna")
    assert "dora" not in told
    assert "Changes that would earn the full mark" not in page(plain_row("anna")).text
