"""Pieces of a timeline above degree 3: blends, and slowing down inside of anything.

There are few of them beside the cubics of straight lines, so they have arrays of their own. Bounds
are widened by what rounding can do, so that none is ever too small.
"""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.curves.extremes import derivative, evaluate, zeros_of_derivatives

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

CUBIC = 4  # coefficients
ROUNDING = 1e-14  # share of the sum of the sizes of all terms; sound up to degree 8


class _Order(NamedTuple):
    """The coordinates, or one of their derivatives, on all pieces."""

    powers: Array  # (k, 7, p), ascending powers of t - start
    turns: Array  # (k, 7, r) local times among which are all extremes inside the piece
    turn_values: Array  # (k, 7, r) values there
    rounding: Array  # (k, 7) what rounding can change

    def at(self, piece: Indices, u: Array) -> Array:
        """Return values, shape (m, 7), at local times of shape (m,)."""
        return evaluate(self.powers[piece], u[:, None])

    def range(self, piece: Indices, a: Array, b: Array) -> tuple[Array, Array]:
        """Return the smallest and the largest value, both (m, 7), between local times (m,)."""
        ends = np.stack([self.at(piece, a), self.at(piece, b)], axis=-1)
        turns = self.turns[piece]
        inside = (turns > a[:, None, None]) & (turns < b[:, None, None])
        values = np.where(inside, self.turn_values[piece], ends[:, :, :1])
        values = np.concatenate([ends, values], axis=-1)
        rounding = self.rounding[piece]
        return values.min(axis=-1) - rounding, values.max(axis=-1) + rounding


class HighPieces(NamedTuple):
    """Polynomials of seven coordinates above degree 3."""

    value: _Order
    velocity: _Order
    acceleration: _Order

    def within(self, piece: Indices, a: Array, b: Array) -> Array:
        """Return [upper, -lower, speed, acceleration], (m, 28), between local times (m,)."""
        lower, upper = self.value.range(piece, a, b)
        slowest, fastest = self.velocity.range(piece, a, b)
        least, most = self.acceleration.range(piece, a, b)
        sizes = [np.maximum(-slowest, fastest), np.maximum(-least, most)]
        return np.concatenate([upper, -lower, *sizes], axis=1)


def is_high(rows: Sequence[Sequence[float]]) -> bool:
    """Return whether a row of coefficients is above degree 3."""
    return any(any(row[CUBIC:]) for row in rows)


def high_pieces(pieces: Sequence[Sequence[Sequence[float]]], length: Array) -> HighPieces:
    """Return the arrays of pieces.

    Args:
        pieces: Of each piece seven rows of ascending coefficients; at least one above degree 3.
        length: How long each lasts, shape (k,), in s.
    """
    count = max(len(row) for rows in pieces for row in rows)
    padded = [[[*row, *(0.0,) * (count - len(row))] for row in rows] for rows in pieces]
    powers = np.array(padded)
    turns = zeros_of_derivatives(powers, length[:, None])
    orders: list[_Order] = []
    for order in range(3):
        u = length[:, None]
        rounding = ROUNDING * evaluate(np.abs(powers), u)
        at_turns = evaluate(powers[:, :, None, :], turns[order])
        orders.append(_Order(powers, turns[order], at_turns, rounding))
        powers = derivative(powers)
    return HighPieces(*orders)
