"""Whether objects have reached their goals when the program ends, or at t_max."""

import math
from fractions import Fraction
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.base.pose import Pose, distance, dot, rotate, rotation_angle
from vrts.base.units import deg, mm
from vrts.check.rounding import exact_deg, exact_mm
from vrts.check.task.score import share_of
from vrts.check.task.task import Goal, Task
from vrts.check.verdict import Answer, Verdict
from vrts.engine.memory.records import Lie, Placement
from vrts.engine.run import Run, pose_of
from vrts.scene.model import Body

NOT_REACHED = Rule("V660", "goal-not-reached")
PARTLY_REACHED = Rule("V661", "goal-missed-by-little")

FLOOR = "floor"


class Reached(NamedTuple):
    """How an object lies compared with its goal."""

    goal: Goal
    share: Fraction  # s: 1 is fully reached
    position_mm: Fraction  # error
    orientation_deg: Fraction  # error
    problem: str | None  # why it earns nothing whatever its pose: "is still in the hand"


def judged_at(run: Run, task: Task) -> float:
    """Return when goals are judged: at the end of the program, or at t_max [s]."""
    latest = run.started_s + task.t_max
    ended = run.ended_s
    return min(latest, run.horizon_s) if ended is None else min(latest, ended)


def reached(run: Run, task: Task) -> tuple[Reached, ...]:
    """Return how every goal was met."""
    time_s = judged_at(run, task)
    state = run.at(time_s)
    placements, X_WF = state.placements, state.X_WF
    return tuple(
        _reached(
            goal,
            run.scene.body(goal.body),
            placements[goal.body],
            pose_of(placements[goal.body], time_s, X_WF),
            task.mark.zero_at,
        )
        for goal in task.goals
    )


def orientation_error(body: Body, X_WO: Pose, X_WG: Pose) -> float:
    """Return the angle between two orientations [rad]; turning about a symmetry axis is free."""
    if body.symmetry_axis is None:
        return rotation_angle(X_WO.rotation, X_WG.rotation)
    is_axis = rotate(X_WO.rotation, body.symmetry_axis)
    to_be = rotate(X_WG.rotation, body.symmetry_axis)
    return math.acos(max(-1.0, min(1.0, dot(is_axis, to_be))))


def verdicts(results: tuple[Reached, ...], span: Label | None = None) -> tuple[Verdict, ...]:
    """Return a verdict for every goal."""
    return tuple(_verdict(result) for result in results)


def describe(result: Reached) -> str:
    """Return what is wrong with an object's place, in words after its name."""
    if result.problem is not None:
        return result.problem
    parts: list[str] = []
    goal = result.goal
    if result.position_mm > exact_mm(goal.position_tolerance):
        parts.append(f"is {float(result.position_mm):.0f} mm from its goal")
    if result.orientation_deg > exact_deg(goal.orientation_tolerance):
        parts.append(f"is turned {float(result.orientation_deg):.0f} degrees away from it")
    return " and ".join(parts) or "is in place"


def _reached(
    goal: Goal, body: Body, placement: Placement, X_WO: Pose, zero_at: Fraction
) -> Reached:
    position = exact_mm(distance(X_WO.translation, goal.X_WG.translation))
    orientation = exact_deg(orientation_error(body, X_WO, goal.X_WG))
    problem = _problem(placement)
    share = min(
        share_of(position, exact_mm(goal.position_tolerance), zero_at),
        share_of(orientation, exact_deg(goal.orientation_tolerance), zero_at),
    )
    return Reached(goal, Fraction(0) if problem else share, position, orientation, problem)


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


def _verdict(result: Reached) -> Verdict:
    goal = result.goal
    summary = f"`{goal.body}` {describe(result)}"
    evidence = {
        "position_mm": float(result.position_mm),
        "orientation_deg": float(result.orientation_deg),
        "share": round(float(result.share), 4),
    }
    if result.share == 1:
        return Verdict(f"target {goal.body}", Answer.HOLDS, f"{goal.title}: in place", (), evidence)
    rule = NOT_REACHED if result.share == 0 else PARTLY_REACHED
    finding = Diagnostic(
        rule,
        Severity.ERROR,
        summary,
        None,
        notes=(_tolerances(goal),),
        data={
            "object": goal.body,
            "position_mm": float(result.position_mm),
            "orientation_deg": float(result.orientation_deg),
        },
    )
    return Verdict(f"target {goal.body}", Answer.VIOLATED, summary, (finding,), evidence)


def _tolerances(goal: Goal) -> str:
    position, orientation = mm(goal.position_tolerance), deg(goal.orientation_tolerance)
    return f"the goal, {goal.title}, allows {position:.0f} mm and {orientation:.0f} degrees"
