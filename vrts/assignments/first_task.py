"""The first version of a task and of its reference: whatever the hand can carry goes to a base.

Everything in them was executed: a pair of locations that does not bring its object to its goal is
left out, and the reference gets all points for goals in the task that is written.
"""

import math
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import NamedTuple

from vrts.assignments.new_files import Carrying, new_solution, new_task
from vrts.assignments.suggested import suggested
from vrts.assignments.task_check import times_of
from vrts.base.pose import rotation_about, rotation_angle
from vrts.base.source import SourceFile
from vrts.base.units import deg
from vrts.check.task.task import Task
from vrts.check.task.task_file import read_task
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting
from vrts.report.assessment import Assessment
from vrts.scene.model import Body, Mobility, Scene
from vrts.scene.things.symmetry import SAME_TURN, symmetries_of

FIRST_GUESS = Fraction(600)  # of the reference's duration [s], until it is known
VERTICAL = (0.0, 0.0, 1.0)


class FirstTask(NamedTuple):
    """Files of a task."""

    task: str
    solution: str
    setting: Setting  # with the task


def first_task(title: str, label: str, setting: Setting) -> FirstTask | None:
    """Return a task that asks to carry as much as can be carried; None: there is nothing.

    Args:
        title: Of the task.
        label: Name of its folder.
        setting: The scene, without a task.
    """
    work = carryings(setting)
    for count in range(len(work), 0, -1):
        found = _tried(title, label, setting, work[:count])
        if found is not None:
            return found
    return None


def carryings(setting: Setting) -> tuple[Carrying, ...]:
    """Return an object for every base, as far as a program was found that carries it there."""
    scene = setting.scene
    movable = [body for body in scene.bodies if body.mobility is Mobility.MOVABLE]
    found: list[Carrying] = []
    for base in (body for body in scene.bodies if body.kind == "base"):
        for body in movable:
            if any(body.name == other.body for other in found):
                continue
            one = _carrying(setting, body, base)
            if one is not None:
                found.append(one)
                break
    return tuple(found)


def _carrying(setting: Setting, body: Body, base: Body) -> Carrying | None:
    """Return with which locations an object is brought to a base; None: with none that is known."""
    one = Carrying(body.name, base.name, "", "", _turn(body))
    task = _task_of(new_task("", "", setting.scene, (one,), FIRST_GUESS), setting.scene)
    found = suggested(replace(setting, task=task))
    scene = setting.scene
    for way in found.ways:
        if way.grip in scene.locations and way.put in scene.locations:
            return one._replace(start=way.grip, goal=way.put)
    return None


def _turn(body: Body) -> float:
    """Return how an object that is carried as it stands is turned at its goal [degrees]."""
    own = math.atan2(body.X_WO.rotation[3], body.X_WO.rotation[0])
    alike = symmetries_of(body).upright()
    turns = [turn.rotation for turn in alike.turns]
    about = rotation_about(VERTICAL, own)
    if alike.axis is not None or any(rotation_angle(about, t) < SAME_TURN for t in turns):
        return 0.0
    return round(deg(own), 2)


def _tried(title: str, label: str, setting: Setting, work: Sequence[Carrying]) -> FirstTask | None:
    """Return a task with its reference; None if that does not reach all and touch nothing."""
    solution = new_solution(title, setting.scene, work)
    times = times_of(_run(solution, setting))
    if times is None:
        return None
    text = new_task(title, label, setting.scene, work, Fraction(times.reference_s))
    within = replace(setting, task=_task_of(text, setting.scene))
    a = _run(solution, within)
    ready = a.grade is not None and a.grade.ready
    return FirstTask(text, solution, within) if ready else None


def _run(solution: str, setting: Setting) -> Assessment:
    return assess(Request(ProgramFile(solution.encode(), "solution.v2"), setting))


def _task_of(text: str, scene: Scene) -> Task:
    task, told = read_task(SourceFile("task.toml", text), scene)
    assert task is not None, [d.headline for d in told]
    return task
