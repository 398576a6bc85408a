"""Every check that applies to a run."""

from collections.abc import Sequence

from vrts.check.collision.collision import check_collisions
from vrts.check.collision.corner_hint import corner_hints
from vrts.check.collision.in_words import verdict as collision_verdict
from vrts.check.goals.reached import reached
from vrts.check.judgement import Judgement
from vrts.check.task.task import Task
from vrts.check.verdict import Answer, CollisionReport, Verdict
from vrts.check.verdicts import duration, every_future, limits, targets, via_verdict, vias
from vrts.check.verdicts.demand_check import check_demands
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.geometry.proposing.proposer import Proposer
from vrts.scene.model import Scene


def judge(
    scene: Scene,
    run: Run,
    task: Task | None,
    *,
    collisions: bool = True,
    proposer: Proposer | None = None,
    second: Proposer | None = None,
    report: CollisionReport | None = None,
    also: Sequence[Verdict] = (),
) -> Judgement:
    """Return all verdicts: the program's ending, collisions, limits, and what the task asks for.

    Args:
        scene: What stands where.
        run: What happened in it.
        task: What was asked for; None: nothing.
        collisions: Whether to check them.
        proposer: Helps to prove distances; no answer depends on it. None: the best there is here.
        second: Who is asked for a second opinion about collisions; None: nobody.
        report: What is known about the collisions of the run; None: they are to be checked.
        also: What was found out beside this run, as of every future of the program.
    """
    found: list[Verdict] = [_program(run)]
    if report is not None:
        found.append(collision_verdict(report, run))
    elif collisions:
        near_miss = None if task is None else task.near_miss
        report = check_collisions(scene, run, proposer=proposer, second=second, near_miss=near_miss)
        found.append(collision_verdict(report, run, corner_hints(run, report, proposer)))
    found.append(limits.check_limits(run))
    if task is not None:
        found += targets.verdicts(reached(run, task))
        found += via_verdict.verdicts(run, vias.passed(run, task))
        found.append(duration.verdict(run, task))
        found += check_demands(run, task.demands, proposer)
        found += every_future.verdicts(task, also)
    return Judgement(tuple(found), report)


def _program(run: Run) -> Verdict:
    if run.ending in (Ending.COMPLETED, Ending.HALTED):
        return Verdict("program", Answer.HOLDS, "the program comes to its end")
    return Verdict("program", Answer.VIOLATED, f"the program ends with: {run.ending.value}")
