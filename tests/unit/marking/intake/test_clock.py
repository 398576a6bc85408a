"""Clocks that change: in which zone times are read, and what an hour means that comes twice."""

from dataclasses import replace
from datetime import datetime, timedelta, timezone
from fractions import Fraction
from zoneinfo import ZoneInfo

import pytest

from vrts.check.task.late_rules import LateRules
from vrts.marking.intake.clock import ASK_ZONE, settled, zone_of
from vrts.marking.intake.row import Attempt, Intake, Row, Student

SUMMER, WINTER = timezone(timedelta(hours=2)), timezone(timedelta(hours=1))
VIENNA = ZoneInfo("Europe/Vienna")
OPENS = datetime(2026, 10, 25, 0, 30, tzinfo=SUMMER)
CLOSES = datetime(2026, 10, 25, 2, 45, tzinfo=WINTER)
NIGHT = LateRules(CLOSES, closed=CLOSES, opens=OPENS, attempts=2)
DAY = LateRules(datetime(2026, 11, 2, 12, tzinfo=WINTER), per_day=Fraction(1))


def at(*times: str) -> Intake:
    """Return what Ann handed in at some times of that night in Vienna."""
    found = [datetime.fromisoformat(f"2026-10-25T{time}").replace(tzinfo=VIENNA) for time in times]
    attempts = tuple(Attempt(f"{k}.v2", time) for k, time in enumerate(found))
    row = Row("ann", Student("Ann"), attempts[-1].file, "", found[-1], attempts=attempts)
    return Intake("folders", (row,), ())


def test_a_zone_is_taken_from_a_task_only_while_its_clock_does_not_change() -> None:
    assert zone_of(DAY) is WINTER
    assert zone_of(NIGHT) is None
    assert zone_of(None) is None


def test_without_a_zone_it_is_asked_for() -> None:
    (row,) = at("01:00").rows
    unknown = Intake("folders", (replace(row, received=None),), ())
    assert settled(unknown, NIGHT, None).remarks == (ASK_ZONE,)
    assert settled(unknown, NIGHT, VIENNA).remarks == ()
    assert settled(at("01:00"), NIGHT, None).remarks == ()


def test_an_hour_that_comes_twice_is_not_guessed_where_it_decides() -> None:
    found = settled(at("02:50"), NIGHT, VIENNA)  # open still, or closed
    assert found.rows[0].received is None
    assert found.rows[0].attempts == (Attempt("0.v2", None),)
    words = "`ann`: 02:50 on 2026-10-25 came twice, so when this came is not known:"
    both = "2026-10-25T02:50:00+02:00 or 2026-10-25T02:50:00+01:00"
    assert found.remarks == (f"{words} {both}",)


@pytest.mark.parametrize(
    ("time", "zone"), [("02:30", SUMMER), ("01:59", SUMMER), ("03:00", WINTER)]
)
def test_where_both_mean_the_same_the_time_counts(time: str, zone: timezone) -> None:
    found = settled(at(time), NIGHT, VIENNA)
    assert found.remarks == ()
    (row,) = found.rows
    assert row.received is not None
    assert row.received.utcoffset() == zone.utcoffset(None)
    assert settled(at("02:30"), DAY, VIENNA).rows[0].received is not None


def test_the_order_of_attempts_is_not_guessed_where_it_decides() -> None:
    few = settled(at("02:10", "02:30"), NIGHT, VIENNA)
    assert few.remarks == ()  # both count, whichever was the first
    many = settled(at("01:00", "02:10", "02:30"), NIGHT, VIENNA)
    assert len(many.remarks) == 1
    assert [one.received is None for one in many.rows[0].attempts] == [False, True, True]
    assert settled(at("02:10", "02:30"), DAY, VIENNA).rows[0].received is None  # the latest counts
    assert settled(at("02:10", "03:30"), DAY, VIENNA).remarks == ()


def test_a_time_that_never_was_tells_of_a_wrong_zone() -> None:
    (row,) = at("01:00").rows
    never = datetime(2026, 3, 29, 2, 30, tzinfo=VIENNA)
    attempts = (Attempt("0.v2", never),)
    intake = Intake("folders", (replace(row, received=never, attempts=attempts),), ())
    found = settled(intake, DAY, VIENNA)
    assert found.rows[0].received is None
    assert "02:30 on 2026-03-29 never was in that zone" in found.remarks[0]


def test_without_a_task_nothing_is_guessed() -> None:
    assert settled(at("02:30"), None, VIENNA).rows[0].received is None
    assert settled(at("03:30"), None, VIENNA).rows[0].received is not None
