"""What a class is like in numbers."""

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from vrts.check.rules.scheme import TOTAL
from vrts.marking.result import Check
from vrts.marking.row import Row

BINS = 10  # tenths of the total: 0 to 1, .., 9 to 10 of 10; full marks count in the last


class Spread(NamedTuple):
    """How final marks are distributed."""

    counts: tuple[int, ...]
    mean: Fraction
    median: Fraction
    total: Fraction = TOTAL  # marks are out of so many points


class Failing(NamedTuple):
    """How a check went in the class."""

    title: str
    hidden: bool  # from students
    asked: int  # rows in which it was asked
    violated: int
    undetermined: int
    not_reached: int
    mean_lost: Fraction  # points, over all rows in which it was asked


def spread(rows: Sequence[Row]) -> Spread | None:
    """Return how the final marks are distributed; None where there are none."""
    marks = sorted(mark for row in rows if (mark := row.exact_final) is not None)
    if not marks:
        return None
    counts = [0] * BINS
    total = max(row.result.exact_total for row in rows)
    for mark in marks:
        counts[min(BINS - 1, int(mark * BINS / total))] += 1
    half = len(marks) // 2
    median = marks[half] if len(marks) % 2 else (marks[half - 1] + marks[half]) / 2
    return Spread(tuple(counts), sum(marks, Fraction(0)) / len(marks), median, total)


def failing(rows: Sequence[Row]) -> tuple[Failing, ...]:
    """Return the checks that were not met everywhere, those that fail most first."""
    asked: dict[str, list[Check]] = {}
    for row in rows:
        for check in row.result.checks:
            if check.kind != "rounding":
                asked.setdefault(check.id, []).append(check)
    every = sum(bool(row.result.checks) for row in rows)  # limits are told of where one is broken
    found = [
        _failing(checks, every if checks[0].kind == "limit" else len(checks))
        for checks in asked.values()
    ]
    missed = [f for f in found if f.violated or f.undetermined or f.not_reached]
    missed.sort(key=lambda f: (-Fraction(f.violated + f.not_reached, f.asked), -f.mean_lost))
    return tuple(missed)


def _failing(checks: Sequence[Check], asked: int) -> Failing:
    answers = [check.answer for check in checks]
    lost = sum((_exact(check.most) - _exact(check.points) for check in checks), Fraction(0))
    return Failing(
        checks[0].title,
        any(check.hidden for check in checks),
        asked,
        answers.count("violated"),
        answers.count("undetermined"),
        answers.count("not reached"),
        lost / asked,
    )


def _exact(points: float) -> Fraction:
    return Fraction(round(points * 1_000_000), 1_000_000)
