"""What a task asks for, judged where futures end: the first of those that leave parts alike."""

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from vrts.check.goals.reached import reached
from vrts.check.task.task import Task
from vrts.check.verdict import Answer, Verdict
from vrts.check.verdicts import targets, via_verdict, vias
from vrts.check.verdicts.demand_check import check_demands
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.prove.graph.past import story
from vrts.prove.graph.suspects import End, Suspect
from vrts.prove.proof import What, Wrong

MOST_ENDS = 200  # that are replayed


class Missed(NamedTuple):
    """Something that a task asks for and a run does not do, or nobody can tell."""

    wrong: Wrong
    verdict: Verdict
    time_s: float


def missed(run: Run, task: Task) -> Iterator[Missed]:
    """Yield what a run misses of what a task asks for; what no one can tell is among it.

    How long it takes is not asked: it waits for what comes from outside.
    """
    if run.ending not in (Ending.COMPLETED, Ending.HALTED):
        return
    task = replace(task, t_max=run.horizon_s)
    asked = [
        *((Wrong.GOAL, verdict) for verdict in targets.verdicts(reached(run, task))),
        *((Wrong.GOAL, one) for one in via_verdict.verdicts(run, vias.passed(run, task))),
        *((Wrong.DEMAND, verdict) for verdict in check_demands(run, task.demands)),
    ]
    for wrong, verdict in asked:
        if verdict.answer is not Answer.HOLDS:
            moment = next((one.moment for one in verdict.findings if one.moment), None)
            ended_s = run.horizon_s if run.ended_s is None else run.ended_s
            yield Missed(wrong, verdict, ended_s if moment is None else moment.time_s)


def is_asked(end: End) -> bool:
    """Return whether a task's goals are asked for: nobody stopped it, and no part was missing."""
    spoilt = (What.STOP, What.AGAIN, What.GRIP)
    return all(decided.what not in spoilt for decided in story(end.past))


def suspect(end: End, one: Missed) -> Suspect:
    """Return what a replay of an end shows as something to be confirmed and shrunk."""
    check, words = one.verdict.check, one.verdict.summary
    return Suspect(one.wrong, (check,), f"{check}: {words}", one.time_s, None, end.past, end.cost)
