"""Fingerprints of a sequence of symbols: the smallest hash of every window.

Two sequences that share `K + W - 1` symbols in a row share a fingerprint; what is shorter than `K`
is never matched [Schleimer2003]_.
"""

from collections import deque
from collections.abc import Collection, Sequence

K = 12  # symbols of a fingerprint: about three steps
W = 8  # fingerprints of a window, of which one is kept

_BASE = 1_000_003
_MODULUS = (1 << 61) - 1
_SCRAMBLE = 0x9E3779B97F4A7C15  # so that the order of hashes says nothing of the symbols
_MASK = (1 << 64) - 1


def hashes(symbols: Sequence[int]) -> list[int]:
    """Return the hash of every run of `K` symbols, by where it begins."""
    if len(symbols) < K:
        return []
    top = pow(_BASE, K, _MODULUS)
    value = 0
    found: list[int] = []
    for place, symbol in enumerate(symbols):
        value = (value * _BASE + symbol + 1) % _MODULUS
        if place >= K:
            value = (value - (symbols[place - K] + 1) * top) % _MODULUS
        if place >= K - 1:
            found.append(value * _SCRAMBLE & _MASK)
    return found


def winnow(values: Sequence[int], without: Collection[int] = ()) -> list[tuple[int, int]]:
    """Return the fingerprints of hashes: pairs of hash and place, in order.

    Args:
        values: Of every run of symbols.
        without: Hashes that do not count, as everybody was given them.
    """
    found: list[tuple[int, int]] = []
    window: deque[int] = deque()  # places of values that may still be smallest, growing
    last = -1
    for place, value in enumerate(values):
        if value not in without:
            while window and values[window[-1]] >= value:
                window.pop()
            window.append(place)
        if window and window[0] <= place - W:
            window.popleft()
        complete = place >= W - 1 or place == len(values) - 1
        if complete and window and window[0] != last:
            last = window[0]
            found.append((values[last], last))
    return found
