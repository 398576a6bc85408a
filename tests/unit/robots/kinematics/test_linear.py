"""Small linear systems against numpy."""

import random

import numpy as np
import pytest

from vrts.robots.kinematics.linear import solve_linear, solve_symmetric

NUMBERS = random.Random(8)


def some_columns() -> list[tuple[float, ...]]:
    return [tuple(NUMBERS.uniform(-1, 1) for _ in range(6)) for _ in range(6)]


def test_several_right_hand_sides_are_solved() -> None:
    for _ in range(20):
        columns = some_columns()
        wanted = some_columns()[:2]
        found = solve_linear(columns, wanted)
        assert found is not None
        A = np.array(columns).T
        for x, b in zip(found, wanted, strict=True):
            assert x == pytest.approx(np.linalg.solve(A, np.array(b)), abs=1e-9)


def test_dependent_equations_have_no_answer() -> None:
    columns = some_columns()
    columns[3] = columns[0]
    assert solve_linear(columns, [columns[1]]) is None


@pytest.mark.parametrize("damping", [1e-12, 1e-3, 1.0])
def test_damped_squares_are_solved(damping: float) -> None:
    for _ in range(20):
        columns = some_columns()
        wanted = some_columns()[0]
        J = np.array(columns).T
        x = np.linalg.solve(J.T @ J + damping * np.eye(6), J.T @ np.array(wanted))
        assert solve_symmetric(columns, wanted, damping) == pytest.approx(x, rel=1e-6, abs=1e-7)


def test_damping_answers_where_equations_are_dependent() -> None:
    columns = some_columns()
    columns[3] = columns[0]
    found = solve_symmetric(columns, columns[1], 1e-6)
    assert all(abs(value) < 10.0 for value in found)
    reached = np.array(columns).T @ np.array(found)
    assert reached == pytest.approx(columns[1], abs=1e-4)
