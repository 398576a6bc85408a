"""Single precision, and rounding as the controller does it."""

import pytest

from vrts.base.numbers import LARGEST_SINGLE, round_half_away, single


def test_a_tenth_is_the_nearest_single() -> None:
    assert single(0.1) == 0.10000000149011612


def test_integers_are_exact_up_to_24_bits() -> None:
    assert single(16_777_215.0) == 16_777_215.0
    assert single(16_777_217.0) == 16_777_216.0


def test_what_underflows_becomes_zero() -> None:
    assert single(1e-60) == 0.0


@pytest.mark.parametrize("value", [LARGEST_SINGLE * 1.1, float("nan"), float("inf")])
def test_what_single_precision_cannot_hold_raises(value: float) -> None:
    with pytest.raises(OverflowError):
        single(value)


@pytest.mark.parametrize(
    ("value", "rounded"), [(1.6, 2), (2.5, 3), (-2.5, -3), (0.49, 0), (-0.5, -1), (7.0, 7)]
)
def test_halves_round_away_from_zero(value: float, rounded: int) -> None:
    assert round_half_away(value) == rounded
