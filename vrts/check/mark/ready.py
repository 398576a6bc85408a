"""Whatever makes a careful operator stop: one list of what speaks against the real robot.

The mark, the first screen, pages, editors, `dispatch plan` and `choose` all go by it.
"""

from collections.abc import Iterator, Sequence
from enum import Enum
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.check.goals.reached import Reached, reached
from vrts.check.judgement import Judgement
from vrts.check.mark.grade import NOT_CHECKED, REVIEW
from vrts.check.mark.losses import Mishap, mishaps_of, stopped_by, where
from vrts.check.task.demands import DEMAND
from vrts.check.task.task import Task
from vrts.check.verdict import Answer
from vrts.check.verdicts.limits import LIMITS
from vrts.check.verdicts.targets import describe
from vrts.check.verdicts.vias import Passed, passed
from vrts.engine.hand.told import CLOSED_ON_NOTHING, TOPPLED
from vrts.engine.memory.events import Found
from vrts.engine.run import Run


class Kind(Enum):
    """What an obstacle is about."""

    LIMIT = "a limit of the robot is broken"
    CONTACT = "something is touched"
    DROP = "an object is let go in the air"
    STOPPED = "the program does not come to its own end"
    GRIP = "the hand closes on nothing"
    TOPPLED = "an object cannot stand where it is let go"
    DEMAND = "a demand of the task is not kept"
    GOAL = "a goal is not reached"
    VIA = "a via point is not passed"
    DOUBT = "a check cannot tell"
    ENGINES = "two engines disagree"
    UNCHECKED = "collisions were not looked for"
    LOST_STEP = "a step is never carried out, though it looks like one"
    UNKNOWN_PLACE = "a location has no values: what the controller has there is used"


SAID = {"V238": Kind.LOST_STEP, "V204": Kind.UNKNOWN_PLACE}  # by the compiler


class Obstacle(NamedTuple):
    """One thing that speaks against the real robot."""

    kind: Kind
    sentence: str


class Asked(NamedTuple):
    """What a task asks for, and how far it was met."""

    goals: tuple[Reached, ...]
    points: Passed


def obstacles(
    run: Run,
    judgement: Judgement,
    asked: Asked | None = None,
    said: Sequence[Diagnostic] = (),
) -> tuple[Obstacle, ...]:
    """Return what speaks against the real robot, most serious first; nothing if it is ready.

    Args:
        run: What the program does.
        judgement: Of this run.
        asked: How far the goals of a task were met; None without a task.
        said: What reading and compiling the program said.
    """
    found = [
        *_limits(judgement),
        *(_of_mishap(mishap) for mishap in mishaps_of(run, judgement)),
        *_ending(run),
        *_hand(run),
        *_verdicts(judgement),
        *(() if asked is None else _asked(asked)),
        *_doubts(judgement),
        *_of_compiler(said),
    ]
    return tuple(found)


def of_task(task: Task, run: Run) -> Asked:
    """Return how far a run meets the goals of a task."""
    return Asked(reached(run, task), passed(run, task))


def _limits(judgement: Judgement) -> Iterator[Obstacle]:
    for verdict in judgement.verdicts:
        if verdict.check == LIMITS and verdict.answer is Answer.VIOLATED:
            yield Obstacle(Kind.LIMIT, verdict.summary)


def _of_mishap(mishap: Mishap) -> Obstacle:
    kind = Kind.DROP if mishap.event is None else Kind.CONTACT
    return Obstacle(kind, mishap.loss.sentence)


def _ending(run: Run) -> Iterator[Obstacle]:
    stopped = stopped_by(run)
    if stopped is not None:
        yield Obstacle(Kind.STOPPED, stopped.sentence)


def _hand(run: Run) -> Iterator[Obstacle]:
    """Yield grips that fail, but for a hand that is closed before the arm has moved."""
    first_s = min((motion.start_s for motion in run.motions), default=0.0)
    kinds = {CLOSED_ON_NOTHING: Kind.GRIP, TOPPLED: Kind.TOPPLED}
    for event in run.events:
        if not isinstance(event, Found) or event.diagnostic.rule not in kinds:
            continue
        kind = kinds[event.diagnostic.rule]
        if kind is Kind.GRIP and event.time_s <= first_s:
            continue
        sentence = f"{where(event.time_s, event.cause)}, {event.diagnostic.headline}"
        yield Obstacle(kind, sentence)


def _verdicts(judgement: Judgement) -> Iterator[Obstacle]:
    for verdict in judgement.verdicts:
        if verdict.check.startswith(DEMAND) and verdict.answer is Answer.VIOLATED:
            yield Obstacle(Kind.DEMAND, verdict.summary)
        if verdict.answer is Answer.UNDETERMINED:
            yield Obstacle(Kind.DOUBT, f"{REVIEW}: {verdict.check}: {verdict.summary}")


def _asked(asked: Asked) -> Iterator[Obstacle]:
    for result in asked.goals:
        if result.share < 1:
            yield Obstacle(Kind.GOAL, f"`{result.body}` {describe(result)}")
    missed = len(asked.points.met) - asked.points.number
    if missed:
        words = "1 via point is" if missed == 1 else f"{missed} via points are"
        yield Obstacle(Kind.VIA, f"{words} not passed")


def _doubts(judgement: Judgement) -> Iterator[Obstacle]:
    report = judgement.collisions
    if report is None:
        yield Obstacle(Kind.UNCHECKED, NOT_CHECKED)
        return
    for words in report.disagreements:
        yield Obstacle(Kind.ENGINES, f"{REVIEW}: two engines disagree: {words}")


def _of_compiler(said: Sequence[Diagnostic]) -> Iterator[Obstacle]:
    for diagnostic in said:
        kind = SAID.get(diagnostic.rule.code)
        if kind is not None:
            label = diagnostic.primary
            line = "" if label is None else f"line {label.span.line}, "
            yield Obstacle(kind, f"{line}{diagnostic.headline}")
