"""Polynomials in ascending powers: value, shift, composition with a time scaling."""

from collections.abc import Sequence
from typing import TypeAlias

Row: TypeAlias = tuple[float, ...]
"""sum_k row[k] t^k."""


def value(row: Sequence[float], t: float) -> float:
    """Return the value at t."""
    total = 0.0
    for c in reversed(row):
        total = total * t + c
    return total


def rate(row: Sequence[float], t: float) -> float:
    """Return the derivative at t."""
    total = 0.0
    for k in range(len(row) - 1, 0, -1):
        total = total * t + k * row[k]
    return total


def shifted(row: Row, by: float) -> Row:
    """Return the polynomial of t + by."""
    if by == 0.0 or len(row) == 1:
        return row
    result = list(row)
    for k in range(len(row) - 1):
        for j in range(len(row) - 2, k - 1, -1):
            result[j] += by * result[j + 1]
    return tuple(result)


def composed(row: Row, inner: Row) -> Row:
    """Return row(inner(t))."""
    if len(row) == 1:
        return row
    result = [row[-1]]
    for c in reversed(row[:-1]):
        product = [0.0] * (len(result) + len(inner) - 1)
        for i, a in enumerate(result):
            for j, b in enumerate(inner):
                product[i + j] += a * b
        product[0] += c
        result = product
    return tuple(result)


def added(a: Row, b: Row) -> Row:
    """Return the sum of two polynomials."""
    if len(a) < len(b):
        a, b = b, a
    return tuple(x + b[k] if k < len(b) else x for k, x in enumerate(a))
