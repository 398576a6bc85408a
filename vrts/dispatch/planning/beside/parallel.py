"""The same question asked of many things at once, on as many cores as there are.

The answers come in the order of the things, so nothing that is told depends on the number of cores.
"""

import multiprocessing
import sys
import threading
from collections.abc import Callable, Sequence
from typing import TypeVar, cast

T = TypeVar("T")
R = TypeVar("R")

_asked: list[
    tuple[Callable[[object], object], Sequence[object]]
] = []  # in a child: the one question


def answers(ask: Callable[[T], R], things: Sequence[T], jobs: int) -> list[R]:
    """Return the answer for each thing, in their order.

    Children are forks, which see the things without a copy being sent. Where there can be none
    (another system than Linux, or other threads, of which a fork may keep a lock for ever) all is
    answered here.

    Args:
        ask: What is asked of each; its answer is sent between processes.
        things: Of which.
        jobs: Processes at a time, at most.
    """
    jobs = min(jobs, len(things))
    if jobs < 2 or sys.platform != "linux" or threading.active_count() > 1:
        return [ask(thing) for thing in things]
    context = multiprocessing.get_context("fork")
    with context.Pool(jobs, _begin, (ask, things)) as pool:
        return cast("list[R]", pool.map(_answer, range(len(things)), chunksize=1))


def _begin(ask: Callable[[object], object], things: Sequence[object]) -> None:
    _asked.append((ask, things))


def _answer(number: int) -> object:
    ask, things = _asked[0]
    return ask(things[number])
