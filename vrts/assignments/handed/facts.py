"""The tolerances, times and totals that the public part of a task has, and what each is of."""

import re
from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from vrts.assignments.handed.words import number
from vrts.base.pose import Vector
from vrts.base.units import deg, mm
from vrts.check.task.demands import Demand, Keeps
from vrts.check.task.goals import Goal, Relation
from vrts.check.task.score import divided
from vrts.check.task.task import Task, ViaPoint
from vrts.scene.model import Scene

PASSING = ("tool", "pads", "pass", "passes", "passed", "passing", "through", "durch", "werkzeug")


class Fact(NamedTuple):
    """A number of a task."""

    unit: str  # "mm", "degrees", "s" or "points"
    value: Fraction  # in the unit
    of: tuple[str, ...] = ()  # words for what it belongs to; none: the whole task


def facts_of(task: Task, scene: Scene) -> tuple[Fact, ...]:
    """Return every number that a sentence about a task may name as a tolerance, time or total."""
    return tuple(_facts(task, frozenset(body.name for body in scene.bodies)))


def _facts(task: Task, bodies: frozenset[str]) -> Iterator[Fact]:
    shares = divided(task.mark, targets=bool(task.targets), vias=bool(task.vias))
    yield from (Fact("points", share) for share in (task.mark.total, *shares) if share)
    yield from (Fact("s", _exact(time)) for time in (task.t_par, task.t_max))
    for goal in task.goals:
        yield from _of_goal(goal, bodies)
    for relation in task.relations:
        yield from _of_relation(relation)
    for via in task.vias:
        yield from _of_via(via)
    for demand in task.demands:
        yield from _of_demand(demand)


def _of_goal(goal: Goal, bodies: frozenset[str]) -> Iterator[Fact]:
    titles = " ".join((goal.title, *(choice.where for choice in goal.choices)))
    of = tuple(
        dict.fromkeys((*goal.bodies, *(w for w in re.findall(r"\w+", titles) if w in bodies)))
    )
    yield Fact("mm", _exact(mm(goal.position_tolerance)), of)
    yield Fact("degrees", _exact(deg(goal.orientation_tolerance)), of)


def _of_relation(relation: Relation) -> Iterator[Fact]:
    of = tuple(filter(None, (relation.body, relation.other)))
    if relation.tolerance is not None:
        yield Fact("mm", _exact(mm(relation.tolerance)), of)
    if relation.turn_tolerance:
        yield Fact("degrees", _exact(deg(relation.turn_tolerance)), of)
    yield from _of_box(relation.lower, relation.upper, of)


def _of_via(via: ViaPoint) -> Iterator[Fact]:
    of = (via.name, *PASSING)
    yield Fact("mm", _exact(mm(via.radius)), of)
    if via.approach is not None:
        yield Fact("degrees", _exact(deg(via.cone)), of)


def _of_demand(demand: Demand) -> Iterator[Fact]:
    match demand.keeps:
        case Keeps.TOOL_OUT | Keeps.ROBOT_OUT:
            yield from _of_box(demand.lower, demand.upper, (demand.name, "zone"))
        case Keeps.UPRIGHT:
            yield Fact("degrees", _exact(deg(demand.limit)), (demand.body,))
        case Keeps.WRIST:
            yield Fact("degrees", _exact(deg(demand.limit)), ("wrist",))
        case Keeps.ELBOW:
            yield Fact("degrees", _exact(deg(demand.limit)), ("elbow",))
        case Keeps.SHOULDER:
            yield Fact("mm", _exact(mm(demand.limit)), ("shoulder",))
        case _:  # speeds, shares and words are no tolerances
            return


def _of_box(lower: Vector, upper: Vector, of: tuple[str, ...]) -> Iterator[Fact]:
    """Yield where the sides of a box are, and how long."""
    for a, b in zip(lower, upper, strict=True):
        if b > a:
            yield from (Fact("mm", _exact(mm(value)), of) for value in (abs(a), abs(b), b - a))


def _exact(value: float) -> Fraction:
    """Return a number as students are told it."""
    return Fraction(number(value))
