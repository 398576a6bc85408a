"""What is left over: how large it is, how much of it is new from row to row, and its pattern."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

LONGEST_SHARE = 0.1  # of the rows: correlation is looked for so far apart
TESTED = 8  # rows apart, in the test for a pattern
BLOCKS = (8, 16, 32)  # into which a log is parted to find what lasts for long
FEWEST_EACH = 20  # rows of a block
SURELY = 3.0  # standard deviations beyond chance


class Left(NamedTuple):
    """The residuals of a fit."""

    rms: Array  # of every channel, at least what a step of it makes [rad, m]
    times_correlated: Array  # of every channel: so many rows tell as much as one
    patterned: Array  # RMS of the part that lasts for several rows, of every channel

    @property
    def rows_each(self) -> float:
        """How many rows tell as much as one, of the worst channel."""
        return float(self.times_correlated.max())


def resolution(values: Array) -> Array:
    """Return the standard deviation that rounding makes, of every channel.

    The step is the least distance between two values that are not the same.
    """
    found = np.zeros(values.shape[1])
    for k in range(values.shape[1]):
        gaps = np.diff(np.unique(np.round(values[:, k], 12)))
        gaps = gaps[gaps > 1e-10]
        found[k] = float(np.percentile(gaps, 5)) / np.sqrt(12.0) if len(gaps) else 1e-9
    return found


def left_over(residual: Array, least: Array) -> Left:
    """Return what is to be said of residuals.

    Args:
        residual: Shape (n, channels).
        least: What rounding makes, of every channel.
    """
    n = len(residual)
    square = (residual**2).mean(axis=0)
    times = np.ones(residual.shape[1])
    pattern = np.zeros(residual.shape[1])
    for k in range(residual.shape[1]):
        correlation = _correlation(residual[:, k])
        below = np.flatnonzero(correlation[1:] <= 2.0 / np.sqrt(n))
        last = int(below[0]) + 1 if len(below) else len(correlation)
        times[k] = max(1.0 + 2.0 * float(correlation[1:last].sum()), 1.0)
        near = correlation[1 : TESTED + 1]
        if n * float((near**2).sum()) > TESTED + 5.0 * np.sqrt(2.0 * TESTED):
            pattern[k] = np.sqrt(square[k] * max(float(near[:2].mean()), 0.0))
    return Left(np.sqrt(square + least**2), times, pattern)


def _correlation(values: Array) -> Array:
    """Return the autocorrelation, from 0 rows apart on."""
    off = values - values.mean()
    n = len(off)
    most = max(int(LONGEST_SHARE * n), TESTED + 2)
    size = 1 << (2 * n).bit_length()
    spectrum = np.fft.rfft(off, size)
    found = np.fft.irfft(spectrum * np.conj(spectrum), size)[:most]
    return found / max(float(found[0]), 1e-300)


def covariance(jacobian: Array, sigma: Array, times_correlated: Array) -> Array:
    """Return the covariance of fitted numbers.

    A row counts as a part of one where errors of rows beside one another are alike.

    Args:
        jacobian: Shape (n, channels, k).
        sigma: Of every channel.
        times_correlated: Of every channel, so many rows tell as much as one.
    """
    n, _, k = jacobian.shape
    white = jacobian / sigma[:, None]
    flat = white.reshape(-1, k)
    inverse = np.linalg.pinv(flat.T @ flat, rcond=1e-14, hermitian=True)
    alike = (white * np.sqrt(times_correlated)[:, None]).reshape(-1, k)
    found: Array = n / max(n - k, 1) * inverse @ (alike.T @ alike) @ inverse
    return found


def lasting(jacobian: Array, residual: Array, left: Left) -> Array:
    """Return by how much errors of fitted numbers are larger, as what is left lasts for long.

    What is too small to be seen in any row may add up over many, as where motions come a third
    of a millisecond late. The log is parted into blocks: what is left pulls at a number in each,
    and pulls of blocks have to differ as chance would have it. 1 where they do.

    Args:
        jacobian: Shape (n, channels, k).
        residual: Shape (n, channels).
        left: What is to be said of the residuals.
    """
    n, _, k = jacobian.shape
    white = jacobian / left.rms[:, None]
    flat = white.reshape(-1, k)
    inverse = np.linalg.pinv(flat.T @ flat, rcond=1e-14, hermitian=True)
    pulls = np.einsum("nck,nc->nk", white, residual / left.rms) @ inverse
    alone = np.diag(covariance(jacobian, left.rms, left.times_correlated))
    found = np.ones(k)
    for count in BLOCKS:
        if n < FEWEST_EACH * count:
            continue
        starts = np.array([k * n // count for k in range(count)], np.intp)
        sums = np.add.reduceat(pulls, starts, axis=0)
        share = count / (count - 1) * (sums**2).sum(axis=0) / np.maximum(alone, 1e-300)
        by_chance = 1.0 + SURELY * np.sqrt(2.0 / count)
        found = np.where(share > by_chance, np.maximum(found, np.sqrt(share)), found)
    return found
