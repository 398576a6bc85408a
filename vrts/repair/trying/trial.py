"""Candidates executed and marked, each as far as it is needed to tell whether it is good.

The order is that of cost: does it compile, does it come to its end without a drop, are the goals
reached, are vias, time and demands kept, and does nothing touch. A candidate that passes is judged
once more by the usual checks: only that counts.
"""

from dataclasses import replace
from enum import IntEnum
from fractions import Fraction
from typing import NamedTuple

from vrts.base.remembered import Memory
from vrts.base.source import SourceFile
from vrts.check.collision.touching import touching
from vrts.check.goals.reached import reached
from vrts.check.judge import judge
from vrts.check.judgement import Judgement
from vrts.check.mark.grade import Grade
from vrts.check.mark.mark import grade
from vrts.check.task.score import divided
from vrts.check.task.task import Task
from vrts.check.verdicts.vias import passed
from vrts.engine.controller import advance, commands_of, start
from vrts.engine.memory.events import Grasped
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.ir.module import Module
from vrts.lang.compiler import Options, compile_source
from vrts.repair.trying.forking import Shared
from vrts.repair.trying.lost import Loss, lost_again, mishaps_of
from vrts.repair.trying.touched import KnownTouch, still_touching
from vrts.repair.written import without_comments
from vrts.scene.model import Scenario, Scene

APART = 1.0  # [s] of simulated time between the states from which candidates go on
STRIDE = 3.0  # [s] of simulated time after which a run is looked at
AFTERWARDS = 10.0  # [s] as the engine gives things to come to rest
HOPELESS = 2  # things dropped, after which it is not worth while to go on
SETTLED = 1.0  # [s] after which what was dropped lies still
STATEMENTS = 20_000  # more than this a candidate may not execute before it is verified
SLACK = Fraction(1, 20)  # of the time in which the bonus falls to nothing: what rounding forgives
ENDED = 0.1  # what it counts for how far a candidate came that it comes to its end
CLEAN = 0.1  # that nothing is dropped or toppled on its way
LINE = 0.001  # and each line that moves something, of one that stops before
HELD = 0.3  # and each thing that was gripped, even if it is dropped then
NOWHERE = -1.0  # how far a candidate comes that loses the same first
VIAS = 0.2  # and all via points, and time, less
TOUCH = 0.05  # and each contact, and each thing dropped, less
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
    come: float = 0.0  # how far it came, to tell progress by: more is farther, of any stage
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


def tried(
    place: Place,
    text: str,
    memory: Memory,
    touches: tuple[KnownTouch, ...] = (),
    base: Shared | None = None,
    same: Loss | None = None,
) -> Tried:
    """Return how far a candidate comes.

    Args:
        place: Where it runs.
        text: The program.
        memory: Motions that others had are not planned again.
        touches: Contacts of the program that it is made from.
        base: The run of that program, to go on from.
        same: What that program loses first: with that lost again nothing is better.
    """
    found = compiled(place, without_comments(text))
    if found is None:
        return Tried(Stage.COMPILES_NOT)
    with memory.in_use():
        return _marked(place, _executed(place, *found, base, same), touches, same)


def _marked(place: Place, run: Run, touches: tuple[KnownTouch, ...], same: Loss | None) -> Tried:
    task = place.task
    if same is not None and lost_again(run, same):
        return Tried(Stage.STOPS, NOWHERE, run=run)
    results = reached(run, task, min(run.started_s + task.t_max, run.ended_s or run.horizon_s))
    total = sum((each.goal.weight for each in results), Fraction(0))
    gained = sum((each.goal.weight * each.share for each in results), Fraction(0))
    gained = gained / total if total else Fraction(1)
    mishaps = len(mishaps_of(run))
    still = still_touching(run, touches)
    come = float(gained) - TOUCH * (mishaps + still)
    come += HELD * len({event.body for event in run.events if isinstance(event, Grasped)})
    if run.ending not in ENDS:
        come += LINE * len({motion.cause.span.line for motion in run.motions})
        return Tried(Stage.STOPS, come, run=run)
    come += ENDED
    if mishaps:
        return Tried(Stage.STOPS, come, run=run)
    come += CLEAN
    if gained < 1:
        return Tried(Stage.GOALS, come, run=run)
    points = passed(run, task).number if _asks_for_vias(task) else 0
    if points < len(task.vias):
        return Tried(Stage.POINTS, come - VIAS * (1.0 - points / len(task.vias)), run=run)
    judgement = judge(place.scene, run, task, collisions=False)
    marked = grade(task, run, judgement)
    if marked.mark < marked.total:
        share = float(marked.mark / marked.total)
        return Tried(Stage.POINTS, come - VIAS * (1.0 - share), marked.mark, run)
    if still:
        return Tried(Stage.TOUCHES, come, run=run)
    found = touching(place.scene, run)
    if found.events:
        return Tried(Stage.TOUCHES, come - TOUCH * found.events, run=run)
    return Tried(Stage.FULL, come, marked.mark, run)


