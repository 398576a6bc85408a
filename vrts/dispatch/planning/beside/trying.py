"""A program executed and judged in other worlds: what goes wrong in which."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from vrts.base.workers import Workers
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.pairs.pairs import PAD_DEPTH
from vrts.check.judge import judge
from vrts.dispatch.planning.beside.trials import Subject, Trial
from vrts.dispatch.planning.beside.worlds import World, displaced, pushed_to_the_middle
from vrts.dispatch.planning.reasons.proof import Case, obstacles
from vrts.engine.controller import execute


class Failure(NamedTuple):
    """What goes wrong in another world."""

    what: str
    sentence: str


def failures(subject: Subject, trials: Sequence[Trial], workers: Workers) -> Iterator[Failure]:
    """Yield what goes wrong in which world, in their order.

    Args:
        subject: The program.
        trials: The worlds.
        workers: Who looks at worlds.
    """
    found = workers.answers(lambda trial: tried(subject, trial.world), trials)
    for trial, wrong in zip(trials, found, strict=True):
        if wrong:
            yield Failure(trial.what, wrong[0])


def tried(subject: Subject, world: World) -> tuple[str, ...]:
    """Return what speaks against the real robot in another world."""
    off = displaced(world.scene, subject.run)
    wrong = _tried(subject, world, PAD_DEPTH + off)
    if wrong or off == 0.0:
        return wrong
    return _tried(subject, pushed_to_the_middle(world, subject.run), PAD_DEPTH + off)


def _tried(subject: Subject, world: World, pads: float) -> tuple[str, ...]:
    run = execute(subject.module, world.scene, world.scenario, subject.entry)
    report = check_collisions(world.scene, run, clearance=False, pads=pads)
    judgement = judge(world.scene, run, world.task, report=report)
    return obstacles(Case("", run, judgement, world.task))
