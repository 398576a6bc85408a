"""Reads `[late]` and `[submissions]` of a task: deadlines, what lateness costs, what counts."""

from datetime import timedelta
from fractions import Fraction

from vrts.base.diagnostic import Rule
from vrts.base.toml.reading import Problems, Table
from vrts.check.rules.scheme import TOTAL
from vrts.check.task.late_rules import Keep, LateRules, LateStep

LATE = Rule("V710", "late-rules")

LONGEST = 24 * 366  # [h] of a step, or of grace


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
