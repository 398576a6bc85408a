"""Extremes of polynomials of any degree: known ones, and those that defeat a division."""

import math

import numpy as np
import pytest

from tests.support_segments import blend
from vrts.check.curves.extremes import fastest, first_outside, zeros_of_derivatives

LENGTH = 2.0


def zeros(row: tuple[float, ...], order: int, length: float = LENGTH) -> list[float]:
    found = zeros_of_derivatives(np.array(row), np.array(length))
    places: list[float] = found[order - 1].tolist()
    return places


def test_the_zeros_of_every_derivative_are_found() -> None:
    # integral of (t - 0.25)(t - 0.5)(t - 1)(t - 1.75)
    slope = np.poly([0.25, 0.5, 1.0, 1.75])[::-1]
    row = (7.0, *(c / (k + 1) for k, c in enumerate(slope.tolist())))
    assert zeros(row, 1) == pytest.approx([0.25, 0.5, 1.0, 1.75], abs=1e-9)
    for order in (2, 3, 4):
        other = np.polynomial.Polynomial(row).deriv(order).roots().real
        assert zeros(row, order) == pytest.approx(sorted(other.tolist()), abs=1e-9)


@pytest.mark.parametrize("tiny", [0.0, 1e-300, 1e-30, -1e-18, 1e-12])
def test_a_vanishing_leading_coefficient_does_no_harm(tiny: float) -> None:
    row = (1.0, -3.0, 0.0, 1.0, tiny, tiny, tiny, tiny, tiny)  # t^3 - 3 t + 1 turns at 1
    assert min(abs(place - 1.0) for place in zeros(row, 1)) < 1e-9


def test_a_triple_zero_is_found() -> None:
    row = (-1.0, 4.0, -6.0, 4.0, -1.0)  # -(t - 1)^4 ends to rise at 1
    places = np.array(zeros(row, 1))
    assert np.max(-((places - 1.0) ** 4)) > -1e-15


def test_the_fastest_moment_of_a_quartic_lies_inside() -> None:
    row = (0.0, 0.0, 1.0, 0.0, -1.0)  # t^2 - t^4: speed 2 t - 4 t^3
    found = fastest(row, 0.7)
    assert found.at == pytest.approx(math.sqrt(1 / 6), abs=1e-9)
    assert found.size == pytest.approx(4 / 3 * math.sqrt(1 / 6), abs=1e-12)
    assert fastest(row, 0.3).at == 0.3


def test_what_stands_still_or_goes_steadily_has_its_speed_everywhere() -> None:
    assert fastest((0.4,), 1.0).size == 0.0
    assert fastest((0.4, -2.0), 1.0).size == 2.0


def test_a_quartic_leaves_a_range_between_its_ends() -> None:
    row = blend(0.0, 1.0, -1.0, 1.0)  # out and back: 0.3125 in the middle
    assert first_outside(row, 1.0, -1.0, 0.32) is None
    found = first_outside(row, 1.0, -1.0, 0.31)
    assert found is not None
    assert found == pytest.approx((0.5, 0.3125), abs=1e-9)
