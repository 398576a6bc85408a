"""Whether a result agrees with itself: its parts give its mark, and points add up.

The machine that marks a shard can sign anything. This finds a mark that was only written in; it
does not find a run that was made up as a whole.
"""

from collections.abc import Iterator
from fractions import Fraction
from math import fsum

import msgspec

from vrts.check.rules.scheme import LARGEST_TOTAL
from vrts.check.task.score import to_tenth
from vrts.marking.result import Check, Kind, Loss, Result

ROUNDED = 1e-5  # points: ten times what the six decimals of a part can be wrong by
LONGEST = 20  # characters of points as a fraction: they are hundredths
EXACT = 1  # `versions.scoring` of before, when points of a loss were not rounded to hundredths
MARKED = frozenset((Kind.GRADED, Kind.DOES_NOT_COMPILE, Kind.STOPPED, Kind.LIMIT))
UNMARKED = frozenset((Kind.RESOURCE, Kind.FAULT))
BY_PROGRAM = MARKED | UNMARKED | {Kind.UNREADABLE}  # what marking a program can end with


def contradiction(result: Result) -> str | None:
    """Return the first thing in a result that cannot be, in words; None: it agrees with itself."""
    return next(_contradictions(result), None)


def _contradictions(result: Result) -> Iterator[str]:
    kind, mark = result.kind, result.mark
    if not _has_points(result):
        yield "it holds points that no marking gives"
        return
    if kind not in BY_PROGRAM:
        yield f"it says `{kind.value}`, and a program was sent"
    elif kind in UNMARKED and mark is not None:
        yield f"it says `{kind.value}`, and has a mark"
    elif kind in MARKED and (mark is None or result.parts is None):
        yield f"it says `{kind.value}`, and has no {'mark' if mark is None else 'parts'}"
    if mark is None:
        return
    possible = _marks_of_parts(result)
    if mark not in possible:
        yield f"its mark is {mark:g}, and its parts give {possible[-1]:g}"
    if result.parts is None:
        return
    missing = result.exact_total - (result.exact_mark or 0)
    lost = sum((Fraction(loss.points_exact) for loss in result.losses), Fraction(0))
    if lost != missing:
        yield f"its mark is {mark:g} of {result.total:g}, and its causes cost {float(lost):g}"
    earned = fsum(check.points for check in result.checks)
    if abs(earned - mark) > ROUNDED * max(1, len(result.checks)):
        yield f"its mark is {mark:g}, and its checks earned {earned:g}"
    if result.lowest is not None and result.lowest > mark:
        yield f"its mark is {mark:g}, and cannot be lower than {result.lowest:g}"


def _marks_of_parts(result: Result) -> tuple[float, ...]:
    """Return the marks that parts can give: two only where rounding could go both ways."""
    parts = result.parts
    if parts is None:
        return (0.0,)
    taken = parts.contacts + parts.demands + parts.limits
    exact = max(0.0, parts.targets + parts.vias - taken) + parts.time
    near = (exact - ROUNDED, exact + ROUNDED, exact)
    return tuple(float(to_tenth(Fraction(points), result.exact_total)) for points in near)


def _has_points(result: Result) -> bool:
    """Return whether all numbers of points are such that they can be added up."""
    most = LARGEST_TOTAL * (1 + len(result.checks))  # what several demands cost adds up
    parts = () if result.parts is None else msgspec.structs.astuple(result.parts)
    return (
        all(abs(points) <= most for points in parts)
        and all(_is_loss(loss, result.versions.scoring) for loss in result.losses)
        and all(map(_is_check, result.checks))
    )


def _is_check(check: Check) -> bool:
    return abs(check.points) <= LARGEST_TOTAL and abs(check.most) <= LARGEST_TOTAL


def _is_loss(loss: Loss, scoring: int) -> bool:
    """Return whether points are hundredths, but for those of before, and the same both times."""
    if len(loss.points_exact) > LONGEST:
        return False
    try:
        exact = Fraction(loss.points_exact)
    except (ValueError, ZeroDivisionError):
        return False
    hundredths = scoring == EXACT or (exact * 100).denominator == 1
    return hundredths and abs(exact) <= LARGEST_TOTAL and abs(loss.points - exact) <= ROUNDED
