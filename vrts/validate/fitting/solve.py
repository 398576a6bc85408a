"""Least squares over all chains: one acceleration, corner and lag, and every duration."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.optimize import least_squares
from scipy.sparse import csr_matrix

from vrts.validate.fitting.chains import Located
from vrts.validate.fitting.model import Shared, chain_values

Array = npt.NDArray[np.float64]

SHARED = 3  # numbers in front of those of the chains
SHORTEST_S, LONGEST_S = 0.02, 3.0  # of acceleration and of half a corner
LONGEST_LAG_S = 0.3
STEP_S = 1e-5  # of the numeric derivatives
FIRST_LAG_S = 0.01
STEPS = 60
ENOUGH = 1e-6  # a step that gains less, as a share, is the last


class Solution(NamedTuple):
    """What fits best."""

    shared: Shared
    sigma: tuple[float, float, float]  # standard deviations of its numbers [s]
    durations: tuple[tuple[float, ...], ...]  # of every chain [s]
    residual: float  # RMS


def solve(chains: Sequence[Located], first: Shared) -> Solution:
    """Return what fits best to chains, beginning with the numbers that were assumed."""
    starts: list[float] = [first.acceleration, first.half_blend, FIRST_LAG_S]
    places: list[int] = []
    for one in chains:
        places.append(len(starts))
        starts += [one.departure_s, *one.durations]
    x0 = np.array(starts)
    lower, upper = np.full(len(x0), -np.inf), np.full(len(x0), np.inf)
    lower[:SHARED] = SHORTEST_S, SHORTEST_S, 0.0
    upper[:SHARED] = LONGEST_S, LONGEST_S, LONGEST_LAG_S
    for place, one in zip(places, chains, strict=True):
        guessed = np.array(one.durations)
        inside = slice(place + 1, place + 1 + len(guessed))
        lower[inside], upper[inside] = 0.2 * guessed, 5.0 * guessed

    def residuals(x: Array) -> Array:
        return np.concatenate(
            [_residual(one, x, place) for place, one in zip(places, chains, strict=True)]
        )

    def jacobian(x: Array) -> csr_matrix:
        blocks = [_residual(one, x, place) for place, one in zip(places, chains, strict=True)]
        found = np.zeros((sum(map(len, blocks)), len(x)))
        row = 0
        for block, place, one in zip(blocks, places, chains, strict=True):
            own = range(place, place + 1 + len(one.durations))
            for column in (*range(SHARED), *own):
                moved = x.copy()
                moved[column] += STEP_S
                found[row : row + len(block), column] = (
                    _residual(one, moved, place) - block
                ) / STEP_S
            row += len(block)
        return csr_matrix(found)  # a chain knows nothing of the numbers of others

    fit = least_squares(
        residuals,
        x0,
        jacobian,
        bounds=(lower, upper),
        x_scale="jac",
        tr_solver="lsmr",
        ftol=ENOUGH,
        xtol=ENOUGH,
        max_nfev=STEPS,
    )
    x = fit.x
    variance = 2.0 * float(fit.cost) / max(len(fit.fun) - len(x), 1)
    information = (fit.jac.T @ fit.jac).toarray()
    spread = np.sqrt(variance * np.clip(np.diag(np.linalg.pinv(information)), 0.0, None))
    return Solution(
        Shared(float(x[0]), float(x[1]), float(x[2])),
        (float(spread[0]), float(spread[1]), float(spread[2])),
        tuple(
            tuple(x[place + 1 : place + 1 + len(one.durations)].tolist())
            for place, one in zip(places, chains, strict=True)
        ),
        variance**0.5,
    )


def _residual(one: Located, x: Array, place: int) -> Array:
    """Return measured minus modelled; a constant error of a coordinate does not count."""
    own = x[place : place + 1 + len(one.durations)]
    shared = Shared(float(x[0]), float(x[1]), float(x[2]))
    error = one.values - chain_values(one.times, one.ways, float(own[0]), own[1:], shared)
    return (error - error.mean(axis=0)).ravel()
