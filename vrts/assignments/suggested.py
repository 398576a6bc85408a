"""Locations for the goals of a task: grasps and places that fit together, each pair executed first.

A scene tells a place for every base, but not how a task wants an object to be turned there. Here a
grasp and a place are chosen so that the object ends as the task asks, and a program that carries it
so is run and judged as those of students are. What does not reach its goal is not suggested. Places
are made for goals on bases only: elsewhere to find one may be what the task is about.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice
from types import MappingProxyType
from typing import NamedTuple

from vrts.base.pose import Pose, rotation_about, subtract
from vrts.base.units import DEG, MM
from vrts.check.collision.in_words import subject, target
from vrts.check.goals.placed import counted, errors_at
from vrts.check.goals.reached import reached
from vrts.check.task.feasible import at_the_end
from vrts.check.task.goals import Choice, Goal
from vrts.check.task.task import Task
from vrts.check.verdicts.targets import describe
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting
from vrts.scene.block import location_block
from vrts.scene.clearance import Placed, placed_body
from vrts.scene.handling.holds import holds
from vrts.scene.handling.workable import best_place, tried
from vrts.scene.model import Body, Mobility, Scene
from vrts.scene.standing import find_support

PROGRAM = """\
.PROGRAM main()
        SPEED 100 ALWAYS
        OPENI
{safe}        APPRO {grip}, 120
        MOVES {grip}
        CLOSEI
        DEPARTS 120
{safe}        APPRO {put}, 120
        SPEED 20
        MOVES {put}
        OPENI
        DEPARTS 120
