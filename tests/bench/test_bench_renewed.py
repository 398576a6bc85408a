"""Bringing a class up to date with graders' decisions, without marking: 300 and 1,000 rows.

By hand: `python -m pytest tests/bench/test_bench_renewed.py -s -p no:xdist`. Pages are as long as
those of the first example. "One" is after one decision about one student, "all" after an item, its
points and a comment for everybody, "none" where nothing has changed.
"""

from datetime import UTC, datetime
from pathlib import Path
from time import perf_counter

import pytest

from tests.support_desk import write_desk_class
from vrts.marking.by_hand.decisions.files import add_decisions, read_decisions
from vrts.marking.by_hand.decisions.records import Comment, Decision, Give, Item
from vrts.marking.by_hand.decisions.state import prepared
from vrts.marking.layout import Layout
from vrts.marking.renewing.renewed import renewed
from vrts.marking.submission.report_files import REPORT

LONG = 480_000  # bytes of a page
NOW = datetime(2026, 11, 26, 20, tzinfo=UTC)
NAVIGATION = b'<nav aria-label="On this page"></nav><section id="replay"><p id="L9"></section>'


def lengthened(layout: Layout) -> list[str]:
    """Make pages as long as real ones; return the ids of those who have any."""
    found: list[str] = []
    for place in sorted(layout.root.rglob(REPORT)):
        place.write_bytes(place.read_bytes() + NAVIGATION + b"x" * LONG)
        if place.parent == layout.student(place.parent.name):
            found.append(place.parent.name)
    return found


def took(layout: Layout) -> float:
    """Return what bringing up to date takes [s]."""
    begun = perf_counter()
    renewed(layout)
    return perf_counter() - begun


@pytest.mark.parametrize("count", [300, 1000])
def test_how_long_it_takes(tmp_path: Path, count: int) -> None:
    layout = write_desk_class(tmp_path, count, decisions=False)
    names = lengthened(layout)

    def add(*said: Decision) -> None:
        add_decisions(layout.decisions, "R. Huber", said, NOW)

    took(layout)
    none = took(layout)
    add(Comment(0, "", names[0], "look here", 9, 3.2))
    one = took(layout)
    item = Item(0, "", "comments", "no comments", "-1/2")
    everybody = (Comment(0, "", name, "look here", 9, 3.2) for name in names)
    begun = perf_counter()
    add(item, Give(0, "", "comments", tuple(names), 9), *everybody)
    written = perf_counter() - begun
    every = took(layout)
    begun = perf_counter()
    prepared(read_decisions(layout.decisions))
    read = perf_counter() - begun
    print(
        f"\n{count} rows: none {none:.2f} s, one {one:.2f} s, all {every:.2f} s;"
        f" {len(names) + 2} decisions written in {written:.3f} s, read in {read:.3f} s"
    )
