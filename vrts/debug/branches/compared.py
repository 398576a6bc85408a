"""Two futures side by side: mark, clearance, time, and where points are lost."""

from collections.abc import Iterator
from itertools import zip_longest
from typing import NamedTuple

from vrts.base.remembered import Memory
from vrts.base.units import mm
from vrts.check.judge import judge
from vrts.check.mark.mark import grade
from vrts.check.task.task import Task
from vrts.debug.branches.tree import Branch
from vrts.report.plain import one_line

WIDE = 34  # characters of a column


class Known(NamedTuple):
    """What is compared of a future."""

    mark: str
    clearance: str
    time: str
    ends: str
    lost: tuple[str, ...]


def rows(one: Branch, other: Branch, task: Task | None, memory: Memory) -> list[str]:
    """Return two branches as a table of text.

    Args:
        one: A branch.
        other: Another one, or the same.
        task: What is asked for; its public checks make the mark. None: there is no mark.
        memory: What was worked out for these runs before.
    """
    with memory.in_use():
        first, second = known(one, task), known(other, task)
    found = [_row("", one.label, other.label)]
    if task is not None:
        found.append(_row("mark", first.mark, second.mark))
    found.append(_row("clearance", first.clearance, second.clearance))
    found.append(_row("time", first.time, second.time))
    found.append(_row("ends", first.ends, second.ends))
    for a, b in zip_longest(first.lost, second.lost, fillvalue=""):
        found += _wrapped("lost", a, b)
    return found


def known(branch: Branch, task: Task | None) -> Known:
    """Return what is compared of a branch, worked out anew."""
    run = branch.run
    judgement = judge(run.scene, run, task)
    report = judgement.collisions
    assert report is not None
    near = report.clearance
    touches = len(report.contacts)
    clear = (
        f"{touches} contact{'s' * (touches > 1)}"
        if touches
        else "-"
        if near is None
        else f"{mm(near.distance_m):.1f} mm at {near.time_s:.3f} s"
    )
    marked = None if task is None else grade(task, run, judgement)
    mark = "" if marked is None else f"{float(marked.mark):g} of {float(marked.total):g}"
    lost = (
        ()
        if marked is None
        else tuple(f"{float(loss.points):g}: {one_line(loss.sentence)}" for loss in marked.losses)
    )
    ended = run.horizon_s if run.ended_s is None else run.ended_s
    return Known(mark, clear, f"{ended - run.started_s:.3f} s", run.ending.value, lost)


def _row(title: str, one: str, other: str) -> str:
    return f"{title:10} {one:{WIDE}} {other}".rstrip()


def _wrapped(title: str, one: str, other: str) -> Iterator[str]:
    for k, (a, b) in enumerate(zip_longest(_pieces(one), _pieces(other), fillvalue="")):
        yield _row(title if k == 0 else "", a, b)


def _pieces(text: str) -> list[str]:
    """Return a text in lines that fit into a column."""
    found = [""]
    for word in text.split():
        if len(found[-1]) + len(word) >= WIDE and found[-1]:
            found.append("")
        found[-1] = f"{found[-1]} {word}".strip()[: WIDE - 1]
    return found
