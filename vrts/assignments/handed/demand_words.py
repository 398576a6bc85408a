"""What a task demands of the way a goal is reached, in plain words with its numbers."""

from collections.abc import Iterator

from vrts.assignments.handed.words import box, number, points, title
from vrts.check.rules.proof_demand import EVERY_FUTURE
from vrts.check.task.demands import Demand, Keeps
from vrts.check.task.task import Task
from vrts.check.verdicts.demand_words import wanted


def demand_words(task: Task) -> Iterator[str]:
    """Yield every demand of the public part of a task, and what it costs."""
    for demand in task.demands:
        yield f"{_demand(demand)} (else {points(demand.points)} lost)"
    if task.proof is not None:
        future = f"{EVERY_FUTURE}: nothing goes wrong, whatever comes from outside, and whenever"
        yield f"{future} (else {points(task.proof.points)} lost)"


def _demand(demand: Demand) -> str:
    match demand.keeps:
        case Keeps.TOOL_OUT | Keeps.ROBOT_OUT:
            return f"{title(wanted(demand))}: {box(demand.lower, demand.upper)}"
        case Keeps.USES:
            return f"the program uses `{demand.word}`"
        case Keeps.AVOIDS:
            return f"the program does not use `{demand.word}`"
        case Keeps.STEPS:
            return f"the program has {number(demand.limit)} steps at most"
        case _:
            return title(wanted(demand))
