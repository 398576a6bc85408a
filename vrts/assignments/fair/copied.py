"""Whether it pays to copy: the solution of one student marked by the variant of another."""

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

from vrts.assignments.fair.trial import earned
from vrts.assignments.variants.of_task import VariedTask
from vrts.base.workers import Workers
from vrts.check.variants.model import Combination

MOST_PAIRS = 200  # of students, of which one copies from the other
FROM_ONE = 5  # solutions that are tried in one variant, at least
HALF = Fraction(1, 2)
ENOUGH = Fraction(19, 20)  # share of pairs in which a copy earns at most half
DOUBT = 0.05  # how often a sample may deceive


class Copied(NamedTuple):
    """What copies earn."""

    pairs: int  # that were tried
    paid: int  # pairs in which the copy earns more than half
    of: int  # pairs that there are

    @property
    def pays(self) -> bool:
        """Whether copies earn more than half too often in the pairs that were tried."""
        return self.pairs - self.paid < ENOUGH * self.pairs

    @property
    def shown(self) -> bool:
        """Whether that they do not is shown for all pairs.

        For a part of them: with more that pay than `ENOUGH` allows, so few would be found in less
        than 5 % of samples [Clopper1934]_.
        """
        if self.pairs >= self.of:
            return not self.pays
        share = float(1 - ENOUGH)
        few = (
            math.comb(self.pairs, k) * share**k * (1 - share) ** (self.pairs - k)
            for k in range(self.paid + 1)
        )
        return math.fsum(few) <= DOUBT


def copied(
    varied: VariedTask,
    students: Sequence[Combination],
    programs: Mapping[Combination, bytes],
    workers: Workers,
    most: int = MOST_PAIRS,
) -> Copied:
    """Return what the reference of one student earns for another one, for a sample of pairs.

    Args:
        varied: The task.
        students: The variant of each; two may have the same.
        programs: The reference with the places of each variant.
        workers: Who tries them.
        most: About how many pairs are tried, evenly from all.
    """
    pairs = sample(len(students), most)
    asked: dict[Combination, dict[Combination, int]] = {}  # by whose variant: whose programs
    same = 0
    for whose, copier in pairs:
        source, target = students[whose], students[copier]
        if source == target:
            same += 1
            continue
        sources = asked.setdefault(target, {})
        sources[source] = sources.get(source, 0) + 1
    things = list(asked.items())

    def ask(thing: tuple[Combination, dict[Combination, int]]) -> tuple[Fraction, ...]:
        target, sources = thing
        return earned(varied, target, tuple(programs[one] for one in sources))

    paid = same
    for (_, sources), shares in zip(things, workers.answers(ask, things), strict=True):
        counts = zip(sources.values(), shares, strict=True)
        paid += sum(count for count, share in counts if share > HALF)
    return Copied(len(pairs), paid, len(students) * (len(students) - 1))


def sample(students: int, most: int) -> tuple[tuple[int, int], ...]:
    """Return pairs of different students, as (whose solution, who copies it).

    All pairs where there are few; else some students, evenly chosen, with others at distances
    that are evenly chosen too.
    """
    if students * (students - 1) <= most:
        return tuple((a, b) for b in range(students) for a in range(students) if a != b)
    from_one = min(max(FROM_ONE, most // students), students - 1)
    copiers = min(students, most // from_one)
    found: list[tuple[int, int]] = []
    for k in range(copiers):
        copier = k * students // copiers
        for j in range(from_one):
            away = 1 + (j * (students - 1) // from_one + k) % (students - 1)
            found.append(((copier + away) % students, copier))
    return tuple(found)
