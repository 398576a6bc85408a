"""Reads `[late]`, `[exam]`, `[submissions]` of a task: deadlines, cost of lateness, what counts."""

from datetime import timedelta
from fractions import Fraction
from typing import NamedTuple

from vrts.base.diagnostic import Rule
from vrts.base.toml.reading import Problems, Table
from vrts.check.rules.scheme import TOTAL
from vrts.check.task.late_rules import Keep, LateRules, LateStep

LATE = Rule("V710", "late-rules")
EXAM = Rule("V873", "exam-rules")

LONGEST = 24 * 366  # [h] of a step, or of grace
MOST_ATTEMPTS = 100
NO_HINTS, HINTS_OF_TASK = "none", "task"  # values of `hints` in `[exam]`


class Exam(NamedTuple):
    """What the section `[exam]` says."""

    rules: LateRules | None  # None: its times are wrong
    keep: Keep  # which of the attempts that count
    hints: bool  # whether students get the hints that `[hints]` allows
    offline: bool  # whether students are to work without a network


def read_exam(top: Table, problems: Problems) -> Exam | None:
    """Return the rules of `[exam]`; None where there is no such section.

    An exam says itself what comes in time and what counts, and allows no hints: other sections
    that say so too are told as wrong.
    """
    section = top.table("exam")
    if section is None:
        return None
    opens = section.time("opens", required=True)
    closes = section.time("closes", required=True)
    attempts = section.integer("attempts", 1, minimum=1, maximum=MOST_ATTEMPTS)
    hints = section.string("hints", NO_HINTS, choices=(NO_HINTS, HINTS_OF_TASK))
    offline = section.boolean("offline", default=True)
    section.finish()
    for other, why in (("late", "when it closes"), ("submissions", "which hand-in counts")):
        if other in top:
            problems.error(
                EXAM,
                f"`[exam]` says itself {why}: a task with it has no `[{other}]`",
                top.span_of(other),
                help=(f"delete `[{other}]`, or `[exam]` if this is no exam",),
            )
    if hints == NO_HINTS and "hints" in top:
        problems.error(
            EXAM,
            "`[hints]` has no effect in an exam without hints",
            top.span_of("hints"),
            help=('delete `[hints]`, or write `hints = "task"` in `[exam]` to allow them',),
        )
    if opens is not None and closes is not None and closes <= opens:
        problems.error(
            EXAM,
            "the exam closes before it opens",
            section.value_span("closes"),
            help=("write in `closes` a time after the one in `opens`",),
        )
    rules = None
    if opens is not None and closes is not None:
        rules = LateRules(closes, closed=closes, opens=opens, attempts=attempts)
    keep = Keep.BEST if attempts > 1 else Keep.LATEST
    return Exam(rules, keep, hints == HINTS_OF_TASK, offline)


def read_late(top: Table, problems: Problems, total: Fraction = TOTAL) -> LateRules | None:
    """Return the rules of `[late]`; None where there is no such section, or it is wrong.

    Args:
        top: The task.
        problems: Told what is wrong.
        total: A mark is out of so many points.
    """
    section = top.table("late")
    if section is None:
        return None
    due = section.time("due", required=True)
    grace = section.fraction("grace_min", Fraction(0), minimum=0, maximum=60 * LONGEST)
    per_day = section.fraction("per_day", Fraction(0), minimum=0, maximum=float(total))
    steps = _steps(section, problems, total)
    most = section.fraction("most", total, minimum=0, maximum=float(total))
    closed = section.time("closed")
    section.finish()
    if per_day and steps:
        problems.error(
            LATE,
            "lateness costs points by the day or in steps, not both",
            section.span_of("per_day"),
            help=("delete `per_day`, or `[[late.step]]`",),
        )
    if not per_day and not steps and "closed" not in section and "per_day" not in section:
        problems.error(
            LATE,
            "`[late]` does not say what lateness costs",
            section.span,
            help=("add `per_day = 1`, `[[late.step]]`, or `closed`, after which nothing counts",),
        )
    if due is None:
        return None
    if closed is not None and closed < due:
        problems.error(LATE, "`closed` comes before `due`", section.value_span("closed"))
    return LateRules(due, timedelta(minutes=float(grace)), per_day, steps, most, closed)


def read_keep(top: Table) -> Keep:
    """Return which of several hand-ins counts, as `[submissions]` has it."""
    section = top.table("submissions")
    if section is None:
        return Keep.LATEST
    choices = tuple(keep.value for keep in Keep)
    word = section.string("keep", Keep.LATEST.value, choices=choices)
    section.finish()
    return Keep(word)


def _steps(section: Table, problems: Problems, total: Fraction) -> tuple[LateStep, ...]:
    found: list[LateStep] = []
    for table in section.tables("step"):
        after = table.fraction("after_h", minimum=0, maximum=LONGEST, required=True)
        points = table.fraction("points", minimum=0, maximum=float(total), required=True)
        table.finish()
        if after is None or points is None:
            continue
        step = LateStep(timedelta(hours=float(after)), points)
        if found and (step.after <= found[-1].after or step.points < found[-1].points):
            problems.error(
                LATE,
                "a step must come later than the one before it, and cost no less",
                table.span,
                help=("put the steps in the order of `after_h`",),
            )
        found.append(step)
    return tuple(found)
