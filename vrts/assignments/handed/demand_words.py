"""What a task demands of the way a goal is reached, in plain words with its numbers."""

from collections.abc import Iterator

from vrts.assignments.handed.words import box, number, points, title
from vrts.base.units import deg, mm
from vrts.check.rules.proof_demand import EVERY_FUTURE
from vrts.check.task.demands import Demand, Keeps
from vrts.check.task.task import Task


def demand_words(task: Task) -> Iterator[str]:
    """Yield every demand of the public part of a task, and what it costs."""
    for demand in task.demands:
        yield f"{_demand(demand)} (else {points(demand.points)} lost)"
    if task.proof is not None:
        future = f"{EVERY_FUTURE}: nothing goes wrong, whatever comes from outside, and whenever"
        yield f"{future} (else {points(task.proof.points)} lost)"


def _demand(demand: Demand) -> str:
    limit = demand.limit
    match demand.keeps:
        case Keeps.TOOL_OUT:
            zone = f"{title(demand.name)}: {box(demand.lower, demand.upper)}"
            return f"the tool stays out of the zone {zone}"
        case Keeps.ROBOT_OUT:
            zone = f"{title(demand.name)}: {box(demand.lower, demand.upper)}"
            return f"arm, hand and what it holds stay out of the zone {zone}"
        case Keeps.UPRIGHT:
            return f"`{demand.body}` stays upright, within {number(deg(limit))} degrees"
        case Keeps.JOINT_SPEED:
            return f"no joint is faster than {number(100 * limit)} % of its limit"
        case Keeps.TOOL_SPEED:
            return f"the tool is never faster than {number(mm(limit))} mm/s"
        case Keeps.WRIST:
            return f"the wrist keeps {number(deg(limit))} degrees away from its singularity"
        case Keeps.ELBOW:
            return f"the elbow keeps {number(deg(limit))} degrees away from its singularity"
        case Keeps.SHOULDER:
            return f"the shoulder keeps {number(mm(limit))} mm away from its singularity"
        case Keeps.SINGULAR:
            return f"the smallest singular value is {limit:g} or more"
        case Keeps.USES:
            return f"the program uses `{demand.word}`"
        case Keeps.AVOIDS:
            return f"the program does not use `{demand.word}`"
        case Keeps.STEPS:
            return f"the program has {number(limit)} steps at most"
