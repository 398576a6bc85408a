"""How far a number may go with the full mark kept: good values may have gaps.

The ends are looked for by doubling and halving: in between, a range is tried at values only. Then
every whole number is executed and certified, from the good one on to both sides, as far as a count
goes; a gap ends the range. Nothing is certified of numbers between whole ones.
"""

from collections.abc import Callable
from typing import NamedTuple

from vrts.base.remembered import Memory
from vrts.base.source import SourceFile
from vrts.repair.edit import Change, Does, changed
from vrts.repair.trying.trial import Place, Stage, shared, tried, verified_text

DOUBLINGS = 4
HALVINGS = 5
FINE = 0.02  # of the number: nearer its ends are not looked for
MOST_WHOLE = 120  # whole numbers executed one by one: about 30 ms of processor time each


class Reach(NamedTuple):
    """Values that earn the full mark."""

    low: float
    high: float
    tried: int  # values, those apart of which every one was executed
    whole: tuple[float, float] | None = None  # every whole number from the one to the other

    @property
    def is_certified(self) -> bool:
        """Whether every whole number of it earns the full mark for certain."""
        return self.whole == (self.low, self.high)


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
    base = shared(place, changed(source.text, change.edits), memory)
    known: dict[float, bool] = {old: False, good: True}

    def text(value: float) -> str:
        edit = change.edits[0]._replace(replacement=f"{value:g}")
        return changed(source.text, (edit,))

    def does(value: float) -> bool:
        if value not in known:
            said = f"{value:g}"
            edit = change.edits[0]._replace(replacement=said)
            is_legal = legal(change._replace(edits=(edit,), new=said))
            known[value] = is_legal and tried(place, text(value), memory, base=base).stage is (
                Stage.FULL
            )
        return known[value]

    def is_sure(value: float) -> bool:
        return verified_text(place, text(value)).stage is Stage.FULL

    low, high = _end(good, -1.0, old, does), _end(good, 1.0, old, does)
    if good != round(good):
        return Reach(low, high, len(known) - 1)
    first, gap_below = _whole(good, -1.0, low, MOST_WHOLE // 2, does)
    left = MOST_WHOLE - round(good - first)
    last, gap_above = _whole(good, 1.0, high, left, does)
    whole = (first, last) if first < last and is_sure(first) and is_sure(last) else None
    low, high = first if gap_below else low, last if gap_above else high
    others = [x for x in known if x != old and (whole is None or not first <= x <= last)]
    return Reach(low, high, len(others), whole)


def _whole(
    good: float, sign: float, end: float, most: int, does: Callable[[float], bool]
) -> tuple[float, bool]:
    """Return the last whole number before which all are good, and whether a gap is behind it.

    Args:
        good: A whole number that is good.
        sign: In which direction: 1 or -1.
        end: No farther than this.
        most: How many are looked at.
        does: Whether a value is good.
    """
    for _ in range(most):
        if good == end:
            break
        if not does(good + sign):
            return good, True
        good += sign
    return good, False


def _end(good: float, sign: float, old: float, does: Callable[[float], bool]) -> float:
    """Return the last good value found on one side."""
    fine = max(FINE * abs(good), 1.0)
    bad = old if sign * (old - good) > 0 else None
    step = max(abs(good) / 4, 4.0)
    for _ in range(DOUBLINGS):
        if bad is not None:
            break
        value = float(round(good + sign * step))
        if does(value):
            good, step = value, 2 * step
        else:
            bad = value
    for _ in range(HALVINGS):
        if bad is None or abs(bad - good) <= fine:
            break
        middle = float(round((good + bad) / 2))
        if middle in (good, bad):
            break
        if does(middle):
            good = middle
        else:
            bad = middle
    return good
