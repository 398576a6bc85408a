"""From verdicts to a mark, with every lost point explained."""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from vrts.base.diagnostic import Diagnostic
from vrts.check.goals.reached import reached
from vrts.check.judgement import Judgement
from vrts.check.mark.earned import earned
from vrts.check.mark.grade import REVIEW, Grade, Loss, Status
from vrts.check.mark.losses import (
    broken_demands,
    broken_limits,
    causes_of,
    losses_of,
    mishaps_of,
    touched_by,
    touched_in,
)
from vrts.check.mark.ready import Asked, obstacles
from vrts.check.mark.reasons import PROGRAM_ENDS
from vrts.check.mark.shown import shown_parts
from vrts.check.rounding import exact_s
from vrts.check.task.demands import DEMAND
from vrts.check.task.score import Achieved, rounded_mark, score
from vrts.check.task.task import Task
from vrts.check.verdict import Answer
from vrts.check.verdicts.duration import duration
from vrts.check.verdicts.vias import passed
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run

NOTHING = Fraction(0)


def grade(task: Task, run: Run, judgement: Judgement, said: Sequence[Diagnostic] = ()) -> Grade:
    """Return the mark of a run.

    Args:
        task: What was asked for.
        run: What the program does.
        judgement: Of this run under this task.
        said: What reading and compiling the program said: it decides nothing but "ready".
    """
    results = reached(run, task)
    points = passed(run, task)
    mishaps = mishaps_of(run, judgement)
    took = duration(run)
    limits = broken_limits(task, run, judgement)
    demands = broken_demands(task, judgement)
    achieved = Achieved(
        goals=tuple((result.goal.weight, result.share) for result in results),
        vias=len(task.vias),
        vias_met=points.number,
        touched=touched_by(mishaps),
        completed=run.ending in PROGRAM_ENDS,
        duration_s=took,
        broken=sum((loss.points for loss in demands), NOTHING),
        kept=not demands,
        within_limits=limits is None,
    )
    parts = score(achieved, task.mark, exact_s(task.t_par), exact_s(task.t_max))
    mark = rounded_mark(parts, task.mark.total)
    causes = causes_of(task, run, results, points, limits, mishaps, demands, parts)
    shown = shown_parts(task, parts, mark, causes.costs)
    losses = losses_of(task, run, causes, achieved, shown)
    lowest = _lowest(task, achieved, judgement, sum(points.certain))
    found = obstacles(run, judgement, Asked(results, points), said)
    against = tuple(one.sentence for one in found)
    if not mark and not against:
        against = ("not one point was earned",)
    if lowest is not None and lowest < mark:
        against += (f"{REVIEW}: the mark is between {float(lowest)} and {float(mark)}",)
    return Grade(
        mark,
        _status(run),
        parts.targets,
        parts.vias,
        parts.contacts,
        parts.time,
        losses,
        not against,
        against,
        None if took is None else float(took),
        parts.demands,
        lowest,
        earned(task, results, points, judgement.verdicts, losses, shown),
        parts.limits,
        task.mark.total,
        shown,
    )


def ungraded(task: Task, status: Status, diagnostics: Sequence[Diagnostic]) -> Grade:
    """Return the mark 0 of a submission that could not be run, with its first error as the loss."""
    errors = [d for d in diagnostics if d.is_error] or list(diagnostics)
    sentence, hint, span = status.value, "", None
    if errors:
        first = errors[0]
        span = first.primary.span if first.primary else None
        sentence = f"line {span.line}, {first.headline}" if span else first.headline
        hint = first.help[0] if first.help else ""
    loss = Loss(task.mark.total, "program", sentence, hint, span, None)
    return Grade(
        NOTHING,
        status,
        NOTHING,
        NOTHING,
        NOTHING,
        NOTHING,
        (loss,),
        ready=False,
        obstacles=(sentence,),
        duration_s=None,
        total=task.mark.total,
    )


def _lowest(task: Task, achieved: Achieved, judgement: Judgement, vias: int) -> Fraction | None:
    """Return the mark if everything that cannot be told went wrong; None when all can be told.

    `vias` points are passed for certain.
    """
    asked = [v for v in judgement.verdicts if v.check.startswith(DEMAND)]
    doubtful = [
        cost.points
        for cost, verdict in zip(task.costs, asked, strict=True)
        if verdict.answer is Answer.UNDETERMINED
    ]
    found = judgement.collisions
    contacts = () if found is None else (*found.contacts, *found.undetermined)
    open_ones = 0 if found is None else len(found.undetermined)
    if not doubtful and not open_ones and vias == achieved.vias_met:
        return None
    worst = replace(
        achieved,
        vias_met=vias,
        touched=touched_in(contacts, achieved.touched.drops),
        broken=achieved.broken + sum(doubtful, NOTHING),
        kept=achieved.kept and not doubtful,
    )
    parts = score(worst, task.mark, exact_s(task.t_par), exact_s(task.t_max))
    return rounded_mark(parts, task.mark.total)


def _status(run: Run) -> Status:
    match run.ending:
        case Ending.ERROR:
            return Status.STOPPED
        case Ending.LIMIT:
            return Status.LIMIT
        case _:
            return Status.GRADED
