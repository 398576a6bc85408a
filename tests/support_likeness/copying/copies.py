"""The ten kinds of copies, each with a program that still works."""

from collections.abc import Callable
from random import Random
from typing import NamedTuple

from tests.support_likeness.copying.rebuilding import (
    cut_up,
    loops_changed,
    programs_moved,
    steps_moved,
)
from tests.support_likeness.copying.sheets import Copier, Sheet
from tests.support_likeness.copying.surface import filled, renamed, restyled, shifted
from tests.support_likeness.marking import Mark, mark
from tests.support_likeness.scenes import Job
from tests.support_likeness.students.authors import author

Change = Callable[[Sheet, Copier], bool]
SINGLE: dict[str, Change] = {
    "names": renamed,
    "programs": programs_moved,
    "steps": steps_moved,
    "filler": filled,
    "values": shifted,
    "loops": loops_changed,
    "split": cut_up,
    "layout": restyled,
}
COMBINED, CHAIN, EARLIER = "combined", "chain", "earlier year"
KINDS = (*SINGLE, COMBINED, CHAIN)
DEEP = ("names", "layout")  # what one changes too who wants to hide a copy
LEAST = {COMBINED: 4, EARLIER: 2}  # changes of one copy
TRIES = 8
WITHIN = 1.0  # [points] between a copy and its source


class Copied(NamedTuple):
    """A copy, and how it was made."""

    sheet: Sheet
    changes: tuple[str, ...]
    mark: Mark


def changes_of(kind: str, draw: Random, deep: bool) -> tuple[str, ...]:
    """Return what is changed by a copy of a kind, in order."""
    if kind in (COMBINED, EARLIER, CHAIN):
        count = {COMBINED: draw.choice((3, 4, 5)), EARLIER: 2, CHAIN: 1}[kind]
        others = [one for one in SINGLE if one not in DEEP]
        chosen = draw.sample(others, min(count, len(others)))
    else:
        chosen = [kind]
    if deep or kind == COMBINED:
        chosen += [one for one in DEEP if one not in chosen]
    elif kind in (EARLIER, CHAIN):
        chosen.append(draw.choice(DEEP))
    order = ("loops", "split", "programs", "steps", "values", "filler", "names", "layout")
    return tuple(one for one in order if one in chosen)


def copied(
    source: Sheet, kind: str, job: Job, seed: object, *, deep: bool = False
) -> Copied | None:
    """Return a copy of a kind that earns what its source earns, within a point.

    None: this source cannot be copied so, as one without loops cannot get others.
    """
    wanted = mark(source.text(), job).points
    for attempt in range(TRIES):
        draw = Random(f"copies {seed} {attempt}")
        changes = changes_of(kind, draw, deep)
        sheet = source.copy()
        by = Copier(author(f"copier {seed} {attempt}"), job, draw, 1.0 - attempt / (TRIES + 1))
        done = [name for name in changes if SINGLE[name](sheet, by)]
        if kind in SINGLE and kind not in done:
            return None
        if len(done) < LEAST.get(kind, 1):
            continue
        found = mark(sheet.text(), job)
        if abs(found.points - wanted) <= WITHIN and sheet.text() != source.text():
            return Copied(sheet, tuple(done), found)
    return None
