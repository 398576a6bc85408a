"""Histograms: values in bars of the same width."""

from collections.abc import Sequence

from vrts.desk.figures.told import Bar

_DECIMALS = 6


def bars(values: Sequence[float], lowest: float, highest: float, count: int) -> tuple[Bar, ...]:
    """Return how many values lie in each of some bars.

    Args:
        values: From `lowest` to `highest`.
        lowest: Where the first bar begins.
        highest: Where the last one ends; no more than `lowest`: all values are one bar.
        count: Bars.
    """
    if highest <= lowest:
        return (Bar(lowest, lowest, len(values)),) if values else ()
    width = (highest - lowest) / count
    found = [0] * count
    for value in values:
        # a mark that is a tenth is not moved into the bar below it by binary fractions
        place = int(round((value - lowest) / width, _DECIMALS))
        found[min(max(place, 0), count - 1)] += 1
    edges = [round(lowest + width * k, _DECIMALS) for k in range(count + 1)]
    return tuple(Bar(edges[k], edges[k + 1], found[k]) for k in range(count))
