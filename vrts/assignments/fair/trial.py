"""One variant tried: can it be done, and how hard is it?"""

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace
from fractions import Fraction
from typing import NamedTuple

from vrts.assignments.task_check import EMPTY
from vrts.assignments.variants.of_task import VariedTask
from vrts.base.diagnostic import Diagnostic
from vrts.base.pose import IDENTITY
from vrts.base.units import DEG, mm
from vrts.check.mark.grade import Grade
from vrts.check.task.feasible import task_findings
from vrts.check.task.task import Task
from vrts.check.variants.model import Combination
from vrts.check.verdicts.duration import duration
from vrts.geometry.support import extent_of
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.refused import Refused
from vrts.pipeline.request import Checks, Request
from vrts.pipeline.setting import Setting
from vrts.report.assessment import Assessment
from vrts.report.quantities import full
from vrts.scene.checks import scene_findings
from vrts.scene.handling.holds import TURNS
from vrts.scene.model import Scene

NAME = "reference"
NOT_CERTIFIED = "the collision checks of the reference are not certified"
WITHOUT_END = "the reference does not come to its end"


class Room(NamedTuple):
    """By how far a program may be off in one thing that is asked for."""

    of: str  # "goal 1": the same in all variants
    unit: str
    value: float  # in the unit


class Trial(NamedTuple):
    """What was found out about a variant."""

    combination: Combination
    problems: tuple[str, ...]  # why it cannot be handed out
    time_s: float | None = None  # of the reference; None: it does not come to its end
    clearance_m: float | None = None  # least certified distance; None: something touches
    rooms: tuple[Room, ...] = ()  # that a program has, in everything that asks for a place
    program: bytes = b""  # the reference with the variant's places


def tried(varied: VariedTask, combination: Combination) -> Trial:
    """Return what was found out about a variant, by runs of the reference and of no program.

    Args:
        varied: The task; it has a reference.
        combination: The variant.
    """
    try:
        setting = varied.setting(combination)
    except Refused as refused:
        return Trial(combination, _errors(refused.diagnostics))
    task = setting.task
    assert task is not None
    program = varied.reference(combination, setting)
    assert program is not None
    found = [*setting.diagnostics, *scene_findings(setting.scene)]
    found += task_findings(setting.scene, task)
    problems = [*_errors(found), *_by_nothing(setting)]
    a = assess(Request(ProgramFile(program, NAME), replace(setting, stamps=())))
    problems += _by_reference(a)
    took = None if a.run is None else duration(a.run)
    report = None if a.judgement is None else a.judgement.collisions
    nearest = None if report is None or report.clearance is None else report.clearance
    return Trial(
        combination,
        tuple(dict.fromkeys(problems)),
        None if took is None else float(took),
        None if nearest is None else nearest.distance_m,
        tuple(_rooms(setting.scene, task)),
        program,
    )


def earned(
    varied: VariedTask, combination: Combination, programs: tuple[bytes, ...]
) -> tuple[Fraction, ...]:
    """Return which share of the full mark programs earn in a variant.

    What is at most half without contacts is not looked through for contacts, which only cost.

    Args:
        varied: The task.
        combination: The variant that they are marked by.
        programs: What is handed in.
    """
    setting = varied.setting(combination)
    return tuple(_share(setting, program) for program in programs)


def _share(setting: Setting, program: bytes) -> Fraction:
    file = ProgramFile(program, "copy")
    grade: Grade | None = None
    for collisions in (False, True):
        grade = assess(Request(file, setting, checks=Checks(collisions=collisions))).grade
        assert grade is not None
        if 2 * grade.mark <= grade.total:
            break
    assert grade is not None
    return grade.mark / grade.total


def _errors(found: Iterable[Diagnostic]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(d.headline for d in found if d.is_error))


def _by_nothing(setting: Setting) -> Iterator[str]:
    """Yield that a program that does nothing earns something."""
    request = Request(ProgramFile(EMPTY, "the empty program"), setting)
    grade = assess(request._replace(checks=Checks(collisions=False))).grade
    assert grade is not None
    if grade.mark:
        yield f"a program that does nothing gets {float(grade.mark):g} of {full(grade.total)}"


def _by_reference(a: Assessment) -> Iterator[str]:
    """Yield why the reference is not as it has to be."""
    grade = a.grade
    assert grade is not None
    if grade.mark != grade.total:
        losses = [loss.sentence for loss in grade.losses if loss.points]
        why = f": {losses[0]}" if losses else ""
        yield f"the reference gets {float(grade.mark):g} of {full(grade.total)}{why}"
    elif not grade.ready:
        why = f": {grade.obstacles[0]}" if grade.obstacles else ""
        yield f"the reference is not ready for a real robot{why}"
    if a.run is not None and duration(a.run) is None:
        yield WITHOUT_END
    report = None if a.judgement is None else a.judgement.collisions
    if report is not None and not report.certified:
        yield NOT_CERTIFIED


def _rooms(scene: Scene, task: Task) -> Iterator[Room]:
    """Yield by how far a program may be off, for everything that asks for a place."""
    for number, goal in enumerate(task.goals, 1):
        yield Room(f"goal {number}", "mm", mm(goal.position_tolerance))
        yield Room(f"goal {number}, turned", "deg", goal.orientation_tolerance / DEG)
    for number, relation in enumerate(task.relations, 1):
        if relation.tolerance is not None:
            yield Room(f"relation {number}", "mm", mm(relation.tolerance))
        if relation.turn_tolerance:
            yield Room(f"relation {number}, turned", "deg", relation.turn_tolerance / DEG)
    for number, via in enumerate(task.vias, 1):
        yield Room(f"via {number}", "mm", mm(via.radius))
        if via.approach is not None:
            yield Room(f"via {number}, turned", "deg", via.cone / DEG)
    opening = scene.robot.gripper.opening_max
    bodies = {name for goal in task.goals for name in goal.bodies}
    bodies |= {relation.body for relation in task.relations}
    for body in scene.bodies:
        if body.name not in bodies or body.kind == "dish":  # a dish is held by its wall
            continue
        widths = [
            extent_of(
                body.pieces, IDENTITY, (math.cos(turn * DEG), math.sin(turn * DEG), 0.0)
            ).length
            for turn in TURNS
        ]
        if min(widths) <= opening:
            side = (opening - min(widths)) / 2  # with the hand wide open
            yield Room(f"the grip of {body.name}", "mm", mm(side))
