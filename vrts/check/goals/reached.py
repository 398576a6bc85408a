"""How every goal and relation of a task was met, when the program ends or at t_max."""

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from vrts.check.goals.assignment import assigned
from vrts.check.goals.phases import was_gripped, was_lifted
from vrts.check.goals.placed import errors_at
from vrts.check.goals.related import Lying, missing, share
from vrts.check.goals.too_fast import overruns
from vrts.check.task.goals import Choice, Goal, Phases, Relation
from vrts.check.task.task import Task
from vrts.engine.memory.events import Landed
from vrts.engine.memory.records import Lie, Placement
from vrts.engine.run import Run, pose_of
from vrts.scene.model import Mobility

FLOOR = "floor"


class Reached(NamedTuple):
    """How an object lies compared with what is asked for."""

    goal: Goal | Relation
    body: str  # the object that counts, where there is a choice
    share: Fraction  # s: 1 is fully reached
    placed: Fraction  # the share by its place alone, without what came before
    position_mm: Fraction  # error
    orientation_deg: Fraction  # error
    problem: str | None  # why it earns nothing for its place: "is still in the hand"
    where: str = ""  # the place that counts, where there is a choice: "on base1"
    gripped: bool | None = None  # None: nothing is given for it
    lifted: bool | None = None


class _Rated(NamedTuple):
    """A choice of a goal, and what it is worth."""

    reached: Reached
    value: tuple[Fraction, Fraction, Fraction]  # what decides: the share, then how near it is


def judged_at(run: Run, task: Task) -> float:
    """Return when goals are judged: at the end of the program, or at t_max [s].

    t_max comes earlier by whatever time was gained by motions too fast for a joint.
    """
    latest = run.started_s + task.t_max
    for end_s, gained in overruns(run):
        latest -= gained if end_s <= latest else 0.0
    latest = max(latest, run.started_s)
    ended = run.ended_s
    return min(latest, run.horizon_s) if ended is None else min(latest, ended)


def reached(run: Run, task: Task, time_s: float | None = None) -> tuple[Reached, ...]:
    """Return how every goal and every relation was met, in this order.

    Args:
        run: What happened.
        task: What is asked for.
        time_s: When goals are judged [s]; None: when the task says.
    """
    time_s = judged_at(run, task) if time_s is None else time_s
    state = run.at(time_s)
    placements, X_WF = state.placements, state.X_WF
    lying = {
        body.name: Lying(body, body.X_WO, ())
        if body.mobility is Mobility.FIXED
        else Lying(
            body,
            pose_of(placements[body.name], time_s, X_WF),
            _supports(run, placements[body.name]),
        )
        for body in run.scene.bodies
    }
    problems = {name: _problem(placement) for name, placement in placements.items()}

    @cache
    def phases_of(body: str, wanted: Phases) -> tuple[bool | None, bool | None]:
        return (
            was_gripped(run, body, time_s) if wanted.gripped else None,
            was_lifted(run, body, wanted.height, time_s) if wanted.lifted else None,
        )

    def rated(goal: Goal, choice: Choice) -> _Rated:
        this, problem = lying[choice.body], problems[choice.body]
        near, found = errors_at(
            this.body, goal.looks, this.X_WO, choice.X_WG, goal, task.mark.zero_at
        )
        gripped, lifted = phases_of(choice.body, goal.phases)
        placed = Fraction(0) if problem else near
        done = with_phases(placed, goal.phases, gripped, lifted)
        result = Reached(
            goal,
            choice.body,
            done,
            placed,
            found.position_mm,
            found.orientation_deg,
            problem,
            choice.where if goal.others else "",
            gripped,
            lifted,
        )
        return _Rated(result, (done, -found.position_mm, -found.orientation_deg))

    goals = _best(task.goals, [[rated(goal, c) for c in goal.choices] for goal in task.goals])
    return (*goals, *(_related(r, lying, problems, task.mark.zero_at) for r in task.relations))


def with_phases(
    placed: Fraction, phases: Phases, gripped: bool | None, lifted: bool | None
) -> Fraction:
    """Return the share of a goal with what its phases give.

    What an object's place does not earn is given in part for what came before it. So nothing that
    gets better ever costs, and in place is in place, however the object came there.
    """
    before = (phases.gripped if gripped else 0) + (phases.lifted if lifted else 0)
    return placed + (1 - placed) * before


def _best(goals: Sequence[Goal], rated: Sequence[Sequence[_Rated]]) -> tuple[Reached, ...]:
    """Return for every goal the choice that counts: the best together for those that share."""
    found: dict[int, Reached] = {}
    groups: dict[int, list[int]] = {}
    for n, goal in enumerate(goals):
        if goal.group is None:
            found[n] = max(rated[n], key=lambda each: each.value).reached
        else:
            groups.setdefault(goal.group, []).append(n)
    for members in groups.values():
        values = _whole([[each.value for each in rated[n]] for n in members])
        for n, column in zip(members, assigned(values), strict=True):
            found[n] = rated[n][column].reached
    return tuple(found[n] for n in range(len(goals)))


def _whole(table: Sequence[Sequence[tuple[Fraction, Fraction, Fraction]]]) -> list[list[int]]:
    """Return values as whole numbers: a larger share outweighs every distance, that every turn."""
    scales = [math.lcm(*(value[k].denominator for row in table for value in row)) for k in range(3)]
    whole = [[tuple(int(value[k] * scales[k]) for k in range(3)) for value in row] for row in table]
    spans = [
        1 + len(table) * max(abs(value[k]) for row in whole for value in row) * 2 for k in (1, 2)
    ]
    return [
        [(value[0] * spans[0] + value[1]) * spans[1] + value[2] for value in row] for row in whole
    ]


def _related(
    relation: Relation,
    lying: Mapping[str, Lying],
    problems: Mapping[str, str | None],
    zero_at: Fraction,
) -> Reached:
    found = missing(relation, lying)
    problem = problems[relation.body]
    if problem is None and problems.get(relation.other) is not None:
        problem = f"has nothing to stand by: `{relation.other}` {problems[relation.other]}"
    done = Fraction(0) if problem else share(relation, found, zero_at)
    return Reached(
        relation, relation.body, done, done, found.position_mm, found.orientation_deg, problem
    )


def _supports(run: Run, placement: Placement) -> tuple[str, ...]:
    """Return what a body rests on: more than one, where it was put across several."""
    if placement.support is None:
        return ()
    landed = (
        event.also
        for event in run.events
        if isinstance(event, Landed)
        and event.body == placement.body
        and event.time_s == placement.start_s
    )
    return (placement.support, *next(landed, ()))


def _problem(placement: Placement) -> str | None:
    match placement.lie:
        case Lie.HELD:
            return "is still in the hand"
        case Lie.FALLING:
            return "is still falling"
        case Lie.TOPPLED:
            return "has toppled"
        case Lie.RESTING:
            return "lies on the floor" if placement.support == FLOOR else None
