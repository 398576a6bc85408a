"""How far a number may go with the full mark kept: tried at values, for good ones may have gaps."""

from collections.abc import Callable
from typing import NamedTuple

from vrts.base.remembered import Memory
from vrts.base.source import SourceFile
from vrts.repair.edit import Change, Does, changed
from vrts.repair.trying.trial import Place, Stage, tried

DOUBLINGS = 4
HALVINGS = 5
FINE = 0.02  # of the number: nearer its ends are not looked for


class Reach(NamedTuple):
    """Values that earn the full mark, and all that were tried between them."""

    low: float
    high: float
    tried: int  # values


def reach(
    place: Place,
    source: SourceFile,
    change: Change,
    legal: Callable[[Change], bool] = lambda _: True,
) -> Reach | None:
    """Return how far the number that a change writes may go; None where it writes no one number.

    Args:
        place: Where the program runs.
        source: The program.
        change: A change that earns the full mark.
        legal: Whether a teacher would take a value.
    """
    if change.does is not Does.NUMBER or len(change.edits) != 1:
        return None
    old, good = float(change.old), float(change.new)
    memory = Memory()
    known: dict[float, bool] = {old: False, good: True}

    def does(value: float) -> bool:
        if value not in known:
            text = f"{value:g}"
            edit = change.edits[0]._replace(replacement=text)
            other = change._replace(edits=(edit,), new=text)
            stage = tried(place, changed(source.text, other.edits), memory).stage
            known[value] = legal(other) and stage is Stage.FULL
        return known[value]

    ends = [_end(good, sign, old, does) for sign in (-1.0, 1.0)]
    return Reach(ends[0], ends[1], len(known) - 1)


def _end(good: float, sign: float, old: float, does: Callable[[float], bool]) -> float:
    """Return the last good value found on one side."""
    fine = max(FINE * abs(good), 1.0)
    bad = old if sign * (old - good) > 0 else None
    step = max(abs(good) / 4, 4.0)
    for _ in range(DOUBLINGS):
        if bad is not None:
            break
        value = round(good + sign * step)
        if does(value):
            good, step = value, 2 * step
        else:
            bad = value
    for _ in range(HALVINGS):
        if bad is None or abs(bad - good) <= fine:
            break
        middle = round((good + bad) / 2)
        if middle in (good, bad):
            break
        if does(middle):
            good = middle
        else:
            bad = middle
    return good
