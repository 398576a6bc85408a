"""The mark as a function of what was achieved, in exact arithmetic.

mark = round(max(0, T + V - C - E) + D), once, half up, to a tenth. Knows nothing of runs, so its
laws can be tested by themselves.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from vrts.check.task.task import MarkScheme

TENTH = Fraction(1, 10)
FULL = Fraction(10)


@dataclass(frozen=True, slots=True)
class Achieved:
    """What a run achieved."""

    goals: tuple[tuple[Fraction, Fraction], ...]  # (weight, share s from 0 to 1) of every goal
    vias: int  # via points there are
    vias_met: int
    contacts: int  # contact events and dropped objects
    completed: bool  # the program came to its own end
    duration_s: Fraction | None  # EXECUTE to program end
    broken: Fraction = Fraction(0)  # points of the demands that are not kept
    kept: bool = True  # all of them are, also those without points


@dataclass(frozen=True, slots=True)
class Parts:
    """The parts of a mark, unrounded."""

    targets: Fraction  # T
    vias: Fraction  # V
    contacts: Fraction  # C
    time: Fraction  # D
    demands: Fraction = Fraction(0)  # E

    @property
    def unrounded(self) -> Fraction:
        """The mark before rounding."""
        return max(Fraction(0), self.targets + self.vias - self.contacts - self.demands) + self.time


def score(achieved: Achieved, scheme: MarkScheme, t_par: Fraction, t_max: Fraction) -> Parts:
    """Return the parts of the mark."""
    full_targets = scheme.targets + (Fraction(0) if achieved.vias else scheme.vias)
    vias = scheme.vias * achieved.vias_met / achieved.vias if achieved.vias else Fraction(0)
    return Parts(
        full_targets * weighted(achieved.goals),
        vias,
        contact_loss(achieved.contacts, scheme),
        scheme.time_bonus * _time_share(achieved, t_par, t_max),
        achieved.broken,
    )


def weighted(goals: Sequence[tuple[Fraction, Fraction]]) -> Fraction:
    """Return the weighted mean of the goals' shares; 1 when there are no goals."""
    total = sum((weight for weight, _ in goals), Fraction(0))
    if not total:
        return Fraction(1)
    return sum((weight * share for weight, share in goals), Fraction(0)) / total


def contact_loss(contacts: int, scheme: MarkScheme) -> Fraction:
    """Return the points lost to a number of contact events and drops."""
    if not contacts:
        return Fraction(0)
    loss = scheme.first_contact + (contacts - 1) * scheme.further_contact
    return min(loss, scheme.contact_cap)


def faultless(achieved: Achieved) -> bool:
    """Return whether every goal and via point is met without any event, to the program's end."""
    return (
        achieved.completed
        and achieved.kept
        and not achieved.contacts
        and achieved.vias_met == achieved.vias
        and all(share == 1 for _, share in achieved.goals)
    )


def share_of(error: Fraction, tolerance: Fraction, zero_at: Fraction) -> Fraction:
    """Return the share of a goal: 1 within tolerance, falling to 0 at `zero_at` tolerances."""
    share = (zero_at * tolerance - error) / ((zero_at - 1) * tolerance)
    return min(Fraction(1), max(Fraction(0), share))


def rounded_mark(parts: Parts) -> Fraction:
    """Return the mark: rounded half up to a tenth, from 0 to 10."""
    return to_tenth(parts.unrounded)


def to_tenth(points: Fraction) -> Fraction:
    """Return points as a mark: rounded half up to a tenth, from 0 to 10."""
    tenths = (points / TENTH + Fraction(1, 2)).__floor__()
    return min(FULL, max(Fraction(0), tenths * TENTH))


def _time_share(achieved: Achieved, t_par: Fraction, t_max: Fraction) -> Fraction:
    if not faultless(achieved) or achieved.duration_s is None:
        return Fraction(0)
    share = (t_max - achieved.duration_s) / (t_max - t_par)
    return min(Fraction(1), max(Fraction(0), share))
