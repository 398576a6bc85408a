"""What each thing that a task asks for earned: the mark, seen from the side of the checks.

The points add up to the mark exactly. What only costs (contacts, demands) earns 0 at most.
"""

from collections.abc import Iterable, Sequence
from fractions import Fraction

from vrts.check.mark.grade import Earned, Loss
from vrts.check.task.demands import DEMAND
from vrts.check.task.score import FULL, Parts
from vrts.check.task.task import Goal, Task
from vrts.check.verdict import Answer, Verdict
from vrts.check.verdicts.targets import Reached, describe
from vrts.check.verdicts.vias import Passed

COLLISION = "collision"  # name of the check
NOTHING = Fraction(0)
NOT_REACHED = "not reached: the program could not be run"


def earned(
    task: Task,
    results: Sequence[Reached],
    passed: Passed,
    verdicts: Sequence[Verdict],
    losses: Iterable[Loss],
    parts: Parts,
    mark: Fraction,
) -> tuple[Earned, ...]:
    """Return what a run earned, in the order of the task."""
    costs: dict[str, Fraction] = {}
    for loss in losses:
        costs[loss.check] = costs.get(loss.check, NOTHING) + loss.points
    found = [
        Earned(
            f"target {result.goal.body}",
            result.goal.title,
            "target",
            Answer.HOLDS if result.share == 1 else Answer.VIOLATED,
            _most(task, result.goal) * result.share,
            _most(task, result.goal),
            "" if result.share == 1 else f"`{result.goal.body}` {describe(result)}",
        )
        for result in results
    ]
    answers = {v.check: v for v in verdicts}
    each = task.mark.vias / max(1, len(task.vias))
    for visits, met in zip(passed.visits, passed.met, strict=True):
        verdict = answers[f"via {visits.via.name}"]
        points = each if met else NOTHING
        message = "" if verdict.answer is Answer.HOLDS else verdict.summary
        found.append(
            Earned(verdict.check, visits.via.name, "via", verdict.answer, points, each, message)
        )
    if COLLISION in answers:
        touched = costs.get(COLLISION, NOTHING)
        found.append(_that_costs(answers[COLLISION], "no contact", "contact", touched))
    asked = [v for v in verdicts if v.check.startswith(DEMAND)]
    for demand, verdict in zip(task.demands, asked, strict=True):
        cost = costs.pop(verdict.check, NOTHING)  # once, also where two have one name
        found.append(_that_costs(verdict, demand.name, "demand", cost))
    bonus = task.mark.time_bonus
    quick = Answer.HOLDS if parts.time == bonus else Answer.VIOLATED
    found.append(Earned("duration", "time", "time", quick, parts.time, bonus, ""))
    rounding = mark - sum((entry.points for entry in found), NOTHING)
    if rounding:
        found.append(Earned("rounding", "rounding", "rounding", None, rounding, NOTHING, ""))
    return tuple(found)


def not_reached(task: Task) -> tuple[Earned, ...]:
    """Return what a program earns that could not be run."""
    each = task.mark.vias / max(1, len(task.vias))
    rows = [
        *((f"target {g.body}", g.title, "target", _most(task, g)) for g in task.goals),
        *((f"via {via.name}", via.name, "via", each) for via in task.vias),
        (COLLISION, "no contact", "contact", NOTHING),
        *((DEMAND + d.name, d.name, "demand", NOTHING) for d in task.demands),
        ("duration", "time", "time", task.mark.time_bonus),
    ]
    return tuple(
        Earned(check, title, kind, None, NOTHING, most, NOT_REACHED)
        for check, title, kind, most in rows
    )


def _most(task: Task, goal: Goal) -> Fraction:
    full = task.mark.targets + (NOTHING if task.vias else task.mark.vias)
    total = sum((goal.weight for goal in task.goals), NOTHING) or FULL
    return full * goal.weight / total


def _that_costs(verdict: Verdict, title: str, kind: str, cost: Fraction) -> Earned:
    message = "" if verdict.answer is Answer.HOLDS else verdict.summary
    return Earned(verdict.check, title, kind, verdict.answer, -cost, NOTHING, message)
