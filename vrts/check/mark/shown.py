"""The parts of a mark as they are shown: hundredths that add up to it."""

from collections.abc import Sequence
from fractions import Fraction

from vrts.check.mark.apportion import apportioned
from vrts.check.mark.grade import Loss, Most, ShownParts
from vrts.check.task.score import Parts, divided
from vrts.check.task.task import Task

NOTHING = Fraction(0)
CONTACTS = ("contact", "drop")  # kinds of losses
COSTS = (*CONTACTS, "limit", "demand")


def most_of(task: Task) -> Most:
    """Return how many points there are for what."""
    return Most(*apportioned(_exact(task), task.mark.total))


def _exact(task: Task) -> tuple[Fraction, Fraction, Fraction, Fraction]:
    """Return the points for targets, via points, time, and those that are not given."""
    scheme = task.mark
    targets, vias = divided(scheme, targets=bool(task.targets), vias=bool(task.vias))
    return targets, vias, scheme.time_bonus, scheme.total - targets - vias - scheme.time_bonus


def shown_parts(task: Task, parts: Parts, mark: Fraction, costs: Sequence[Loss]) -> ShownParts:
    """Return the parts of a mark.

    What is earned in full is shown in full, and nothing as nothing; the rest is rounded with the
    mark. Where a task divides its points so finely that nothing is left to be rounded, what there
    is for a part is rounded as well.

    Args:
        task: What was asked for.
        parts: Of the mark, exactly.
        mark: It is rounded already.
        costs: What was taken off, less what there was nothing left to take from.
    """
    most = most_of(task)
    exact = _exact(task)
    taken = [
        sum((loss.points for loss in costs if loss.kind in kinds), NOTHING)
        for kinds in (CONTACTS, ("limit",), ("demand",))
    ]
    got = (parts.targets, parts.vias, parts.time)
    whole = [g == e for g, e in zip(got, exact, strict=False)]
    full = (most.targets, most.vias, most.time)
    as_full = [f if w else g for g, f, w in zip(got, full, whole, strict=True)]
    try:
        targets, vias, time, *off = apportioned(
            (*as_full, *(-points for points in taken)),
            mark,
            most=(*full, None, None, None),
            fixed=(*whole, False, False, False),
        )
    except ValueError:
        lacks = [e - g for g, e in zip(got, exact, strict=False)]
        *less, rest, contacts, limits, demands = apportioned(
            (*lacks, exact[3], *taken), task.mark.total - mark
        )
        targets, vias, time = apportioned(got, mark + contacts + limits + demands)
        sums = [g + lack for g, lack in zip((targets, vias, time), less, strict=True)]
        most = Most(sums[0], sums[1], sums[2], rest)
        return ShownParts(targets, vias, contacts, limits, demands, time, most)
    contacts, limits, demands = (-points for points in off)
    return ShownParts(targets, vias, contacts, limits, demands, time, most)


def in_group(losses: Sequence[Loss], total: Fraction) -> list[Loss]:
    """Return losses whose points as they are shown add up to a total."""
    shown = apportioned([loss.points for loss in losses], total)
    return [loss._replace(points=points) for loss, points in zip(losses, shown, strict=True)]
