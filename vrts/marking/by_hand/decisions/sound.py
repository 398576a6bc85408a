"""Whether a record makes sense by itself: what its types cannot say."""

from collections.abc import Iterable
from datetime import datetime
from fractions import Fraction

from vrts.marking.by_hand.decisions.records import (
    ChangeMark,
    Decide,
    Decision,
    Extend,
    Finish,
    Item,
    Line,
)
from vrts.marking.unsafe import ALL, SETTLED, Reason

MOST_POINTS = 1000
FINEST = 1000  # points have three decimals


def flaw_of(said: Line) -> str:
    """Return what is wrong with a record; "" for a sound one."""
    if not is_time(said.at):
        return f"`at` is no time with an offset: `{said.at}`"
    for flaw in _flaws(said):
        return flaw
    return ""


def _flaws(said: Line) -> Iterable[str]:
    match said:
        case Item():
            yield from _points(said.points)
        case ChangeMark():
            if (said.delta is None) == (said.mark is None):
                yield "a change has either `delta` or `mark`"
            yield from _points(said.delta)
            yield from _mark(said.mark)
            for reason in said.settles:
                if reason == Reason.LAPSED.value:
                    yield (
                        "`lapsed` cannot be settled by a change: decide again, and undo what was"
                        " decided before"
                    )
                elif reason == Reason.CONFLICT.value:
                    yield "`conflict` cannot be settled by a change: decide which side holds"
                elif reason not in (*SETTLED, ALL):
                    yield f"`{reason[:40]}` is no reason why a mark is unsafe"
        case Extend():
            if not is_time(said.due):
                yield f"`due` is no time with an offset: `{said.due}`"
        case Finish():
            yield from _mark(said.mark)
        case Decide():
            if said.keep in said.over:
                yield f"`{said.keep}` cannot count and not count"
        case _:
            pass


def _mark(text: str | None) -> Iterable[str]:
    yield from _points(text)
    if text is not None and text.startswith("-"):
        yield f"a mark is not below 0: `{text}`"


def _points(text: str | None) -> Iterable[str]:
    if text is None:
        return
    try:
        value = Fraction(text)
    except (ValueError, ZeroDivisionError):
        yield f"`{text}` is no number of points"
        return
    if abs(value) > MOST_POINTS or (value * FINEST).denominator != 1:
        yield f"`{text}`: points are from -{MOST_POINTS} to {MOST_POINTS}, with three decimals"


def beyond(said: Decision, total: Fraction) -> str:
    """Return why a record cannot be meant where marks are out of so many points; "": it can.

    Marks end at the total, so `75` for `7.5` would be full marks without a word.
    """
    match said:
        case Item():
            values = (said.points,)
        case ChangeMark():
            values = (said.delta, said.mark)
        case Finish():
            values = (said.mark,)
        case _:
            return ""
    for text in values:
        value = Fraction(text or "0")
        if abs(value) > total:
            return above(value, total)
    return ""


def above(value: Fraction, total: Fraction) -> str:
    """Return that points are more than there are."""
    return f"{float(value):g} points where marks are out of {float(total):g}"


def is_time(text: str) -> bool:
    """Return whether a text is a time with its offset, as ISO 8601 writes it."""
    try:
        return datetime.fromisoformat(text).utcoffset() is not None
    except ValueError:
        return False
