"""Points in decimals: exact, half up, nothing of floating point."""

from fractions import Fraction

import pytest

from tests.support_exports import row
from vrts.base.written_numbers import parsed
from vrts.marking.exports.numbers import decimal, number, points
from vrts.marking.exports.steps import steps
from vrts.marking.row import Change, Lateness


@pytest.mark.parametrize(
    ("value", "least", "most", "text"),
    [
        ("17/2", 0, 6, "8.5"),
        ("17/2", 2, 6, "8.50"),
        ("8", 0, 6, "8"),
        ("8", 1, 6, "8.0"),
        ("1/3", 0, 6, "0.333333"),
        ("2/3", 0, 2, "0.67"),
        ("1/8", 0, 2, "0.13"),
        ("-1/8", 0, 2, "-0.13"),
        ("-1/1000", 0, 2, "0"),
        ("7/2", 0, 0, "4"),
    ],
)
def test_decimals(value: str, least: int, most: int, text: str) -> None:
    assert decimal(Fraction(value), least=least, most=most) == text


def test_numbers_of_json_are_as_they_read() -> None:
    assert repr(number(Fraction("0.1") + Fraction("0.2"))) == "0.3"
    assert repr(number(Fraction(8))) == "8"
    assert points(4.35) == Fraction("4.35")


@pytest.mark.parametrize(
    ("text", "value"),
    [("8.5", "17/2"), ("8,50", "17/2"), ("100", "100"), ("-1", "-1"), ("", None), ("EX", None)],
)
def test_what_is_a_number_in_a_file(text: str, value: str | None) -> None:
    assert parsed(text) == (None if value is None else Fraction(value))


def test_steps_add_up_from_the_computed_to_the_final_mark() -> None:
    late = Lateness(60, "1/3", "1 min late")
    changed = row("anna", 8.5, late=late, change=Change("2", "seen in the lab", "r", "2026-01-01"))
    found = steps(changed)
    assert [(step.title, step.points) for step in found] == [
        ("lateness", Fraction(-3, 10)),  # 8.1667 is 8.2
        ("change by hand", Fraction(9, 5)),  # more than 10 there is not
    ]
    assert found[1].sentence == "seen in the lab (+2, in tenths from 0 to 10)"
    assert Fraction("8.5") + sum(step.points for step in found) == changed.exact_final == 10
    assert steps(row("anna", None)) == ()
