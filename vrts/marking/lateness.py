"""What being late costs: from the platform's times, exactly, and never from dates of files."""

from collections.abc import Sequence
from datetime import datetime, timedelta
from fractions import Fraction
from typing import NamedTuple

from vrts.check.rules.scheme import TOTAL
from vrts.check.task.late_rules import LateRules
from vrts.check.task.score import to_tenth
from vrts.marking.result import Result
from vrts.marking.row import Lateness as InRow

DAY = timedelta(days=1)
ON_TIME = timedelta(0)
NOTHING = Fraction(0)
FLAGGED = "late, says the platform, but not when it came"
UNTIMED = "nothing tells when it came, and being late costs points"
IN_EXAM = "nothing tells when it came, and only what comes while the exam is open counts"


class Lateness(NamedTuple):
    """How late a hand-in is, and what that costs."""

    late_by: timedelta | None  # 0 for on time; None where the platform does not tell
    points: Fraction  # that it costs, before the mark is known
    closed: bool  # too late to count at all
    sentence: str  # "" for on time
    review: bool = False  # somebody has to look when it came
    untimed: bool = False  # not even whether it was late is known


class Marks(NamedTuple):
    """The three columns of a mark: raw - deduction = final, but for rounding."""

    raw: Fraction
    deduction: Fraction  # points taken for lateness, exactly
    final: Fraction  # from 0, rounded half up to a tenth


UNJUDGED = Lateness(None, NOTHING, closed=False, sentence="")


def lateness(
    rules: LateRules | None,
    received: datetime | None,
    *,
    due: datetime | None = None,
    called_late: bool | None = None,
) -> Lateness:
    """Return how late a hand-in is.

    Args:
        rules: Of the task; None: lateness costs nothing.
        received: When it came, told by the platform; None: not known.
        due: An own deadline of the student; closing moves along with it.
        called_late: What platform or teacher say: late, or on time; None: nobody says anything.
    """
    if rules is None:
        return UNJUDGED
    if received is None:
        if called_late:
            return Lateness(None, NOTHING, closed=False, sentence=FLAGGED, review=True)
        if called_late is False:
            return UNJUDGED
        words = IN_EXAM if rules.is_exam else UNTIMED
        return Lateness(None, NOTHING, closed=False, sentence=words, review=True, untimed=True)
    deadline = due or rules.due
    late_by = max(ON_TIME, received - deadline)
    if rules.opens is not None and received < rules.opens:
        early = f"came {_words(rules.opens - received)} before the exam opened: does not count"
        return Lateness(ON_TIME, NOTHING, closed=True, sentence=early)
    if rules.is_exam and late_by:
        words = f"came {_words(late_by)} after the exam closed: does not count"
        return Lateness(late_by, NOTHING, closed=True, sentence=words)
    if rules.closed is not None and received > rules.closed + (deadline - rules.due):
        return Lateness(late_by, NOTHING, closed=True, sentence=f"{_words(late_by)} late: closed")
    if late_by <= rules.grace:
        words = f"{_words(late_by)} late, within the time of grace" if late_by else ""
        return Lateness(late_by, NOTHING, closed=False, sentence=words)
    points = min(rules.most, _cost(rules, late_by))
    sentence = f"{_words(late_by)} late: {_points(points)}"
    return Lateness(late_by, points, closed=False, sentence=sentence)


def in_row(late: Lateness, result: Result) -> InRow | None:
    """Return lateness as a row of the class has it; None where there is nothing to say."""
    if not late.sentence:
        return None
    deduction = marks(result.exact_mark or NOTHING, late, result.exact_total).deduction
    seconds = 0 if late.late_by is None else int(late.late_by.total_seconds())
    return InRow(seconds, str(deduction), late.sentence, late.review, late.untimed)


def marks(raw: Fraction, late: Lateness, total: Fraction = TOTAL) -> Marks:
    """Return raw mark, deduction, and final mark, of so many points."""
    deduction = raw if late.closed else min(raw, late.points)
    return Marks(raw, deduction, to_tenth(raw - deduction, total))


def best(attempts: Sequence[Marks]) -> int:
    """Return the number, from 0, of the attempt that counts where the best does.

    The highest final mark; of equal ones the highest raw mark, then the first.
    """
    return max(range(len(attempts)), key=lambda k: (attempts[k].final, attempts[k].raw, -k))


def _cost(rules: LateRules, late_by: timedelta) -> Fraction:
    if rules.steps:
        reached = [step.points for step in rules.steps if late_by > step.after]
        return reached[-1] if reached else NOTHING
    days_begun = -(-late_by // DAY)
    return rules.per_day * days_begun


def _words(late_by: timedelta) -> str:
    """Return a duration in words: "1 day 3 h", "12 min"."""
    days, rest = late_by.days, late_by - timedelta(days=late_by.days)
    hours, minutes = rest // timedelta(hours=1), rest // timedelta(minutes=1) % 60
    if days:
        one = "1 day" if days == 1 else f"{days} days"
        return f"{one} {hours} h" if hours else one
    if hours:
        return f"{hours} h {minutes} min" if minutes else f"{hours} h"
    return f"{minutes} min" if minutes else f"{rest.seconds} s"


def _points(points: Fraction) -> str:
    shown = f"{float(points):g}"
    return "no points" if not points else f"{shown} point{'' if points == 1 else 's'} less"
