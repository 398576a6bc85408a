"""The run of a live session as marking looks at it: what counts as its time, and its end.

People think, talk and take turns between one command and the next, so the time of a session is
that in which a program executes, or arm or hand move. It is judged as it stands in the end, or when
that time reaches the longest one of the task.
"""

import math
from collections.abc import Iterable
from dataclasses import replace
from itertools import chain
from typing import TypeAlias

from vrts.engine.memory.events import ProgramEnded, ProgramProgressed, ProgramStarted
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run

Interval: TypeAlias = tuple[float, float]


def session_run(run: Run, longest_s: float) -> Run:
    """Return the run of a session as it is judged.

    Its `started_s` is so long before its `ended_s` as something was done all together.

    Args:
        run: Of the session.
        longest_s: The longest time of the task.
    """
    busy = _joined(chain(_programs(run), _motions(run)), run.horizon_s)
    history, done_s = run.history, 0.0
    for start_s, end_s in busy:
        if done_s + (end_s - start_s) > longest_s:
            cut_s = start_s + (longest_s - done_s)
            robot = history.robot._replace(ending=Ending.LIMIT)
            over = replace(history, started_s=cut_s - longest_s, ended_s=None, robot=robot)
            return Run(over, cut_s)
        done_s += end_s - start_s
    end_s = busy[-1][1] if busy else 0.0
    ended_s = None if history.robot.ending is Ending.RUNNING else end_s
    return Run(replace(history, started_s=end_s - done_s, ended_s=ended_s), run.horizon_s)


def _joined(intervals: Iterable[Interval], horizon_s: float) -> list[Interval]:
    """Return intervals up to a time, in order, those that touch as one."""
    found: list[Interval] = []
    for start_s, end_s in sorted(intervals):
        end_s = min(end_s, horizon_s)
        if start_s >= end_s:
            continue
        if found and start_s <= found[-1][1]:
            found[-1] = (found[-1][0], max(found[-1][1], end_s))
        else:
            found.append((start_s, end_s))
    return found


def _motions(run: Run) -> Iterable[Interval]:
    for segment in run.timeline.segments:
        if segment.motion is not None:
            yield segment.start_s, segment.end_s
    for stroke in run.history.hand.strokes:
        yield stroke.start_s, stroke.end_s


def _programs(run: Run) -> Iterable[Interval]:
    """Return when the robot program executed, single instructions too."""
    since_s = math.nan  # not executing
    for event in run.events:
        if not isinstance(event, ProgramStarted | ProgramProgressed | ProgramEnded):
            continue
        if event.process:
            continue
        if isinstance(event, ProgramEnded):
            executes = False
        else:
            executes = isinstance(event, ProgramStarted) or event.running
        if executes and math.isnan(since_s):
            since_s = event.time_s
        elif not executes and not math.isnan(since_s):
            yield since_s, event.time_s
            since_s = math.nan
    if not math.isnan(since_s):
        yield since_s, run.horizon_s
