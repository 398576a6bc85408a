"""What each thing that a task asks for earned: the mark, seen from the side of the checks.

The points as they are shown add up to the mark. What only costs (contacts, limits, demands) earns 0
at most.
"""

from collections.abc import Iterable, Sequence
from fractions import Fraction

from vrts.check.goals.reached import Reached
from vrts.check.mark.apportion import apportioned
from vrts.check.mark.grade import Earned, Loss, ShownParts
from vrts.check.mark.shown import most_of
from vrts.check.task.demands import DEMAND
from vrts.check.task.goals import Goal, Relation
from vrts.check.task.score import divided
from vrts.check.task.task import Task
from vrts.check.verdict import Answer, Verdict
from vrts.check.verdicts.limits import LIMITS
from vrts.check.verdicts.targets import describe
from vrts.check.verdicts.vias import Passed

COLLISION = "collision"  # name of the check
PROGRAM = "program"  # likewise
TO_ITS_END = "the program comes to its end"
WITHIN_LIMITS = "within the limits of the robot"
NOTHING = Fraction(0)
NOT_REACHED = "not reached: the program could not be run"


def earned(
    task: Task,
    results: Sequence[Reached],
    passed: Passed,
    verdicts: Sequence[Verdict],
    losses: Iterable[Loss],
    shown: ShownParts,
) -> tuple[Earned, ...]:
    """Return what a run earned, in the order of the task, as it is shown."""
    costs: dict[str, Fraction] = {}
    for loss in losses:
        costs[loss.check] = costs.get(loss.check, NOTHING) + loss.points
    answers = {v.check: v for v in verdicts}
    targets = [
        Earned(
            result.goal.check,
            result.goal.title,
            "target",
            Answer.HOLDS if result.share == 1 else Answer.VIOLATED,
            _most(task, result.goal) * result.share,
            _most(task, result.goal),
            "" if result.share == 1 else f"`{result.body}` {describe(result)}",
        )
        for result in results
    ]
    if at_the_end(task):
        ends = answers[PROGRAM]
        bad = ends.answer is not Answer.HOLDS
        got, message = (NOTHING, ends.summary) if bad else (shown.targets, "")
        most = shown.most.targets
        targets.append(Earned(PROGRAM, TO_ITS_END, "program", ends.answer, got, most, message))
    each = _full(task)[1] / max(1, len(task.vias))
    vias: list[Earned] = []
    for visits, met in zip(passed.visits, passed.met, strict=True):
        verdict = answers[f"via {visits.via.name}"]
        points = each if met else NOTHING
        message = "" if verdict.answer is Answer.HOLDS else verdict.summary
        vias.append(
            Earned(verdict.check, visits.via.name, "via", verdict.answer, points, each, message)
        )
    found = _together(targets, shown.targets, shown.most.targets)
    found += _together(vias, shown.vias, shown.most.vias)
    if shown.limits:
        found.append(_that_costs(answers[LIMITS], WITHIN_LIMITS, "limit", shown.limits))
    if COLLISION in answers:
        found.append(_that_costs(answers[COLLISION], "no contact", "contact", shown.contacts))
    asked = [v for v in verdicts if v.check.startswith(DEMAND)]
    for demand, verdict in zip(task.costs, asked, strict=True):
        cost = costs.pop(verdict.check, NOTHING)  # once, also where two have one name
        found.append(_that_costs(verdict, demand.name, "demand", cost))
    most = shown.most.time
    quick = Answer.HOLDS if shown.time == most else Answer.VIOLATED
    found.append(Earned("duration", "time", "time", quick, shown.time, most, ""))
    return tuple(found)


def _together(rows: list[Earned], points: Fraction, most: Fraction) -> list[Earned]:
    """Return rows whose points as they are shown add up, and so does what they could have earned.

    Which of them is shown with a hundredth more may differ from run to run: what is earned in full
    is shown in full.
    """
    if not rows:
        return []
    got = apportioned([row.points for row in rows], points)
    lacks = apportioned([row.most - row.points for row in rows], most - points)
    return [
        row._replace(points=mine, most=mine + lack)
        for row, mine, lack in zip(rows, got, lacks, strict=True)
    ]


def not_reached(task: Task) -> tuple[Earned, ...]:
    """Return what a program earns that could not be run."""
    each = _full(task)[1] / max(1, len(task.vias))
    most = most_of(task)
    targets = [
        Earned(g.check, g.title, "target", None, NOTHING, _most(task, g), NOT_REACHED)
        for g in task.targets
    ]
    if at_the_end(task):
        row = (PROGRAM, TO_ITS_END, "program", None, NOTHING, most.targets, NOT_REACHED)
        targets.append(Earned(*row))
    vias = [
        Earned(f"via {via.name}", via.name, "via", None, NOTHING, each, NOT_REACHED)
        for via in task.vias
    ]
    others = [
        (COLLISION, "no contact", "contact", NOTHING),
        *((DEMAND + d.name, d.name, "demand", NOTHING) for d in task.costs),
        ("duration", "time", "time", most.time),
    ]
    return (
        *_together(targets, NOTHING, most.targets),
        *_together(vias, NOTHING, most.vias),
        *(
            Earned(check, title, kind, None, NOTHING, points, NOT_REACHED)
            for check, title, kind, points in others
        ),
    )


def at_the_end(task: Task) -> bool:
    """Return whether points are given for coming to the end: there is nothing to reach."""
    return not task.targets and not task.vias


def _full(task: Task) -> tuple[Fraction, Fraction]:
    """Return the points for all targets and for all via points."""
    return divided(task.mark, targets=bool(task.targets), vias=bool(task.vias))


def _most(task: Task, goal: Goal | Relation) -> Fraction:
    total = sum((goal.weight for goal in task.targets), NOTHING)
    return _full(task)[0] * goal.weight / total


def _that_costs(verdict: Verdict, title: str, kind: str, cost: Fraction) -> Earned:
    message = "" if verdict.answer is Answer.HOLDS else verdict.summary
    return Earned(verdict.check, title, kind, verdict.answer, -cost, NOTHING, message)
