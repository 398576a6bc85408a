"""The fewest causes that explain a log: the best one first, as long as each explains enough."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.validate.identify.again import Again
from vrts.validate.identify.causes import Cause, Kind, causes_for
from vrts.validate.identify.clocks import by_stretches, moved, whole
from vrts.validate.identify.forward import Clock, Rows, residuals
from vrts.validate.identify.noise import left_over, resolution
from vrts.validate.identify.solve import (
    Fit,
    clock_columns,
    columns,
    least_squares,
    objective,
    solve,
)
from vrts.validate.identify.ticks import Between, between, deciding, grid_of, search
from vrts.validate.log.log import RobotLog

Array = npt.NDArray[np.float64]
Group = tuple[Cause, ...]

MOST = 8  # causes
TRIED = 3  # of the most promising, each is fitted
WORTH = 8.0  # what a cause has to gain beyond the logarithm of the rows for each number
ALIKE = 10.0  # causes whose gains differ by less cannot be told apart
MATTERS = 0.2  # of what is left over: a cause that changes the log by less is none
SEARCH_ROWS = 300
PATTERN = 0.5  # of what is left over: no larger part of it may last for several rows
OTHER_RESTS_S = 0.1  # of rests that differ by more a robot has its own
NEARER = 0.1  # of what is left with one clock: so little is left with one for each stretch
WIDE = 0.08  # a number that works through ticks lies within this share of the best


class Chosen(NamedTuple):
    """A cause, and others that explain the log as well."""

    group: Group
    gain: float
    alike: tuple[Group, ...]


@dataclass(frozen=True, slots=True)
class Choice:
    """What was chosen."""

    rows: Rows
    fit: Fit
    first: Fit  # with the clock alone
    chosen: tuple[Chosen, ...]
    between: Mapping[Cause, Between]  # of numbers that work through ticks
    least: Array  # what rounding makes, of every channel


class _Search(NamedTuple):
    again: Again
    log: RobotLog
    rows: Rows
    few: Rows  # some of them
    least: Array
    clock: Clock  # of the run with the numbers that are assumed
    decide: tuple[Cause, ...]


def choose(again: Again, log: RobotLog, rows: Rows) -> Choice:
    """Return the fewest causes; where they explain too little, every stretch has its own clock."""
    least = resolution(rows.measured())
    clock = whole(again.run, log, rows)
    every = max(len(rows.times) // SEARCH_ROWS, 1)
    decide = deciding(again)
    few = _few(rows, every)
    one_clock = _Search(again, log, rows, few, least, clock, decide)
    parted = by_stretches(again.run, rows, clock)
    own, alone = None, solve(again, rows, clock, {}, (), least)
    if parted is not None and not _plain(one_clock, alone):
        own = _chosen(_Search(again, log, rows, few, least, parted, decide))
        nearer = (own.fit.residual**2).mean() < NEARER**2 * (alone.residual**2).mean()
        rests_differ = float(np.ptp(own.fit.clock.shifts)) > OTHER_RESTS_S
        if rests_differ and (explained(own) or bool(nearer)):
            return own
    found = _chosen(one_clock)
    if own is None or explained(found):
        return found
    more = len(own.fit.clock.shifts) - 1 + _numbers(own) - _numbers(found)
    dearer = more * (np.log(len(rows.times)) + WORTH)
    return own if own.fit.objective + dearer < found.fit.objective else found


def explained(found: Choice) -> bool:
    """Whether what is left over has no pattern that is larger than what lies beside it."""
    left = left_over(found.fit.residual, found.least)
    return bool((left.patterned <= PATTERN * left.rms).all())


def _numbers(found: Choice) -> int:
    return sum(len(one.group) for one in found.chosen)


def _few(rows: Rows, every: int) -> Rows:
    """Return some rows, and of them the joints alone where there are any: they tell times."""
    if rows.joints is not None:
        return Rows(rows.times[::every], rows.joints[::every], None, rows.middle_s)
    assert rows.positions is not None
    return Rows(rows.times[::every], None, rows.positions[::every], rows.middle_s)


def _chosen(s: _Search) -> Choice:
    rows = s.rows
    candidates = causes_for(
        s.again.run.scene.robot.arm,
        joints=rows.joints is not None,
        positions=rows.positions is not None,
        decide=s.decide,
    )
    if not s.clock.whole:
        candidates = [group for group in candidates if group != (Cause(Kind.LAG, 1),)]
    fit = first = solve(s.again, rows, s.clock, {}, (), s.least)
    chosen: list[Chosen] = []
    for _ in range(MOST):
        open_ = [group for group in candidates if _new(group, chosen)]
        smooth = [group for group in open_ if not group[0].by_ticks]
        promising = sorted(_promise(s, fit, chosen, smooth), key=lambda one: -one[1])
        gains = _gains(s, fit, chosen, promising[:TRIED])
        best_left = max(gains, key=lambda one: one[2])[1] if gains else fit
        if not _plain(s, fit) and not _plain(s, best_left):
            # what is left lasts for several rows: other times may explain it
            ticks = [group for group in open_ if group[0].by_ticks]
            later = sorted((_searched(s, fit, group) for group in ticks), key=lambda one: -one[1])
            gains += _gains(s, fit, chosen, later[:TRIED])
            promising += later[TRIED:]
        good = [one for one in gains if one[2] > 0.0 and _matters(s, one[1], one[0])]
        if not good:
            break
        best = max(good, key=lambda one: one[2])
        simplest = min(
            (one for one in good if one[2] > best[2] - 1.0),
            key=lambda one: (len(one[0]), candidates.index(one[0])),
        )
        rivals = _rivals(simplest, gains, promising)
        chosen.append(Chosen(simplest[0], simplest[2], rivals))
        fit = simplest[1]
    chosen, fit = _pruned(s, fit, chosen)
    spans, fit = _spans(s, fit, chosen)
    return Choice(rows, fit, first, tuple(chosen), spans, s.least)


def _pruned(s: _Search, fit: Fit, chosen: list[Chosen]) -> tuple[list[Chosen], Fit]:
    """Return what is left without numbers that are not worth their price any more."""
    while True:
        causes = _fitted(chosen)
        if len(causes) < 2:
            return chosen, fit
        without: list[tuple[float, Cause, Fit]] = []
        for cause in causes:
            if cause.by_ticks:
                continue
            rest = tuple(c for c in causes if c != cause)
            values = {c: value for c, value in fit.values.items() if c != cause}
            other = solve(s.again, s.rows, fit.clock, values, rest, s.least)
            worth = _worth(s, other, fit, (cause,))
            if worth < 0.0 or not _matters(s, fit, (cause,)):
                without.append((worth, cause, other))
        if not without:
            return chosen, fit
        _, least, fit = min(without, key=lambda one: one[0])
        cut = [one._replace(group=tuple(c for c in one.group if c != least)) for one in chosen]
        chosen = [one for one in cut if one.group]


def _new(group: Group, chosen: Sequence[Chosen]) -> bool:
    """Whether a group has a number that was not chosen, and no second lag."""
    taken = {cause for one in chosen for cause in one.group}
    lags = any(cause.kind is Kind.LAG for cause in taken)
    return not taken.issuperset(group) and not (lags and group[0].kind is Kind.LAG)


def _fitted(chosen: Sequence[Chosen], group: Group = ()) -> Group:
    return tuple(dict.fromkeys((*(c for one in chosen for c in one.group), *group)))


def _rivals(
    best: tuple[Group, Fit, float],
    gains: Sequence[tuple[Group, Fit, float]],
    promising: Sequence[tuple[Group, float]],
) -> tuple[Group, ...]:
    """Return causes that explain as much: those that were fitted, and others by their promise."""
    fitted = {group: worth for group, _, worth in gains}
    promised = dict(promising)
    found = [group for group in fitted if fitted[group] > best[2] - ALIKE]
    if best[0] in promised:
        least = promised[best[0]] - ALIKE
        found += [g for g, worth in promising if g not in fitted and worth > least]
    return tuple(g for g in found if g != best[0] and len(g) == len(best[0]))


def _gains(
    s: _Search, fit: Fit, chosen: Sequence[Chosen], promising: Sequence[tuple[Group, float]]
) -> list[tuple[Group, Fit, float]]:
    found: list[tuple[Group, Fit, float]] = []
    for group, _ in promising:
        other = _with(s, fit, chosen, group)
        found.append((group, other, _worth(s, fit, other, group)))
    return found


def _plain(s: _Search, fit: Fit) -> bool:
    """Whether what is left of the channels that tell times has no pattern worth a word."""
    tell = s.few.channels
    left = left_over(fit.residual[:, :tell], s.least[:tell])
    return bool((left.patterned <= PATTERN * left.rms).all())


def _promise(
    s: _Search, fit: Fit, chosen: Sequence[Chosen], groups: Sequence[Group]
) -> list[tuple[Group, float]]:
    """Return what groups would gain beyond their price, about."""
    smooth = [c for c in _fitted(chosen) if not c.by_ticks]
    wanted = list(dict.fromkeys(c for g in groups for c in g))
    sigma = np.sqrt((fit.residual**2).mean(axis=0) + s.least**2)
    known = np.concatenate(
        (
            clock_columns(s.again, s.rows, fit.clock, fit.values),
            columns(s.again, s.rows, fit.clock, fit.values, smooth),
        ),
        axis=2,
    )
    new = columns(s.again, s.rows, fit.clock, fit.values, wanted)
    found: list[tuple[Group, float]] = []
    for group in groups:
        J = np.concatenate((known, new[:, :, [wanted.index(c) for c in group]]), axis=2)
        step = least_squares(J / sigma[:, None], fit.residual / sigma)
        gain = fit.objective - objective(fit.residual - J @ step, s.least)
        found.append((group, gain - _price(s, group)))
    return found


def _searched(s: _Search, fit: Fit, group: Group) -> tuple[Group, float]:
    """Return what a number that works through ticks would gain, about."""
    begun = _weighed(s, s.few, fit, fit.values, (), 1).objective
    _, reached = _looked_for(s, fit, group[0])
    part = len(s.rows.times) / len(s.few.times)
    return group, part * (begun - reached) - _price(s, group)


def _looked_for(s: _Search, fit: Fit, cause: Cause) -> tuple[float, float]:
    now = fit.values.get(cause, 0.0)

    def weighs(value: float) -> float:
        return _weighed(s, s.few, fit, {**fit.values, cause: value}, (), 3).objective

    return search(sorted({now, *grid_of(s.again, cause)}), weighs)


def _weighed(
    s: _Search, rows: Rows, fit: Fit, values: Mapping[Cause, float], causes: Group, steps: int
) -> Fit:
    """Return a fit with given values of numbers that work through ticks, the clock found anew."""
    run = s.again.with_values(values)
    if s.clock.whole:
        clock = Clock(whole(run, s.log, rows).shifts, np.zeros(len(rows.times), np.intp))
        near = Clock(fit.clock.shifts, clock.which)
        least = _least(s, rows)
        off = [objective(residuals(s.again, rows, c, values), least) for c in (clock, near)]
        begin = clock if off[0] < off[1] else near
        return solve(s.again, rows, begin, values, causes, least, steps)
    before = s.again.with_values(fit.values)
    clock = moved(fit.clock, before, run)
    at = np.searchsorted(s.rows.times, rows.times)
    placed = Clock(clock.shifts, clock.which[at])
    return solve(s.again, rows, placed, values, causes, _least(s, rows), steps)


def _least(s: _Search, rows: Rows) -> Array:
    """Return what rounding makes, of the channels that some rows have."""
    return s.least[: rows.channels]


def _with(s: _Search, fit: Fit, chosen: Sequence[Chosen], group: Group) -> Fit:
    """Return the fit of a group beside what was chosen; numbers by ticks are looked for again."""
    causes = _fitted(chosen, group)
    if not group[0].by_ticks:
        starts = {**fit.values}
        for cause in group:
            if cause.kind is Kind.LAG:
                starts[cause] = 5.0 * cause.step
        found = solve(s.again, s.rows, fit.clock, starts, causes, s.least)
    else:
        value, _ = _looked_for(s, fit, group[0])
        found = _weighed(s, s.rows, fit, {**fit.values, group[0]: value}, causes, 8)
    for cause in causes:
        if cause.by_ticks and len([c for c in causes if not c.by_ticks or c != cause]):
            found = _refined(s, found, cause, causes)
    return found


def _refined(s: _Search, fit: Fit, cause: Cause, causes: Group) -> Fit:
    """Return a fit with one number looked for near where it is."""
    now = fit.values[cause]
    reach = _reach(s, cause)

    def weighs(value: float) -> float:
        return _weighed(s, s.few, fit, {**fit.values, cause: value}, (), 2).objective

    value, _ = search([*np.linspace(now - reach, now + reach, 9).tolist(), now], weighs)
    other = _weighed(s, s.rows, fit, {**fit.values, cause: value}, causes, 5)
    return other if other.objective < fit.objective else fit


def _reach(s: _Search, cause: Cause) -> float:
    if cause.kind in (Kind.ACCELERATION, Kind.CORNERS):
        return 2.0 * s.again.run.scene.robot.arm.tick
    return WIDE


def _price(s: _Search, group: Group) -> float:
    return len(group) * (float(np.log(len(s.rows.times))) + WORTH)


def _worth(s: _Search, before: Fit, after: Fit, group: Group) -> float:
    """Return what a group gains beyond its price; rows whose errors are alike count as fewer."""
    left = left_over(after.residual, s.least)
    n = len(s.rows.times)
    sizes = [(fit.residual**2).mean(axis=0) + s.least**2 for fit in (before, after)]
    gains = n / left.times_correlated * np.log(sizes[0] / sizes[1])
    return float(gains.sum()) - _price(s, group)


def _matters(s: _Search, fit: Fit, group: Group) -> bool:
    """Whether a group changes the log by more than a part of what is left over."""
    if group[0].by_ticks:
        return True
    J = columns(s.again, s.rows, fit.clock, fit.values, group)
    moved_by = J @ np.array([fit.values[cause] for cause in group])
    rms = left_over(fit.residual, s.least).rms
    return bool((np.sqrt((moved_by**2).mean(axis=0)) > MATTERS * rms).any())


def _spans(s: _Search, fit: Fit, chosen: Sequence[Chosen]) -> tuple[dict[Cause, Between], Fit]:
    """Return what the log allows of numbers that work through ticks, and the fit with them."""
    found: dict[Cause, Between] = {}
    for cause in _fitted(chosen):
        if not cause.by_ticks:
            continue

        def weighs(value: float, cause: Cause = cause, fit: Fit = fit) -> float:
            return _weighed(s, s.rows, fit, {**fit.values, cause: value}, (), 2).objective

        base = weighs(fit.values[cause])
        best = fit.values[cause]
        found[cause] = between(best, base, _reach(s, cause), weighs)
        if cause.kind in (Kind.ACCELERATION, Kind.CORNERS):  # the controller counts even ticks
            found[cause] = found[cause]._replace(value=best)
        fit = fit._replace(values={**fit.values, cause: found[cause].value})
    return found, fit
