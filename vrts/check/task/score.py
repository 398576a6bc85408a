"""The mark as a function of what was achieved, in exact arithmetic.

mark = round(max(0, T + V - C - L - E) + D), once, half up, to a tenth. Knows nothing of runs, so
its laws can be tested by themselves.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from vrts.check.rules.scheme import Contacts, MarkScheme

TENTH = Fraction(1, 10)
NOTHING = Fraction(0)


@dataclass(frozen=True, slots=True)
class Touched:
    """Contact events and dropped objects, as far as they may cost."""

    contacts: int = 0  # events
    drops: int = 0  # objects
    seconds: Fraction = Fraction(0)  # of all contacts; of two at a time both count
    depth_mm: Fraction = Fraction(0)  # the deepest contact of every two bodies, added up

    @property
    def number(self) -> int:
        """How many there are of both."""
        return self.contacts + self.drops


UNTOUCHED = Touched()


@dataclass(frozen=True, slots=True)
class Achieved:
    """What a run achieved."""

    goals: tuple[tuple[Fraction, Fraction], ...]  # (weight, share s from 0 to 1) of every goal
    vias: int  # via points there are
    vias_met: int
    touched: Touched
    completed: bool  # the program came to its own end
    duration_s: Fraction | None  # EXECUTE to program end
    broken: Fraction = Fraction(0)  # points of the demands that are not kept
    kept: bool = True  # all of them are, also those without points
    within_limits: bool = True  # of the robot, and none was moved


@dataclass(frozen=True, slots=True)
class Parts:
    """The parts of a mark, unrounded."""

    targets: Fraction  # T
    vias: Fraction  # V
    contacts: Fraction  # C
    time: Fraction  # D
    demands: Fraction = Fraction(0)  # E
    limits: Fraction = Fraction(0)  # L

    @property
    def costs(self) -> Fraction:
        """All that is taken off."""
        return self.contacts + self.limits + self.demands

    @property
    def unrounded(self) -> Fraction:
        """The mark before rounding."""
        return max(NOTHING, self.targets + self.vias - self.costs) + self.time


def score(achieved: Achieved, scheme: MarkScheme, t_par: Fraction, t_max: Fraction) -> Parts:
    """Return the parts of the mark."""
    targets, vias = divided(scheme, targets=bool(achieved.goals), vias=bool(achieved.vias))
    there = weighted(achieved.goals) if achieved.goals else Fraction(achieved.completed)
    return Parts(
        targets * there,
        vias * achieved.vias_met / max(1, achieved.vias),
        contact_loss(achieved.touched, scheme),
        scheme.time_bonus * _time_share(achieved, t_par, t_max),
        achieved.broken,
        NOTHING if achieved.within_limits else scheme.broken_limit,
    )


def divided(scheme: MarkScheme, *, targets: bool, vias: bool) -> tuple[Fraction, Fraction]:
    """Return the points for targets and for via points, where a task may have none of either.

    What there is none of leaves its points to the other. Where there is neither, the points are
    for a program that comes to its end: then a task is about demands, which only cost.
    """
    every = scheme.targets + scheme.vias
    if targets and vias:
        return scheme.targets, scheme.vias
    return (Fraction(0), every) if vias else (every, Fraction(0))


def weighted(goals: Sequence[tuple[Fraction, Fraction]]) -> Fraction:
    """Return the weighted mean of the goals' shares; 1 when there are no goals."""
    total = sum((weight for weight, _ in goals), NOTHING)
    if not total:
        return Fraction(1)
    return sum((weight * share for weight, share in goals), NOTHING) / total


def contact_loss(touched: Touched, scheme: MarkScheme) -> Fraction:
    """Return the points lost to contact events and drops.

    By events every one costs. By time and by depth the first still costs, and so does every
    further drop, but contacts cost by their seconds or millimetres instead of their number: so
    a contact that lasts longer, or goes deeper, never costs less, also where two become one.
    """
    if not touched.number:
        return NOTHING
    match scheme.contacts_by:
        case Contacts.EVENTS:
            more = (touched.number - 1) * scheme.further_contact
        case Contacts.TIME:
            more = _drops(touched, scheme) + touched.seconds * scheme.per_second
        case Contacts.DEPTH:
            more = _drops(touched, scheme) + touched.depth_mm * scheme.per_mm
    return min(scheme.first_contact + more, scheme.contact_cap)


def _drops(touched: Touched, scheme: MarkScheme) -> Fraction:
    further = touched.drops if touched.contacts else touched.drops - 1
    return further * scheme.further_contact


def faultless(achieved: Achieved) -> bool:
    """Return whether every goal and via point is met without any event, to the program's end."""
    return (
        achieved.completed
        and achieved.kept
        and achieved.within_limits
        and not achieved.touched.number
        and achieved.vias_met == achieved.vias
        and all(share == 1 for _, share in achieved.goals)
    )


def share_of(error: Fraction, tolerance: Fraction, zero_at: Fraction) -> Fraction:
    """Return the share of a goal: 1 within tolerance, falling to 0 at `zero_at` tolerances."""
    share = (zero_at * tolerance - error) / ((zero_at - 1) * tolerance)
    return min(Fraction(1), max(NOTHING, share))


def rounded_mark(parts: Parts, total: Fraction) -> Fraction:
    """Return the mark: rounded half up to a tenth, from 0 to the total."""
    return to_tenth(parts.unrounded, total)


def to_tenth(points: Fraction, total: Fraction) -> Fraction:
    """Return points as a mark: rounded half up to a tenth, from 0 to the total."""
    return min(total, max(NOTHING, in_tenths(points)))


def in_tenths(points: Fraction) -> Fraction:
    """Return points rounded half up to a tenth."""
    return (points / TENTH + Fraction(1, 2)).__floor__() * TENTH


def _time_share(achieved: Achieved, t_par: Fraction, t_max: Fraction) -> Fraction:
    if not faultless(achieved) or achieved.duration_s is None:
        return NOTHING
    share = (t_max - achieved.duration_s) / (t_max - t_par)
    return min(Fraction(1), max(NOTHING, share))
