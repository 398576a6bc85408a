"""What a teacher would call right, among changes that all earn the full mark."""

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from vrts.repair.edit import FARTHEST, Change, Does

SOON = 4  # lines between two places of which either would do for a step that is missing
CLEARLY = 0.3  # by so much the best must be better than those of other lines to stand out
ALIKE = 0.3  # so much a smaller change of the same lines may be worse and still be told first
DOUBTFUL = 1.0  # against which a teacher says so much does not stand out, whatever else there is
ILLEGAL = 1.5  # what a value speaks against a change that no controller or teacher would take
HARMLESS = 1.0  # what it speaks against it that a step goes that moves nothing
ABOVE_ZERO = frozenset({"DEPART", "DEPARTS", "APPRO", "APPROS", "DELAY", "SPEED"})
PACE = frozenset({"SPEED", "DELAY", "DURATION", "FOR", "WHILE", "IF"})
FULL = 100.0  # per cent: no teacher asks for a speed above it
UNITS = ("MMPS", "IPS")  # of speeds that are no per cent
GOES_TO = frozenset({"MOVE", "MOVES", "APPRO", "APPROS"})
TALKS = frozenset({"TYPE", "PROMPT"})


class Repair(NamedTuple):
    """A change that earns the full mark: executed and certified."""

    change: Change
    cost: float
    text: str  # the program with the change
    mark: Fraction
    weight: float = 1.0  # how much its line is to blame
    doubt: float = 0.0  # what a teacher says against it, beside what is implausible

    @property
    def against(self) -> float:
        """All that speaks against it."""
        return self.cost + self.doubt + sum(implausible(part) for part in self.change.each)


def ranked(found: Sequence[Repair]) -> tuple[Repair, ...]:
    """Return repairs, the likeliest first; of those of its lines a smaller one as good as it.

    Where a motion is added, another number is as good: nobody goes round what a height clears.
    """
    by = sorted(found, key=lambda each: round(each.against, 6))
    if not by:
        return ()
    lines = [part.line for part in by[0].change.each]
    goes_round = any(_goes(part) for part in by[0].change.each)
    alike = [
        each
        for each in by
        if each.against < by[0].against + ALIKE
        and (
            [part.line for part in each.change.each] == lines
            or (goes_round and each.change.does is Does.NUMBER)
        )
    ]
    first = min(alike, key=lambda each: each.change.size)
    return (first, *(each for each in by if each is not first))


def standing_out(found: Sequence[Repair]) -> Repair | None:
    """Return the first of ranked repairs, if it stands out among those of other lines."""
    if not found:
        return None
    best = found[0]
    if any(implausible(part) >= ILLEGAL or _detour(part) for part in best.change.each):
        return None
    if best.doubt >= DOUBTFUL:
        return None
    for other in found[1:]:
        near = other.against < best.against + CLEARLY
        if near and _elsewhere(other.change, best.change):
            return None
    return best


def _detour(change: Change) -> bool:
    """Return whether a motion to a location is added: many ways round may earn as much.

    A step that the program has elsewhere is no detour: it goes by there as usual.
    """
    if not _goes(change):
        return False
    words = change.new.upper().split()
    lines = change.edits[0].span.source.lines()
    return not any(line.upper().partition(";")[0].split() == words for line in lines)


def _goes(change: Change) -> bool:
    """Return whether a motion is added."""
    words = change.new.upper().split()
    return change.does is Does.ADD and bool(words) and words[0] in GOES_TO


def _elsewhere(change: Change, other: Change) -> bool:
    """Return whether two changes blame different lines.

    The same step added a little sooner or later is the same advice.
    """
    added = change.does is other.does is Does.ADD and change.new == other.new
    if added and abs(change.line - other.line) <= SOON:
        return False
    mine, theirs = ([part.line for part in each.each] for each in (change, other))
    return any(min(abs(line - one) for one in theirs) > 1 for line in mine)


def implausible(change: Change) -> float:
    """Return what speaks against a change by itself, whatever its line is to blame for."""
    words = change.new.upper().replace(",", " ").split()
    if change.does is Does.REMOVE:
        gone = change.old.upper().split()[:1]
        return HARMLESS if gone and gone[0] in TALKS else 0.0
    numbers = [value for value in map(_number, words) if value is not None]
    word = _keyword(change) if change.does is Does.NUMBER else words[0] if words else ""
    if word not in ABOVE_ZERO:
        return 0.0
    most = FULL if word == "SPEED" and not _has_unit(change) else FARTHEST
    return ILLEGAL if any(value <= 0 or value > most for value in numbers) else 0.0


def keeps_time(change: Change) -> bool:
    """Return whether a change is of a speed or a pause, or of a step as a whole."""
    part = change.does in (Does.NUMBER, Does.ROW, Does.WORD)
    return not part or _keyword(change) in PACE


def _keyword(change: Change) -> str:
    """Return the keyword of the step in which a change writes a number, without its label."""
    words = _line(change).upper().replace(",", " ").split()
    return next((word for word in words if not word.isdecimal()), "")


def _has_unit(change: Change) -> bool:
    """Return whether the step that a change writes to says a speed in millimetres or inches."""
    return any(unit in f"{_line(change)} {change.new}".upper() for unit in UNITS)


def _line(change: Change) -> str:
    """Return the line of the file on which a change begins."""
    span = change.edits[0].span
    return span.source.line_text(span.line)


def _number(word: str) -> float | None:
    try:
        return float(word)
    except ValueError:
        return None