def _asks_for_vias(task: Task) -> bool:
    """Return whether a via point that is missed costs points for certain."""
    _, points = divided(task.mark, targets=bool(task.targets), vias=bool(task.vias))
    return points > 0


def verified(place: Place, module: Module, entry: str) -> Tried:
    """Return what a program earns by the usual run and the usual checks."""
    run = _run(module, place.scene, place.scenario, entry)
    judgement = judge(place.scene, run, place.task)
    marked = grade(place.task, run, judgement)
    full = marked.mark == marked.total
    return Tried(Stage.FULL if full else Stage.TOUCHES, 0.0, marked.mark, run, judgement, marked)


def verified_text(place: Place, text: str) -> Tried:
    """Return the same of a text."""
    found = compiled(place, text)
    return Tried(Stage.COMPILES_NOT) if found is None else verified(place, *found)


def _run(module: Module, scene: Scene, scenario: Scenario, entry: str) -> Run:
    commands = commands_of(scenario, entry)
    horizon = commands[-1].time_s + scenario.limits.time_s + AFTERWARDS
    return advance(start(module, scene, scenario), horizon, commands, closed=True)


def shared(place: Place, text: str, memory: Memory) -> Shared | None:
    """Return the run of a program with the states from which candidates go on; None: from none."""
    found = compiled(place, without_comments(text))
    if found is None or len(commands_of(place.scenario, found[1])) > 1:
        return None
    module, entry = found
    scenario = _hurried(place)
    horizon = scenario.limits.time_s + AFTERWARDS
    with memory.in_use():
        commands = commands_of(scenario, entry)
        runs = [advance(start(module, place.scene, scenario), 0.0, commands, closed=True)]
        while runs[-1].until_s < horizon and runs[-1].ending is Ending.RUNNING:
            runs.append(advance(runs[-1], min(runs[-1].until_s + APART, horizon), closed=True))
    return Shared(runs)


def _hurried(place: Place) -> Scenario:
    """Return a scenario in which a program has no longer than the full mark allows."""
    task, given = place.task, place.scenario.limits
    longest = task.t_max
    if task.mark.time_bonus:
        longest = task.t_par + float(SLACK) * max(task.t_max - task.t_par, 0.0)
    limits = replace(
        given,
        time_s=min(given.time_s, longest),
        statements=min(given.statements, STATEMENTS),
    )
    return replace(place.scenario, limits=limits)


def _executed(
    place: Place, module: Module, entry: str, base: Shared | None, same: Loss | None
) -> Run:
    """Return the run of a candidate, no longer than there is hope."""
    scenario = _hurried(place)
    commands = commands_of(scenario, entry)
    if len(commands) > 1:
        return _run(module, place.scene, scenario, entry)
    horizon = scenario.limits.time_s + AFTERWARDS
    run = None if base is None else base.before(module)
    if run is None:
        run = advance(start(module, place.scene, scenario), STRIDE, commands, closed=True)
    while run.until_s < horizon and run.ending is Ending.RUNNING:
        if len(mishaps_of(run)) >= HOPELESS:
            return advance(run, run.until_s + SETTLED, closed=True)
        if same is not None and lost_again(run, same):
            return run
        run = advance(run, min(run.until_s + STRIDE, horizon), closed=True)
    return advance(run, horizon, closed=True) if run.until_s < horizon else run