.END
"""
AT_THE_PLACE = ("MOVES", "CLOSEI", "OPENI", "DEPARTS")  # contacts on the way there are another's
LONGEST_S = 600.0  # of a run
MOST_CHOICES = 40  # of all goals
MOST_GRASPS = 60  # looked at for one choice
MOST_RUNS = 4  # for one choice
NEAR = 20 * MM  # a place of the scene that is so near to a goal's, seen from above, is meant for it
LEVEL = 5 * MM  # likewise in height: otherwise it is meant for a higher or a lower object
CLOSE_MM, CLOSE_DEG = 1, 1  # a suggestion is not at the edge of what is allowed
TURNS = range(0, 360, 15)  # [degrees] of what is round


class Way(NamedTuple):
    """How an object is brought to its goal."""

    goal: Goal
    choice: Choice
    grip: str  # names of locations
    put: str


class Suggested(NamedTuple):
    """Locations that were tried in a task."""

    locations: Mapping[str, Pose]
    ways: tuple[Way, ...]
    refused: tuple[tuple[str, str], ...]  # locations of the scene that do not work, and why
    missing: tuple[str, ...]  # goals for which no way was found


@dataclass(slots=True)
class _Search:
    """What is known while ways are looked for."""

    setting: Setting
    task: Task
    locations: dict[str, Pose]  # by name; those of the scene first
    used: set[str] = field(default_factory=set[str])


def suggested(setting: Setting) -> Suggested:
    """Return the locations of a scene, made fit for the goals of the task that is set in it.

    A scene that withholds locations is left as it is: to find these is the work of students.
    """
    task, scene = setting.task, setting.scene
    if task is None or not task.goals or scene.withheld:  # what is to be found is not suggested
        return Suggested(scene.locations, (), (), ())
    search = _Search(setting, task, dict(scene.locations))
    ways: list[Way] = []
    missing: list[str] = []
    every = [(goal, choice) for goal in task.goals for choice in goal.choices]
    for goal, choice in every[:MOST_CHOICES]:
        way = _way(search, goal, choice)
        if way is None and not _is_on_base(scene, choice):
            continue
        if way is None:
            missing.append(_end(goal, choice))
        else:
            ways.append(way)
            search.used |= {way.grip, way.put}
    refused = tuple(_refused(search, every))
    gone = {name for name, _ in refused}
    kept = {name: X_WT for name, X_WT in search.locations.items() if name not in gone}
    if "safe" in kept:
        kept["safe"] = kept.pop("safe")  # the last one, as ever
    return Suggested(MappingProxyType(kept), tuple(ways), refused, tuple(missing))


def what_came_of_it(found: Suggested) -> tuple[str, ...]:
    """Return in words, a line each, what was tried: ways to goals, and places that are no good."""
    lines = [f"{way.grip}, {way.put}: {_end(way.goal, way.choice)}" for way in found.ways]
    if lines:
        lines.insert(0, "Each of these was tried by running it, and brings an object to its goal:")
    for why in dict.fromkeys(why for _, why in found.refused):
        names = ", ".join(name for name, other in found.refused if other == why)
        lines.append(f"Not shown: {names}, with which {why}")
    lines += [f"No way was found from above for: {words}" for words in found.missing]
    return tuple(lines)


def _end(goal: Goal, choice: Choice) -> str:
    return f"{choice.body} {choice.where}" if goal.others else goal.title


def failure(
    setting: Setting, goal: Goal, choice: Choice, grip: tuple[str, Pose], put: tuple[str, Pose]
) -> str | None:
    """Return why a program that carries an object does not bring it to its goal; None: it does.

    What else has a goal stands where it starts; or, if the program then fails, it is taken away.
    """
    task, scene = setting.task, setting.scene
    assert task is not None
    goal = goal._replace(
        body=choice.body, X_WG=choice.X_WG, others=(), group=None, phases=type(goal.phases)()
    )
    safe = "        MOVE safe\n" if "safe" in scene.locations else ""
    text = PROGRAM.format(safe=safe, grip=grip[0], put=put[0])
    known = {grip[0]: grip[1], put[0]: put[1]}
    if safe:
        known["safe"] = scene.locations["safe"]
    data = (text + location_block(known)).encode()
    alone = replace(
        task,
        program=None,
        goals=(goal,),
        relations=(),
        vias=(),
        demands=(),
        t_max=LONGEST_S,
        proof=None,
    )
    away = {name for other in task.goals for name in other.bodies}
    away |= {relation.body for relation in task.relations}
    fewer = tuple(b for b in scene.bodies if b.name == choice.body or b.name not in away)
    found: str | None = None
    for bodies in dict.fromkeys((scene.bodies, fewer)):
        where = replace(
            setting,
            scene=replace(scene, bodies=bodies),
            task=alone,
            scenario=None,
            variants=(),
            stamps=(),
        )
        found = _failure(where, alone, data)
        if found is None:
            return None
    return found


def _failure(setting: Setting, task: Task, data: bytes) -> str | None:
    a = assess(Request(ProgramFile(data, "suggested"), setting))
    if a.run is None or a.judgement is None or a.grade is None:
        return "no program can use it"
    (result,) = reached(a.run, task)
    errors = [d.headline for d in a.run.findings if d.is_error]
    if errors:
        return errors[0]
    if result.share < 1:
        return f"`{result.body}` {describe(result)}"
    report = a.judgement.collisions
    for event in () if report is None else report.contacts:
        if event.cause is not None and event.cause.span.text.split()[0] in AT_THE_PLACE:
            return f"{subject(event)} hits {target(event)}"
    return None


def _way(search: _Search, goal: Goal, choice: Choice) -> Way | None:
    """Return a grasp and a place that were executed, and add them to what is known."""
    for grip, put in islice(_pairs(search, goal, choice), MOST_RUNS):
        if failure(search.setting, goal, choice, grip, put) is None:
            search.locations.update((grip, put))
            return Way(goal, choice, grip[0], put[0])
    return None


def _pairs(
    search: _Search, goal: Goal, choice: Choice
) -> Iterator[tuple[tuple[str, Pose], tuple[str, Pose]]]:
    """Yield named grasps with named places that should bring an object to its goal."""
    scene = search.setting.scene
    body = scene.body(choice.body)
    own = f"{body.name}_grip".lower()
    to_pads = scene.X_FT.inverse() @ scene.robot.gripper.X_FP
    on_base = _is_on_base(scene, choice)
    for X_OP in islice(_grasps(search, body, own, to_pads), MOST_GRASPS if on_base else 1):
        X_WT = body.X_WO @ X_OP @ to_pads.inverse()
        grip = (_name_of(search, own, f"{body.name}_g".lower(), X_WT), X_WT)
        known = [
            (name, X_WP @ to_pads.inverse())
            for name, X_WP in _scene_places(search, own, to_pads)
            if _ends_well(body, goal, choice, X_WP @ X_OP.inverse(), search.task)
        ]
        if known:
            yield grip, known[0]
            continue
        if not on_base:
            continue
        place = _new_place(search, goal, choice, body, X_OP)
        if place is not None:
            numbered = f"{body.name}_put".lower()
            yield grip, (_name_of(search, numbered, numbered, place), place)


def _grasps(search: _Search, body: Body, own: str, to_pads: Pose) -> Iterator[Pose]:
    """Yield X_OP of the middle between the pads: the scene's grasp first, then others."""
    scene = search.setting.scene
    if own in search.locations:
        yield body.X_WO.inverse() @ search.locations[own] @ to_pads
    others = [placed_body(other) for other in scene.bodies if other.name != body.name]
    for X_OP in holds(scene.robot.gripper, body):
        if tried(scene, body.X_WO @ X_OP, others, (placed_body(body),)) is not None:
            yield X_OP


