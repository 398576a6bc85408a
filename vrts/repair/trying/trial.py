"""Candidates executed and marked, each as far as it is needed to tell whether it is good.

The order is that of cost: does it compile, does it come to its end without a drop, are the goals
reached, are vias, time and demands kept, and does nothing touch. A candidate that passes is judged
once more by the usual checks: only that counts.
"""

from dataclasses import replace
from enum import IntEnum
from fractions import Fraction
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.check.collision.collision import check_collisions
from vrts.check.goals.reached import reached
from vrts.check.judge import judge
from vrts.check.judgement import Judgement
from vrts.check.mark.grade import Grade
from vrts.check.mark.mark import grade
from vrts.check.task.task import Task
from vrts.engine.controller import advance, commands_of, start
from vrts.engine.hand.told import DROP_HEIGHT
from vrts.engine.memory.events import Released, Toppled
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.ir.module import Module
from vrts.lang.compiler import Options, compile_source
from vrts.repair.written import without_comments
from vrts.scene.model import Scenario, Scene

STRIDE = 3.0  # [s] of simulated time after which a run is looked at
AFTERWARDS = 10.0  # [s] as the engine gives things to come to rest
STATEMENTS = 20_000  # more than this a candidate may not execute before it is verified
SLACK = Fraction(1, 20)  # of the time in which the bonus falls to nothing: what rounding forgives
ENDS = (Ending.COMPLETED, Ending.HALTED)


class Stage(IntEnum):
    """How far a candidate came."""

    COMPILES_NOT = 0
    STOPS = 1  # it stops, drops something, or takes too long
    GOALS = 2  # goals are missed
    POINTS = 3  # vias, time or demands cost points
    TOUCHES = 4
    FULL = 5


class Tried(NamedTuple):
    """What a candidate earns."""

    stage: Stage
    gained: Fraction = Fraction(0)  # how much of the goals is reached, to tell progress by
    mark: Fraction | None = None  # exact where it is good, or was judged without contacts
    run: Run | None = None
    judgement: Judgement | None = None
    grade: Grade | None = None


class Place(NamedTuple):
    """Where candidates run."""

    scene: Scene
    task: Task
    scenario: Scenario
    options: Options
    name: str  # of the file
    entry: str | None = None  # the program asked for by the task, lower case


def compiled(place: Place, text: str) -> tuple[Module, str] | None:
    """Return the module of a text and the program to execute; None where there is none."""
    module = compile_source(SourceFile(place.name, text), place.options).module
    if module is None:
        return None
    entry = place.entry or module.main
    return None if entry is None or entry not in module.programs else (module, entry)


def tried(place: Place, text: str) -> Tried:
    """Return how far a candidate comes."""
    found = compiled(place, without_comments(text))
    if found is None:
        return Tried(Stage.COMPILES_NOT)
    run = _executed(place, *found)
    task = place.task
    results = reached(run, task)
    total = sum((each.goal.weight for each in results), Fraction(0))
    gained = sum((each.goal.weight * each.share for each in results), Fraction(0))
    gained = gained / total if total else Fraction(1)
    if _hopeless(run) or run.ending not in ENDS:
        return Tried(Stage.STOPS, gained, run=run)
    if gained < 1:
        return Tried(Stage.GOALS, gained, run=run)
    judgement = judge(place.scene, run, task, collisions=False)
    marked = grade(task, run, judgement)
    if marked.mark < marked.total:
        return Tried(Stage.POINTS, gained, marked.mark, run)
    report = check_collisions(place.scene, run, clearance=False, near_miss=task.near_miss)
    if report.contacts or report.undetermined:
        return Tried(Stage.TOUCHES, gained, run=run)
    return verified_text(place, text)


def verified(place: Place, module: Module, entry: str) -> Tried:
    """Return what a program earns by the usual run and the usual checks."""
    run = _run(module, place.scene, place.scenario, entry)
    judgement = judge(place.scene, run, place.task)
    marked = grade(place.task, run, judgement)
    full = marked.mark == marked.total
    return Tried(
        Stage.FULL if full else Stage.TOUCHES, Fraction(1), marked.mark, run, judgement, marked
    )


def verified_text(place: Place, text: str) -> Tried:
    """Return the same of a text."""
    found = compiled(place, text)
    return Tried(Stage.COMPILES_NOT) if found is None else verified(place, *found)


def _run(module: Module, scene: Scene, scenario: Scenario, entry: str) -> Run:
    commands = commands_of(scenario, entry)
    horizon = commands[-1].time_s + scenario.limits.time_s + AFTERWARDS
    return advance(start(module, scene, scenario), horizon, commands, closed=True)


def _executed(place: Place, module: Module, entry: str) -> Run:
    """Return the run of a candidate, no longer than there is hope."""
    task, given = place.task, place.scenario.limits
    longest = task.t_max
    if task.mark.time_bonus:
        longest = task.t_par + float(SLACK) * max(task.t_max - task.t_par, 0.0)
    limits = replace(
        given,
        time_s=min(given.time_s, longest),
        statements=min(given.statements, STATEMENTS),
    )
    scenario = replace(place.scenario, limits=limits)
    commands = commands_of(scenario, entry)
    if len(commands) > 1:
        return _run(module, place.scene, scenario, entry)
    horizon = limits.time_s + AFTERWARDS
    run = advance(start(module, place.scene, scenario), STRIDE, commands, closed=True)
    while run.until_s < horizon and run.ending is Ending.RUNNING and not _hopeless(run):
        run = advance(run, min(run.until_s + STRIDE, horizon), closed=True)
    if run.until_s < horizon and not _hopeless(run):
        run = advance(run, horizon, closed=True)
    return run


def _hopeless(run: Run) -> bool:
    """Return whether something happened after which no program has the full mark."""
    return any(
        (isinstance(event, Released) and event.height_m > DROP_HEIGHT) or isinstance(event, Toppled)
        for event in run.events
    )
