"""Statistics by two routes, and where there are none."""

from random import Random
from statistics import correlation

from msgspec.structs import replace

from tests.places import ROOT
from tests.support_desk import HITS, about_of
from tests.support_rows import failed, plain_result, plain_row
from vrts.desk.book.book import Book
from vrts.desk.book.decided import Decided, Mine
from vrts.desk.book.opened import Opened
from vrts.desk.figures.bars import bars
from vrts.desk.figures.discrimination import discrimination
from vrts.desk.figures.statistics import statistics
from vrts.desk.rows.causes import causes_of
from vrts.desk.told import Attempt, Looked
from vrts.marking.layout import Layout
from vrts.marking.row import Class, MarkedAttempt, Row

NO_DECISIONS = Decided()


def book_of(rows: list[Row], decided: Decided = NO_DECISIONS, **attempts: int) -> Book:
    whole = Class("vrts.class/1", "A class", tuple(rows))
    opened = Opened(Layout(ROOT / "nowhere"), whole, about_of(ROOT / "nowhere"))
    several = {
        name: tuple(Attempt(None, None, f"{k}.v2") for k in range(count))
        for name, count in attempts.items()
    }
    return Book(opened, whole, decided, {}, several)


def test_tenths_fall_into_their_own_bar_and_the_end_into_the_last() -> None:
    found = bars([0.0, 0.3, 0.6, 0.7, 1.0, 1.0], 0.0, 1.0, 10)
    assert [bar.count for bar in found] == [1, 0, 0, 1, 0, 0, 1, 1, 0, 2]
    assert (found[3].from_, found[3].to) == (0.3, 0.4)
    assert [bar.count for bar in bars([2.0, 2.0], 2.0, 2.0, 5)] == [2]
    assert bars([], 2.0, 2.0, 5) == ()


def test_discrimination_is_the_correlation_with_all_other_checks() -> None:
    draw = Random(3)
    points = [draw.choice((0.0, 1.5, 3.0)) for _ in range(40)]
    others = [p + draw.gauss(0, 2) for p in points]
    found = discrimination(points, others)
    assert found is not None
    assert abs(found - correlation(points, others)) < 1e-4
    assert found > 0.3
    assert discrimination([1.0] * 40, others) is None, "everybody got the same"
    assert discrimination(points[:4], others[:4]) is None, "too few"


def test_a_check_is_not_in_the_sum_it_is_compared_with() -> None:
    """Else a check that has nothing to do with the others would seem to tell programs apart."""
    rows: list[Row] = []
    for k, wrong in enumerate(
        [("target can1",), ("target can2",), ("target can1", "target can2"), ()] * 3
    ):
        checks = failed(plain_result(), *wrong)
        rows.append(plain_row(f"s{k}", checks=checks, mark=10.0 - 3.0 * len(wrong)))
    book = book_of(rows)
    by_id = {one.id: one for one in statistics(book, causes_of(rows)).checks}
    first = by_id["target can1"]
    assert (first.discrimination, first.count, first.full, first.none) == (0.0, 12, 6, 6)
    assert by_id["demand gentle"].discrimination is None


def test_graders_attempts_and_double_marking() -> None:
    rows = [plain_row("a", mark=4.0), plain_row("b", mark=8.0), plain_row("c", mark=9.0)]
    both = (Looked("huber", 8.0, stale=False), Looked("mayr", 6.5, stale=False))
    stale = (Looked("huber", 3.0, stale=False), Looked("mayr", 9.0, stale=True))
    decided = Decided(
        {
            "a": Mine(assigned=("huber", "mayr"), finished=stale),
            "b": Mine(assigned=("huber",), finished=both),
            "c": Mine(excused=True),
        }
    )
    found = statistics(book_of(rows, decided, a=3), ())
    assert (found.mean, found.median) == (6.0, 6.0), "who is excused does not count"
    assert [(one.number, one.count, one.mean) for one in found.attempts] == [
        (1, 1, 8.0),
        (3, 1, 4.0),
    ]
    assert [(one.who, one.rows, one.finished, one.mean) for one in found.graders] == [
        ("huber", 2, 2, 5.5),
        ("mayr", 1, 2, 7.75),
    ]
    assert [(one.student, one.difference) for one in found.double] == [("b", 1.5)]


def test_progress_is_by_number_of_the_attempt_where_all_were_marked() -> None:
    def tried(name: str, *marks: float | None) -> Row:
        row = plain_row(name, mark=marks[-1] or 0.0)
        told = tuple(MarkedAttempt(f"{name}{k}.v2", None, mark) for k, mark in enumerate(marks))
        return replace(row, handed_in=replace(row.handed_in, attempts=told))

    rows = [tried("a", 2.0, 5.0, 9.0), tried("b", 4.0, None, 7.0), plain_row("c", mark=9.0)]
    book = book_of([*rows, tried("d", 0.0, 0.0)], Decided({"d": Mine(excused=True)}))
    found = statistics(book, ()).progress
    assert [(one.number, one.count, one.mean, one.median) for one in found] == [
        (1, 3, 5.0, 4.0),
        (2, 1, 5.0, 5.0),
        (3, 2, 8.0, 8.0),
    ]
    told = [(one.file, one.mark) for one in book.attempts_of(rows[0])]
    assert told == [("a0.v2", 2.0), ("a1.v2", 5.0), ("a2.v2", 9.0)]
    assert statistics(book_of([plain_row("a", mark=4.0)], a=3), ()).progress == ()


def test_who_is_excused_is_in_no_cause_either() -> None:
    losses = (HITS,)
    rows = [plain_row(name, mark=8.5, losses=losses) for name in "ab"]
    causes = causes_of(rows)
    for excused, counts in (("a", [1]), ("", [2])):
        decided = Decided({excused: Mine(excused=True)})
        found = statistics(book_of(rows, decided), causes).causes
        assert [one.count for one in found] == counts
    nobody = Decided({name: Mine(excused=True) for name in "ab"})
    assert statistics(book_of(rows, nobody), causes).causes == ()


def test_nobody_has_statistics_of_nobody() -> None:
    found = statistics(book_of([replace(plain_row("a"), final=None)]), ())
    assert (found.mean, found.median, found.attempts) == (None, None, ())
    assert sum(bar.count for bar in found.marks) == 0
