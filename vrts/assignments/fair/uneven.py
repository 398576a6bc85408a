"""Which variants are harder or easier than the others: duration, clearance, room for error."""

from collections.abc import Callable, Iterator, Sequence
from statistics import median
from typing import NamedTuple

from vrts.assignments.fair.trial import Trial
from vrts.base.units import mm
from vrts.check.variants.even import Even
from vrts.check.variants.model import Combination

SLACK = 1e-9  # of a bound, for the rounding of numbers


class Measure(NamedTuple):
    """One quantity by which variants are as hard as each other, or not."""

    title: str
    unit: str
    bound: str  # in words: "15 %"
    median: float  # in the unit
    least: tuple[float, Combination]
    most: tuple[float, Combination]
    allowed: tuple[float, float]
    outside: tuple[tuple[Combination, str], ...]  # which variants, and why, in words


def measures(trials: Sequence[Trial], even: Even) -> tuple[Measure, ...]:
    """Return how even the variants are of which the reference came to its end.

    Args:
        trials: Of different variants, in an order that is always the same.
        even: How far each may be from the median.
    """
    percent = "{:g} %".format
    asked = (
        ("time", "s", even.time, percent(round(100 * even.time, 6)), _time),
        ("clearance", "mm", None, f"{mm(even.clearance):g} mm", _clearance),
        ("accuracy", "mm", even.accuracy, percent(round(100 * even.accuracy, 6)), _accuracy),
    )
    return tuple(
        found
        for title, unit, share, bound, value in asked
        if (found := _measure(trials, title, unit, share, bound, value, mm(even.clearance)))
    )


def _measure(
    trials: Sequence[Trial],
    title: str,
    unit: str,
    share: float | None,
    bound: str,
    value: Callable[[Trial], float | None],
    width: float,
) -> Measure | None:
    known = [(v, trial.combination) for trial in trials if (v := value(trial)) is not None]
    if not known:
        return None
    middle = median(v for v, _ in known)
    wide = width if share is None else share * abs(middle)
    low, high = middle - wide - SLACK, middle + wide + SLACK
    outside = tuple(
        (combination, f"{title} {v:.1f} {unit}, and the median is {middle:.1f} {unit}")
        for v, combination in known
        if not low <= v <= high
    )
    least = min(known, key=lambda one: one[0])
    most = max(known, key=lambda one: one[0])
    allowed = (middle - wide, middle + wide)
    return Measure(title, unit, bound, middle, least, most, allowed, outside)


def fits(trial: Trial, found: Sequence[Measure]) -> bool:
    """Return whether a variant that was not among those compared is as hard as these."""
    values = {"time": _time(trial), "clearance": _clearance(trial), "accuracy": _accuracy(trial)}
    return not any(
        value is not None and not low - SLACK <= value <= high + SLACK
        for measure in found
        for value, (low, high) in ((values[measure.title], measure.allowed),)
    )


def _time(trial: Trial) -> float | None:
    return trial.time_s


def _clearance(trial: Trial) -> float | None:
    return None if trial.clearance_m is None else mm(trial.clearance_m)


def _accuracy(trial: Trial) -> float | None:
    return None if trial.accuracy_m is None else mm(trial.accuracy_m)


def problems_of(
    trials: Sequence[Trial], found: Sequence[Measure]
) -> Iterator[tuple[Combination, tuple[str, ...]]]:
    """Yield every variant that falls out, with all that is against it."""
    uneven: dict[Combination, list[str]] = {}
    for measure in found:
        for combination, words in measure.outside:
            uneven.setdefault(combination, []).append(words)
    for trial in trials:
        words = (*trial.problems, *uneven.get(trial.combination, ()))
        if words:
            yield trial.combination, words
