"""What being late costs, to the second and to the tenth of a point."""

from datetime import UTC, datetime, timedelta, timezone
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vrts.check.task.late_rules import LateRules, LateStep
from vrts.marking.lateness import Marks, best, lateness, marks

CET = timezone(timedelta(hours=1))
DUE = datetime(2026, 11, 30, 23, 59, tzinfo=CET)
SECOND, MINUTE, HOUR, DAY = (
    timedelta(seconds=1),
    timedelta(minutes=1),
    timedelta(hours=1),
    timedelta(days=1),
)
BY_DAY = LateRules(DUE, 10 * MINUTE, Fraction(3, 2), most=Fraction(5), closed=DUE + 7 * DAY)
IN_STEPS = LateRules(
    DUE, steps=(LateStep(timedelta(0), Fraction(1)), LateStep(12 * HOUR, Fraction(4)))
)


@pytest.mark.parametrize(
    ("rules", "late_by", "points", "sentence"),
    [
        (BY_DAY, -DAY, 0, ""),
        (BY_DAY, 0 * DAY, 0, ""),
        (BY_DAY, 10 * MINUTE, 0, "10 min late, within the time of grace"),
        (BY_DAY, 10 * MINUTE + SECOND, Fraction(3, 2), "10 min late: 1.5 points less"),
        (BY_DAY, DAY, Fraction(3, 2), "1 day late: 1.5 points less"),
        (BY_DAY, DAY + SECOND, 3, "1 day late: 3 points less"),
        (BY_DAY, 2 * DAY + 3 * HOUR, Fraction(9, 2), "2 days 3 h late: 4.5 points less"),
        (BY_DAY, 7 * DAY, 5, "7 days late: 5 points less"),
        (IN_STEPS, SECOND, 1, "1 s late: 1 point less"),
        (IN_STEPS, 12 * HOUR, 1, "12 h late: 1 point less"),
        (IN_STEPS, 12 * HOUR + MINUTE, 4, "12 h 1 min late: 4 points less"),
    ],
)
def test_what_lateness_costs(
    rules: LateRules, late_by: timedelta, points: Fraction, sentence: str
) -> None:
    found = lateness(rules, DUE + late_by)
    assert (found.points, found.sentence, found.closed) == (points, sentence, False)
    assert found.late_by == max(late_by, timedelta(0))


def test_what_comes_after_closing_gets_0() -> None:
    found = lateness(BY_DAY, DUE + 7 * DAY + SECOND)
    assert found.closed
    assert marks(Fraction(8), found) == Marks(Fraction(8), Fraction(8), Fraction(0))


def test_an_own_deadline_moves_closing_too() -> None:
    found = lateness(BY_DAY, DUE + 8 * DAY, due=DUE + 2 * DAY)
    assert (found.closed, found.late_by) == (False, 6 * DAY)
    assert lateness(BY_DAY, DUE + DAY, due=DUE + 2 * DAY).points == 0


def test_times_are_instants_whatever_their_zone() -> None:
    assert lateness(BY_DAY, DUE.astimezone(UTC) + SECOND).late_by == SECOND


def test_without_rules_nothing_is_deducted() -> None:
    assert lateness(None, DUE + DAY).points == 0
    assert lateness(None, None) == lateness(None, DUE + DAY)


def test_without_a_time_nothing_is_deducted_and_somebody_has_to_look() -> None:
    found = lateness(BY_DAY, None)
    assert (found.late_by, found.points, found.review, found.untimed) == (None, 0, True, True)
    assert found.sentence == "nothing tells when it came, and being late costs points"


def test_a_platform_that_says_what_is_late_says_what_is_not() -> None:
    assert lateness(BY_DAY, None, called_late=False) == lateness(None, None)


def test_what_is_late_at_an_unknown_time_is_to_be_reviewed() -> None:
    found = lateness(BY_DAY, None, called_late=True)
    assert found.review
    assert found.points == 0
    assert found.sentence == "late, says the platform, but not when it came"


@pytest.mark.parametrize(
    ("raw", "points", "deduction", "final"),
    [
        (Fraction(8), Fraction(3, 2), Fraction(3, 2), Fraction(13, 2)),
        (Fraction(1), Fraction(3), Fraction(1), Fraction(0)),
        (Fraction(8), Fraction(1, 20), Fraction(1, 20), Fraction(8)),  # 7.95 rounds half up
        (Fraction(8), Fraction(3, 50), Fraction(3, 50), Fraction(79, 10)),
        (Fraction(0), Fraction(0), Fraction(0), Fraction(0)),
    ],
)
def test_three_columns(
    raw: Fraction, points: Fraction, deduction: Fraction, final: Fraction
) -> None:
    rules = LateRules(DUE, per_day=points)
    assert marks(raw, lateness(rules, DUE + SECOND)) == Marks(raw, deduction, final)


def test_the_best_attempt_is_that_of_the_best_final_mark() -> None:
    early = marks(Fraction(7), lateness(BY_DAY, DUE))
    late = marks(Fraction(9), lateness(BY_DAY, DUE + 2 * DAY))
    assert late.final == 6
    assert best([late, early]) == 1
    assert best([early, early, late]) == 0


@given(
    st.integers(0, 100),
    st.integers(-(10**6), 10**6),
    st.integers(0, 10**6),
    st.sampled_from([BY_DAY, IN_STEPS]),
)
def test_who_comes_later_never_gets_more(
    tenths: int, seconds: int, more: int, rules: LateRules
) -> None:
    raw = Fraction(tenths, 10)
    first = marks(raw, lateness(rules, DUE + seconds * SECOND))
    second = marks(raw, lateness(rules, DUE + (seconds + more) * SECOND))
    assert 0 <= second.final <= first.final <= raw
    assert abs(first.raw - first.deduction - first.final) <= Fraction(1, 20)
