"""Where polynomials of any degree turn, for thousands of them at once.

Between two neighbouring zeros of its derivative a polynomial is monotone and has one zero at most.
So the chain of derivatives, begun at the constant one, finds all zeros of each by halving; no
leading coefficient is divided by, and tiny ones do no harm. A place that is no zero may be among
those found, but no zero at which the sign changes is left out: the extremes are among the values at
the places found and at both ends.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]

HALVINGS = 34  # of brackets no longer than 1; a place off by w changes an extreme by f'' w^2 / 2


class Extreme(NamedTuple):
    """The largest size of a polynomial on an interval."""

    size: float
    at: float  # where, from the start of the interval


def evaluate(powers: Array, u: Array) -> Array:
    """Return polynomials, ascending coefficients along the last axis, at places.

    Args:
        powers: Coefficients, shape (..., p), with p at least 1.
        u: Places; its shape broadcasts against (...).
    """
    if powers.shape[-1] == 1:
        return powers[..., 0] + np.zeros_like(u)
    total = powers[..., -1] * u
    total += powers[..., -2]
    for k in range(powers.shape[-1] - 3, -1, -1):
        total *= u
        total += powers[..., k]
    return total


def derivative(powers: Array) -> Array:
    """Return the coefficients of derivatives, shape (..., p - 1); p is at least 2."""
    return powers[..., 1:] * np.arange(1.0, powers.shape[-1])


def zeros_of_derivatives(powers: Array, length: Array) -> tuple[Array, ...]:
    """Return the places at which derivatives change their sign, and perhaps others.

    Args:
        powers: Coefficients, shape (..., p).
        length: Polynomials are looked at on [0, length]; broadcasts against (...).

    Returns:
        For the derivative of order k = 1 .. p - 2 an array of shape (..., p - 1 - k): places in
        [0, length], ascending, right to length / 2^34.
    """
    count = powers.shape[-1]
    span = np.broadcast_to(length, powers.shape[:-1])[..., None]
    chain = [powers * np.power(span, np.arange(0.0, count))]  # on [0, 1]
    while chain[-1].shape[-1] > 2:
        chain.append(derivative(chain[-1]))
    found: list[Array] = []
    low, high = np.zeros(span.shape), np.ones(span.shape)
    inner = np.empty((*span.shape[:-1], 0))
    for powers_k in reversed(chain[1:]):
        edges = np.concatenate([low, inner, high], axis=-1)
        inner = _zero_between(powers_k, edges[..., :-1], edges[..., 1:])
        found.append(inner * span)
    return tuple(reversed(found))


def fastest(row: tuple[float, ...], length: float) -> Extreme:
    """Return the largest speed of one polynomial on [0, length], and when."""
    powers = np.array([*row, 0.0, 0.0, 0.0])
    places = np.concatenate([[0.0], zeros_of_derivatives(powers, np.array(length))[1], [length]])
    sizes = np.abs(evaluate(derivative(powers), places))
    best = int(np.argmax(sizes))
    return Extreme(float(sizes[best]), float(places[best]))


def first_outside(
    row: tuple[float, ...], length: float, lower: float, upper: float
) -> tuple[float, float] | None:
    """Return the first end or turning point of a polynomial that lies outside a range.

    Returns:
        The place on [0, length] and the value there; None when the range is never left.
    """
    powers = np.array([*row, 0.0, 0.0])
    places = np.concatenate([[0.0], zeros_of_derivatives(powers, np.array(length))[0], [length]])
    for place, value in zip(places.tolist(), evaluate(powers, places).tolist(), strict=True):
        if not lower <= value <= upper:
            return place, value
    return None


def _zero_between(powers: Array, low: Array, high: Array) -> Array:
    """Return the zeros of polynomials between places where they differ in sign, else any place."""
    powers = powers[..., None, :]
    positive = evaluate(powers, low) > 0.0
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        before = (evaluate(powers, middle) > 0.0) == positive
        low = np.where(before, middle, low)
        high = np.where(before, high, middle)
    return 0.5 * (low + high)
