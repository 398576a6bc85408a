"""Whether what a task asks for can be had at all: goals and via points, before any program runs."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.base.oat import rotation_from_oat
from vrts.base.pose import Pose, Rotation, cross, dot, multiply, rotation_about
from vrts.base.source import Span
from vrts.base.units import mm
from vrts.check.task.goals import Choice, Goal
from vrts.check.task.task import Task, ViaPoint
from vrts.scene.clearance import clearance, overlap_is_within, placed_body
from vrts.scene.handling.holds import holds
from vrts.scene.model import Body, Mobility, Scene
from vrts.scene.reach import branches
from vrts.scene.standing import DEEPEST, TOUCHING, find_support

GOAL_INSIDE = Rule("V667", "goal-inside")
GOAL_FLOATS = Rule("V668", "goal-floats")
GOAL_UNREACHABLE = Rule("V669", "goal-unreachable")
VIA_UNREACHABLE = Rule("V670", "via-unreachable")

LEVEL = 0.9999  # cosine of the inclination up to which a body counts as upright
TURNS = range(-180, 180, 15)  # [degrees] of the hand about a direction that is asked for
PITCHES = (90, 45, 0, -45, -90)  # [degrees] A: straight down, .. level, .. straight up
HEADINGS = range(-180, 180, 45)  # [degrees] O
STEEP = 1e-6  # level part of a direction below which it is up or down


def task_findings(scene: Scene, task: Task) -> tuple[Diagnostic, ...]:
    """Return what speaks against the goals and via points of a task in its scene."""
    found: list[Diagnostic] = []
    for goal in task.goals:
        for choice in goal.choices:
            found += _goal(scene, task, goal, choice)
    return (*found, *_vias(scene, task.vias))


def _goal(scene: Scene, task: Task, goal: Goal, choice: Choice) -> Iterator[Diagnostic]:
    body = replace(scene.body(choice.body), X_WO=choice.X_WG)
    others = at_the_end(scene, task, choice.body)
    which = f" {choice.where}" if goal.others else ""
    inside = tuple(_inside(goal, body, others, which))
    yield from inside
    started = (b for b in scene.bodies if b.name != body.name)
    known = {other.name for other in others}
    if not inside and not _stands(body, (*others, *(b for b in started if b.name not in known))):
        yield _finding(
            GOAL_FLOATS,
            f"at its goal{which} `{body.name}` stands on nothing",
            goal.span,
            (f"its underside would be at z = {mm(choice.X_WG.translation[2]):.1f} mm",),
            ('write on = "NAME" of what it is to stand on',),
        )
    ways = tuple(holds(scene.robot.gripper, scene.body(body.name)))
    X_PF = scene.robot.gripper.X_FP.inverse()
    if ways and not any(_reaches(scene, choice.X_WG @ X_OP @ X_PF) for X_OP in ways):
        yield _finding(
            GOAL_UNREACHABLE,
            f"the robot cannot set `{body.name}` down at its goal{which}",
            goal.span,
            (f"tried: {len(ways)} ways to hold it, all branches",),
            ("move the goal nearer to the robot",),
        )


def _stands(body: Body, others: Sequence[Body]) -> bool:
    """Return whether something holds a body up; if inclined, whether it touches anything."""
    upward = body.X_WO.apply((0.0, 0.0, 1.0))[2] - body.X_WO.translation[2]
    if upward > LEVEL:
        return find_support(body, others).body is not None
    placed = placed_body(body)
    return any(clearance(placed, placed_body(other), TOUCHING) < TOUCHING for other in others)


def at_the_end(scene: Scene, task: Task, besides: str) -> tuple[Body, ...]:
    """Return the other bodies where the task wants them; those without a goal where they start.

    Those that may end at several places, or beside something, are left out: nobody knows where.
    """
    wanted = {goal.body: goal.X_WG for goal in task.goals if not goal.others}
    anywhere = {name for goal in task.goals if goal.others for name in goal.bodies}
    anywhere |= {relation.body for relation in task.relations} - wanted.keys()
    return tuple(
        replace(body, X_WO=wanted.get(body.name, body.X_WO))
        for body in scene.bodies
        if body.name != besides and body.name not in anywhere
    )


def _inside(goal: Goal, body: Body, others: Sequence[Body], which: str) -> Iterator[Diagnostic]:
    placed = placed_body(body)
    for other in others:
        if overlap_is_within(placed, placed_body(other), DEEPEST):
            continue
        depth = -clearance(placed, placed_body(other), 0.0)
        movable = other.mobility is Mobility.MOVABLE
        where = ", where that is at the end" if movable else ""
        yield _finding(
            GOAL_INSIDE,
            f"the goal of `{body.name}`{which} is inside `{other.name}`{where}",
            goal.span,
            (f"{mm(depth):.1f} mm deep",),
            ("move the goal or the body",),
        )


def _vias(scene: Scene, vias: Sequence[ViaPoint]) -> Iterator[Diagnostic]:
    for via in vias:
        poses = [Pose(rotation, via.point) for rotation in _rotations(via)]
        if any(_reaches(scene, X_WT @ scene.X_FT.inverse()) for X_WT in poses):
            continue
        yield Diagnostic(
            VIA_UNREACHABLE,
            Severity.WARNING,
            f"the tool cannot be brought to `{via.name}`",
            None if via.span is None else Label(via.span),
            notes=(f"tried: {len(poses)} directions of the hand, all branches",),
            help=("move the via point nearer to the robot",),
        )


def _rotations(via: ViaPoint) -> Iterator[Rotation]:
    """Return orientations of the tool that a via point allows."""
    wanted = via.approach
    if wanted is not None:  # with y level, or along Y where the tool points up or down
        x, y, z = wanted
        across = math.hypot(x, y)
        side = (-y / across, x / across, 0.0) if across > STEEP else (0.0, 1.0, 0.0)
        (a, b, c), (d, e, f) = cross(side, wanted), side
        length = math.hypot(a, b, c)
        exact = (a / length, d, x, b / length, e, y, c / length, f, z)
        for turn in TURNS:
            yield multiply(exact, rotation_about((0.0, 0.0, 1.0), math.radians(turn)))
    for a, o in product(PITCHES, HEADINGS):
        rotation = rotation_from_oat(o, a, 0.0)
        approach = (rotation[2], rotation[5], rotation[8])
        if wanted is None or dot(approach, wanted) >= math.cos(via.cone):
            yield rotation


def _reaches(scene: Scene, X_WF: Pose) -> bool:
    return any(way.within_limits for way in branches(scene.robot, X_WF))


def _finding(
    rule: Rule, headline: str, span: Span | None, notes: tuple[str, ...], remedy: tuple[str, ...]
) -> Diagnostic:
    primary = None if span is None else Label(span)
    return Diagnostic(rule, Severity.ERROR, headline, primary, notes=notes, help=remedy)
