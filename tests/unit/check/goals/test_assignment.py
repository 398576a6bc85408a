"""Assignments against every permutation, and against scipy's."""

from itertools import permutations
from random import Random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import linear_sum_assignment

from vrts.check.goals.assignment import assigned


@st.composite
def tables(draw: st.DrawFn) -> list[list[int]]:
    """Return values of at most four rows for at most five columns, with many ties."""
    rows = draw(st.integers(1, 4))
    columns = draw(st.integers(rows, 5))
    value = st.integers(-3, 3)
    return [[draw(value) for _ in range(columns)] for _ in range(rows)]


@given(tables())
def test_the_best_sum_and_of_equal_sums_the_earliest_columns(table: list[list[int]]) -> None:
    ways = permutations(range(len(table[0])), len(table))
    best = min(ways, key=lambda way: (-sum(table[k][n] for k, n in enumerate(way)), way))
    assert assigned(table) == best


@pytest.mark.parametrize("size", [12, 24])
def test_large_ones_are_as_good_as_those_of_scipy(size: int) -> None:
    chance = Random(size)
    table = [[chance.randrange(10**6) for _ in range(size)] for _ in range(size // 2)]
    found = assigned(table)
    assert len(set(found)) == len(found)
    rows, columns = linear_sum_assignment(np.array(table), maximize=True)
    best = sum(table[int(k)][int(n)] for k, n in zip(rows, columns, strict=True))
    assert sum(table[k][n] for k, n in enumerate(found)) == best


def test_nothing_is_rounded() -> None:
    large = 10**40
    assert assigned([[large, large + 1], [0, 0]]) == (1, 0)


def test_more_rows_than_columns_are_a_bad_call() -> None:
    with pytest.raises(ValueError, match="more rows"):
        assigned([[1], [2]])