def _scene_places(search: _Search, own: str, to_pads: Pose) -> Iterator[tuple[str, Pose]]:
    """Yield names of locations that something may be set down at, with X_WP of the pads."""
    grips = {
        f"{body.name}_grip".lower()
        for body in search.setting.scene.bodies
        if body.mobility is Mobility.MOVABLE
    }
    for name, X_WT in search.locations.items():
        if name not in grips and name != own:
            yield name, X_WT @ to_pads


def _ends_well(body: Body, goal: Goal, choice: Choice, X_WO: Pose, task: Task) -> bool:
    """Return whether an object that is let go in a pose is just where the goal wants it."""
    share, found = errors_at(body, goal.looks, X_WO, choice.X_WG, goal, task.mark.zero_at)
    return share == 1 and found.position_mm <= CLOSE_MM and found.orientation_deg <= CLOSE_DEG


def _is_on_base(scene: Scene, choice: Choice) -> bool:
    body = replace(scene.body(choice.body), X_WO=choice.X_WG)
    support = find_support(body, scene.bodies).body
    return support is not None and scene.body(support).kind == "base"


def _new_place(search: _Search, goal: Goal, choice: Choice, body: Body, X_OP: Pose) -> Pose | None:
    """Return X_WT where an object that is held so is let go at its goal."""
    scene = search.setting.scene
    looks = counted(body, goal.looks)
    turns: Sequence[Pose] = looks.turns
    if looks.axis is not None:
        about = [rotation_about(looks.axis, turn * DEG) for turn in TURNS]
        round_ = [Pose(rotation, (0.0, 0.0, 0.0)) for rotation in about]
        turns = [turn @ each for turn in turns for each in round_]
    others = tuple(b for b in at_the_end(scene, search.task, body.name) if b.name != body.name)
    held = Placed(body.name, body.pieces, choice.X_WG)
    poses = (choice.X_WG @ turn @ X_OP for turn in turns)
    place = best_place(scene, poses, others, (held,))
    return None if place is None else place.X_WT


def _name_of(search: _Search, plain: str, numbered: str, X_WT: Pose) -> str:
    """Return the name of a location: a known one's, a plain one that is free, or the next one."""
    for name, other in search.locations.items():
        if other == X_WT:
            return name
    if plain not in search.locations:
        return plain
    number = 2
    while f"{numbered}{number}" in search.locations:
        number += 1
    return f"{numbered}{number}"


def _refused(search: _Search, every: Sequence[tuple[Goal, Choice]]) -> Iterator[tuple[str, str]]:
    """Yield the scene's places that look meant for a goal, and do not bring anything there."""
    scene = search.setting.scene
    to_pads = scene.X_FT.inverse() @ scene.robot.gripper.X_FP
    for name, X_WP in _scene_places(search, "", to_pads):
        if name in search.used or name not in scene.locations:
            continue
        for goal, choice in every:
            body = scene.body(choice.body)
            grip = f"{body.name}_grip".lower()
            if grip not in search.locations:
                continue
            X_OP = body.X_WO.inverse() @ search.locations[grip] @ to_pads
            X_WO = X_WP @ X_OP.inverse()
            x, y, z = subtract(X_WO.translation, choice.X_WG.translation)
            if math.hypot(x, y) > NEAR or abs(z) > LEVEL:
                continue
            pair = (grip, search.locations[grip]), (name, scene.locations[name])
            why = failure(search.setting, goal, choice, *pair)
            if why is not None:
                yield name, why
                break
