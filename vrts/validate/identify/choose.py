"""The fewest causes that explain a log: the best one first, as long as each explains enough."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.validate.identify.again import Again
from vrts.validate.identify.causes import Cause, Kind, causes_for
from vrts.validate.identify.clocks import by_stretches, whole
from vrts.validate.identify.forward import Rows
from vrts.validate.identify.noise import left_over, resolution
from vrts.validate.identify.searching import (
    Search,
    Shifts,
    looked_for,
    refined,
    searched,
    spans_of_ticks,
    weighed,
)
from vrts.validate.identify.solve import (
    Fit,
    clock_columns,
    columns,
    least_squares,
    objective,
    solve,
)
from vrts.validate.identify.ticks import Between, deciding
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
BEGUN = 1  # times it is begun anew, with another first cause, where too much was needed
SIMPLE = 3  # numbers: with no more it is not


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


def choose(again: Again, log: RobotLog, rows: Rows) -> Choice:
    """Return the fewest causes; where they explain too little, every stretch has its own clock."""
    least = resolution(rows.measured())
    clock = whole(again.run, log, rows)
    every = max(len(rows.times) // SEARCH_ROWS, 1)
    decide = deciding(again)
    few = _few(rows, every)
    shifts = Shifts(log)
    one_clock = Search(again, shifts, rows, few, least, clock, decide)
    parted = by_stretches(again.run, rows, clock)
    own, alone = None, solve(again, rows, clock, {}, (), least)
    by_parts = one_clock if parted is None else one_clock._replace(clock=parted)
    if parted is not None and not _plain(one_clock, alone):
        own = _begun(by_parts, ())
        nearer = (own.fit.residual**2).mean() < NEARER**2 * (alone.residual**2).mean()
        rests_differ = float(np.ptp(own.fit.clock.shifts)) > OTHER_RESTS_S
        if rests_differ and (explained(own) or bool(nearer)):
            return _chosen(by_parts, own)
    found = _chosen(one_clock, _begun(one_clock, ()))
    if own is None or explained(found):
        return found
    own = _chosen(by_parts, own)
    dearer = (len(own.fit.clock.shifts) - 1) * _each(rows)
    return own if explained(own) or _cost(own) + dearer < _cost(found) else found


def explained(found: Choice) -> bool:
    """Whether what is left over has no pattern that is larger than what lies beside it."""
    left = left_over(found.fit.residual, found.least)
    return bool((left.patterned <= PATTERN * left.rms).all())


def _numbers(found: Choice) -> int:
    return sum(len(one.group) for one in found.chosen)


def _each(rows: Rows) -> float:
    """Return what a number has to gain."""
    return float(np.log(len(rows.times))) + WORTH


def _cost(found: Choice) -> float:
    return found.fit.objective + _numbers(found) * _each(found.rows)


def _few(rows: Rows, every: int) -> Rows:
    """Return some rows, and of them the joints alone where there are any: they tell times."""
    if rows.joints is not None:
        return Rows(rows.times[::every], rows.joints[::every], None, rows.middle_s)
    assert rows.positions is not None
    return Rows(rows.times[::every], None, rows.positions[::every], rows.middle_s)


def _chosen(s: Search, begun: Choice) -> Choice:
    """Return a choice, or where it needs many numbers the best of some that begin elsewhere.

    Two causes may look like a third one together. Whoever takes that first needs many more.
    """
    found = [begun]
    while len(found) <= BEGUN and found[-1].chosen and not _simple(found[-1]):
        found.append(_begun(s, [one.chosen[0].group for one in found]))
    return min(found, key=lambda one: (not explained(one), _cost(one)))


def _simple(found: Choice) -> bool:
    return explained(found) and _numbers(found) <= SIMPLE


def _begun(s: Search, elsewhere: Sequence[Group]) -> Choice:
    """Return what is chosen, step by step; groups that are not to be first are left out there."""
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
        if not chosen:
            open_ = [group for group in open_ if group not in elsewhere]
        smooth = [group for group in open_ if not group[0].by_ticks]
        promising = sorted(_promise(s, fit, chosen, smooth), key=lambda one: -one[1])
        gains = _gains(s, fit, chosen, promising[:TRIED])
        best_left = max(gains, key=lambda one: one[2])[1] if gains else fit
        if not _plain(s, fit) and not _plain(s, best_left):
            # what is left lasts for several rows: other times may explain it
            ticks = [group for group in open_ if group[0].by_ticks]
            worth = [(one, searched(s, fit, one[0]) - _price(s, one)) for one in ticks]
            later = sorted(worth, key=lambda one: -one[1])
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
    spans, fit = spans_of_ticks(s, fit, _fitted(chosen))
    return Choice(rows, fit, first, tuple(chosen), spans, s.least)


def _pruned(s: Search, fit: Fit, chosen: list[Chosen]) -> tuple[list[Chosen], Fit]:
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
    s: Search, fit: Fit, chosen: Sequence[Chosen], promising: Sequence[tuple[Group, float]]
) -> list[tuple[Group, Fit, float]]:
    found: list[tuple[Group, Fit, float]] = []
    for group, _ in promising:
        other = _with(s, fit, chosen, group)
        found.append((group, other, _worth(s, fit, other, group)))
    return found


def _plain(s: Search, fit: Fit) -> bool:
    """Whether what is left of the channels that tell times has no pattern worth a word."""
    tell = s.few.channels
    left = left_over(fit.residual[:, :tell], s.least[:tell])
    return bool((left.patterned <= PATTERN * left.rms).all())


def _promise(
    s: Search, fit: Fit, chosen: Sequence[Chosen], groups: Sequence[Group]
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


def _with(s: Search, fit: Fit, chosen: Sequence[Chosen], group: Group) -> Fit:
    """Return the fit of a group beside what was chosen; numbers by ticks are looked for again."""
    causes = _fitted(chosen, group)
    if not group[0].by_ticks:
        starts = {**fit.values}
        for cause in group:
            if cause.kind is Kind.LAG:
                starts[cause] = 5.0 * cause.step
        found = solve(s.again, s.rows, fit.clock, starts, causes, s.least)
    else:
        value, _ = looked_for(s, fit, group[0])
        found = weighed(s, s.rows, fit, {**fit.values, group[0]: value}, causes, 8)
    for cause in causes:
        if cause.by_ticks and len([c for c in causes if not c.by_ticks or c != cause]):
            found = refined(s, found, cause, causes)
    return found


def _price(s: Search, group: Group) -> float:
    return len(group) * _each(s.rows)


def _worth(s: Search, before: Fit, after: Fit, group: Group) -> float:
    """Return what a group gains beyond its price; rows whose errors are alike count as fewer."""
    left = left_over(after.residual, s.least)
    n = len(s.rows.times)
    sizes = [(fit.residual**2).mean(axis=0) + s.least**2 for fit in (before, after)]
    gains = n / left.times_correlated * np.log(sizes[0] / sizes[1])
    return float(gains.sum()) - _price(s, group)


def _matters(s: Search, fit: Fit, group: Group) -> bool:
    """Whether a group changes the log by more than a part of what is left over."""
    if group[0].by_ticks:
        return True
    J = columns(s.again, s.rows, fit.clock, fit.values, group)
    moved_by = J @ np.array([fit.values[cause] for cause in group])
    rms = left_over(fit.residual, s.least).rms
    return bool((np.sqrt((moved_by**2).mean(axis=0)) > MATTERS * rms).any())
