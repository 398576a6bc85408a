"""When the goals of a task are reached, over a whole run: as it would be judged at each moment."""

from itertools import pairwise
from typing import TypeAlias

from vrts.check.goals.reached import judged_at, reached
from vrts.check.task.task import Task
from vrts.engine.run import Run

MOST_TIMES = 400  # at which something comes to lie otherwise, that are looked at
SAME_S = 1e-6  # [s]

Spans: TypeAlias = tuple[tuple[float, float], ...]
"""Starts and ends [s], in order."""


def reached_over_time(run: Run, task: Task) -> tuple[Spans, ...]:
    """Return for each goal, in the order of the task, from when to when it is reached [s].

    Things rest between two moments, or are carried: what is so just after the one is so until the
    next. Of a run with very many such moments only the first ones are looked at, and the last.
    """
    end_s = judged_at(run, task)
    bodies = {body for goal in task.goals for body in goal.bodies}
    starts = {p.start_s for body in bodies for p in run.placements.get(body, ())}
    times = sorted({run.started_s, *(t for t in starts if t < end_s)})[:MOST_TIMES]
    edges = [*times, end_s]
    found: list[list[tuple[float, float]]] = [[] for _ in task.goals]
    for start_s, next_s in pairwise(edges):
        now = reached(run, task, min(start_s + SAME_S, end_s))
        for spans, result in zip(found, now, strict=False):
            if result.share < 1:
                continue
            if spans and spans[-1][1] == start_s:
                spans[-1] = (spans[-1][0], next_s)
            else:
                spans.append((start_s, next_s))
    return tuple(tuple(spans) for spans in found)
