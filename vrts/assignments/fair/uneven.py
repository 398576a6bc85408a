"""Which variants are harder or easier than the others: duration, clearance, room for error."""

from collections.abc import Iterator, Mapping, Sequence
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
    of: str  # what asks for an accuracy; "": the whole run
    unit: str
    bound: str  # in words: "15 %"
    median: float  # in the unit
    least: tuple[float, Combination]
    most: tuple[float, Combination]
    allowed: tuple[float, float]
    outside: tuple[tuple[Combination, str], ...]  # which variants, and why, in words

    @property
    def spread(self) -> float:
        """How far it goes from the median, as a share of how far it may."""
        wide = self.allowed[1] - self.median + SLACK
        return max(self.median - self.least[0], self.most[0] - self.median) / wide


class _Key(NamedTuple):
    """What is measured."""

    title: str
    of: str
    unit: str


def measures(trials: Sequence[Trial], even: Even) -> tuple[Measure, ...]:
    """Return how even the variants are of which the reference came to its end.

    Each tolerance is compared with its own median. A variant in which something cannot be measured
    that the others have falls out.

    Args:
        trials: Of different variants, in an order that is always the same.
        even: How far each may be from the median.
    """
    values = [(trial, _values(trial)) for trial in trials]
    keys = dict.fromkeys(key for _, known in values for key in known)
    return tuple(_measure(key, values, even) for key in keys)


def shown(found: Sequence[Measure]) -> tuple[Measure, ...]:
    """Return what to show: of accuracies those by which variants fall out, else the widest one."""
    rooms = [one for one in found if one.of]
    out = [one for one in rooms if one.outside]
    widest = sorted(rooms, key=lambda one: (-round(one.spread, 6), one.unit != "mm", one.median))
    return (*(one for one in found if not one.of), *(out or widest[:1]))


def _measure(
    key: _Key, values: Sequence[tuple[Trial, Mapping[_Key, float]]], even: Even
) -> Measure:
    name = f"{key.title} of {key.of}" if key.of else key.title
    known = [(some[key], trial.combination) for trial, some in values if key in some]
    middle = median(v for v, _ in known)
    share = {"time": even.time, "accuracy": even.accuracy}.get(key.title)
    wide = mm(even.clearance) if share is None else share * abs(middle)
    bound = f"{wide:g} mm" if share is None else f"{round(100 * share, 6):g} %"
    low, high = middle - wide - SLACK, middle + wide + SLACK
    colon = ":" if key.of else ""
    far = [
        (
            combination,
            f"{name}{colon} {v:.1f} {key.unit}, and the median is {middle:.1f} {key.unit}",
        )
        for v, combination in known
        if not low <= v <= high
    ]
    some_good = any(key in some and not trial.problems for trial, some in values)
    without = [
        (trial.combination, f"{name} cannot be measured, and {middle:.1f} {key.unit} is the median")
        for trial, some in values
        if key not in some and not trial.problems and some_good
    ]
    least = min(known, key=lambda one: one[0])
    most = max(known, key=lambda one: one[0])
    allowed = (middle - wide, middle + wide)
    return Measure(*key, bound, middle, least, most, allowed, (*far, *without))


def fits(trial: Trial, found: Sequence[Measure]) -> bool:
    """Return whether a variant that was not among those compared is as hard as these."""
    values = _values(trial)
    return all(
        value is not None and low - SLACK <= value <= high + SLACK
        for measure in found
        for value, (low, high) in (
            (values.get(_Key(measure.title, measure.of, measure.unit)), measure.allowed),
        )
    )


def _values(trial: Trial) -> dict[_Key, float]:
    found: dict[_Key, float] = {}
    if trial.time_s is not None:
        found[_Key("time", "", "s")] = trial.time_s
    if trial.clearance_m is not None:
        found[_Key("clearance", "", "mm")] = mm(trial.clearance_m)
    for room in trial.rooms:
        found[_Key("accuracy", room.of, room.unit)] = room.value
    return found


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
