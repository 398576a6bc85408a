"""How seldom two innocent programs would be so much alike: from the class itself.

Nearly all pairs of a class are innocent. How their shares are spread tells, for each channel, how
surprising a share is; the surprises of all channels together are measured by the class once more,
beside what is usual for the two programs. The answer is a number of pairs: how many as much alike
are to be expected by chance among all that were compared.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

USUAL_PAIRS = 150.0  # pairs that stand for experience, where a class is small
USUAL_MIDDLE, USUAL_SCALE = 0.25, 0.09  # of shares, from experience
ENOUGH_PAIRS = 1500  # of a class, that tell what chance can do without those of other folders
AS_ALIKE = 0.6  # share of the likeness of a class, that programs of the same task have with it
NEARLY = 0.8  # share of a program from which on another is nearly the same
LONG = 100.0  # nats of what is common, from which on a program is not alike for being short
SURE = 32.0  # nats
LEAST_PAIRS = 500.0  # a small class is taken for a larger one: little is known of it
MOST_SURPRISE = 40.0  # nats of one channel
# of the channels, in their order: comments and layout are alike for many innocent reasons, and are
# what a disguise changes first; manners of motion are what few disguises reach
FACTORS = (1.0, 1.0, 1.0, 0.5, 1.0, 1.0, 2.0, 1.0)
OF_RUNS = (0,)  # channels that are nothing but what a run did
FEWEST_RUNS = 100  # pairs of which both runs are known, before others are measured by them
NEAR_FACTOR = 2.0  # of nearness, which few disguises reach
NEIGHBOURS = slice(3, 8)  # of a program, by likeness: what is usual for it
BEGIN, TAIL, END = 0.80, 0.95, 0.995  # quantiles between which innocent pairs thin out evenly
USUAL_START = 6.0  # nats of surprise, from experience
USUAL_TAIL = 2.4  # nats by which surprises fall to 1/e, from experience
LEAST_TAIL = 1.0


class Chances(NamedTuple):
    """What each pair of a class comes to; shape (class, class + others)."""

    surprise: Floats  # nats, of all channels together, beside what is usual for both
    channels: tuple[Floats, ...]  # nats, of each channel
    expected: Floats  # how many pairs so much alike are to be expected by chance


def chances(
    found: tuple[NDArray[np.float32], ...],
    compared: Bools,
    folders: Sequence[slice] = (),
    sure: Floats | None = None,
    near: Floats | None = None,
    ran: Bools | None = None,
    counted: Floats | None = None,
) -> Chances:
    """Return how surprising the shares of a class are.

    Args:
        found: Shares of each channel, shape (class, class + others).
        compared: Which pairs are compared at all, each once: the same shape.
        folders: Columns of each other folder.
        sure: Nats that are added to pairs that are nearly the same throughout.
        near: How near each pair is in detail; only ranks of it count.
        ran: Of each program, whether it is known what its run did; None: of all.
        counted: How near each pair is in how often it has each word; only ranks of it count.
    """
    pairs = int(compared.sum())
    measure = _measure(found, compared, folders)
    channels = tuple(_surprise(share.astype(np.float64), measure) for share in found)
    nearly = 0.0 if near is None else NEAR_FACTOR * _surprise_of_rank(near, measure)
    together = np.tensordot(np.array(FACTORS[: len(channels)]), np.stack(channels), axes=1) + nearly
    if counted is not None:
        together = together + _surprise_of_rank(counted, measure)
    if ran is not None and not ran.all():
        written = together - nearly - sum(FACTORS[k] * channels[k] for k in OF_RUNS)
        together = _as_if_run(together, written, ran, measure)
    apart = together - _usual_of_both(together, compared)
    if pairs == 0:
        return Chances(apart, channels, np.full(apart.shape, np.inf))
    sample = np.sort(apart[measure])
    if not len(sample):
        return Chances(apart, channels, np.full(apart.shape, np.inf))
    start, scale = _tail(sample)
    apart = apart if sure is None else apart + sure
    beyond = np.exp(-np.maximum(0.0, apart - start) / scale) * (1.0 - TAIL)
    return Chances(apart, channels, max(pairs, LEAST_PAIRS) * beyond)


def sameness(same: Sequence[NDArray[np.float32]], common: Sequence[NDArray[np.float32]]) -> Floats:
    """Return nats for pairs that are nearly the same throughout, and not because they are short.

    However many of a class share one source, two that are the same are told.

    Args:
        same: Of each of several channels, what is common as a share of the larger program.
        common: Of the same, nats of what is common.
    """
    least = np.minimum.reduce(list(same)).astype(np.float64)
    weight = np.add.reduce(list(common)).astype(np.float64)
    whole = np.clip((least - NEARLY) / (1.0 - NEARLY), 0.0, 1.0)
    return SURE * whole * np.minimum(1.0, weight / LONG)


def _as_if_run(together: Floats, written: Floats, ran: Bools, measure: Bools) -> Floats:
    """Return the surprise of all pairs, where runs are unknown by what is written alone.

    Such a pair is as surprising as pairs of the class whose runs are known and of which as few go
    as far in what is written.
    """
    seen = ran[: len(together), None] & ran[None, :]
    known = measure & seen
    if known.sum() < FEWEST_RUNS:
        return together
    by_text, by_all = np.sort(written[known]), np.sort(together[known])
    beyond = np.maximum(0.0, written - by_text[-1])
    return np.where(seen, together, np.interp(written, by_text, by_all) + beyond)


def _measure(
    found: tuple[NDArray[np.float32], ...], compared: Bools, folders: Sequence[slice]
) -> Bools:
    """Return the pairs that tell what chance can do.

    They are those of the class. A small class takes in those with other folders, where these hold
    programs for the same task, as far as likeness tells.
    """
    count = len(compared)
    measure = compared.copy()
    measure[:, count:] = False
    if measure.sum() >= ENOUGH_PAIRS:
        return measure
    inside = measure.copy()
    for columns in folders:
        some = np.zeros_like(compared)
        some[:, columns] = compared[:, columns]
        if not some.any():
            continue
        alike = sum(float(share[some].mean()) for share in found)
        usual = sum(float(share[inside].mean()) for share in found) if inside.any() else 0.0
        if alike >= AS_ALIKE * usual:
            measure |= some
    return measure


def _surprise(share: Floats, measure: Bools) -> Floats:
    """Return by how many nats each share goes beyond what is usual in the class."""
    sample = np.sort(share[measure])
    trust = len(sample) / (len(sample) + USUAL_PAIRS)
    by_experience = np.clip((share - USUAL_MIDDLE) / USUAL_SCALE, 0.0, MOST_SURPRISE)
    if not len(sample) or sample[-1] <= 0.0:
        return by_experience
    above = len(sample) - np.searchsorted(sample, share, side="left")
    by_class = np.log((len(sample) + 1.0) / (above + 1.0))
    return trust * by_class + (1.0 - trust) * by_experience


def _surprise_of_rank(near: Floats, measure: Bools) -> Floats:
    """Return by how many nats pairs are nearer than is usual; a small class tells little."""
    sample = np.sort(near[measure])
    if not len(sample) or sample[-1] <= 0.0:
        return np.zeros_like(near)
    above = len(sample) - np.searchsorted(sample, near, side="left")
    trust = len(sample) / (len(sample) + USUAL_PAIRS)
    return trust * np.log((len(sample) + 1.0) / (above + 1.0))


def _usual_of_both(together: Floats, compared: Bools) -> Floats:
    """Return what is usual for the two of each pair: how far their next neighbours are alike.

    The nearest few are left out: they may be of the same source.
    """
    count = len(together)
    both = np.where(compared, together, 0.0)
    rows = both.copy()
    rows[:, :count] += both[:, :count].T
    of_rows = _level(rows)
    of_others = _level(rows[:, count:].T) if rows.shape[1] > count else np.zeros(0)
    return (of_rows[:, None] + np.concatenate([of_rows, of_others])[None, :]) / 2.0


def _level(rows: Floats) -> Floats:
    width = NEIGHBOURS.stop - NEIGHBOURS.start
    if rows.shape[1] < NEIGHBOURS.stop:
        wide = np.zeros((len(rows), NEIGHBOURS.stop))
        wide[:, : rows.shape[1]] = rows
        rows = wide
    best = -np.sort(-rows, axis=1)[:, NEIGHBOURS]
    return best.sum(axis=1) / width


def _tail(sample: Floats) -> tuple[float, float]:
    """Return where the tail of innocent pairs begins, and how fast it falls.

    Programs of one source are few: quantiles below the highest know nothing of them.
    """
    trust = len(sample) / (len(sample) + USUAL_PAIRS)
    begin, start, end = (float(q) for q in np.quantile(sample, (BEGIN, TAIL, END)))
    falls = [(start - begin) / np.log((1.0 - BEGIN) / (1.0 - TAIL))]
    if len(sample) >= ENOUGH_PAIRS:
        falls.append((end - start) / np.log((1.0 - TAIL) / (1.0 - END)))
    scale = trust * max(falls) + (1.0 - trust) * USUAL_TAIL
    start = trust * start + (1.0 - trust) * USUAL_START
    return start, max(LEAST_TAIL, scale)
