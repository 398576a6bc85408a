"""Which planted defects are found, which right programs are accused, and what that costs.

    python -m pytest tests/bench/test_bench_planted.py -s -p no:xdist

`STATES=500` before it looks at no more than so many states of each program. Then figures are
printed, and nothing but accusations fails.
"""

import json
import os
from pathlib import Path
from time import monotonic
from typing import NamedTuple

from tests.support_commands import vrts_text
from tests.support_planted import UNBOUNDED, Planted, outcome, planted

WANTED = 57 / 60  # of the defects that can be shown
CLASSES = {
    "T": "timing",
    "I": "inputs",
    "A": "answers, numbers",
    "P": "two programs",
    "O": "stops, speeds, again",
    "Q": "properties",
    "S": "sown later",
    "N": "analog inputs",
    "R": "right programs",
}
OUTCOMES = ("found", "held", "open", "undetermined", "missed", "accused")
STATES = os.environ.get("STATES")


class Row(NamedTuple):
    """A program, and what became of it."""

    one: Planted
    outcome: str
    took_s: float
    states: int


def test_planted_defects_by_class(tmp_path: Path) -> None:
    """Prints programs by class and outcome, with the time and states that they took."""
    vrts_text("prove", *planted()[0].written(tmp_path))  # so that everything is loaded
    rows = [row(one, tmp_path / one.name) for one in planted()]
    print("\n" + table(rows))
    for one in rows:
        if one.outcome in ("undetermined", "missed", "accused"):
            print(f"{one.outcome}: {one.one.name} {one.one.title}")
    shown = [one for one in rows if not one.one.is_right and one.one.expected != UNBOUNDED]
    found = sum(one.outcome == "found" for one in shown)
    accused = sum(one.outcome == "accused" for one in rows)
    right = sum(one.one.is_right for one in rows)
    print(f"{found} of {len(shown)} defects found, {accused} of {right} right programs accused")
    assert accused == 0
    assert STATES is not None or found >= WANTED * len(shown)


def row(one: Planted, folder: Path) -> Row:
    """Prove a program."""
    folder.mkdir()
    few = () if STATES is None else ("--states", STATES)
    began = monotonic()
    shown = vrts_text("prove", *one.written(folder), *few, "--format", "json", cwd=folder)
    took_s = monotonic() - began
    told = json.loads(shown.stdout)
    return Row(one, outcome(one, told), took_s, told["covered"]["states"])


def table(rows: list[Row]) -> str:
    """Return a line for each class, and one for all."""
    lines = [f"{'':22}{''.join(f'{name:>14}' for name in OUTCOMES)}    states     s  slowest"]
    for letter, name in CLASSES.items():
        lines.append(line(name, [one for one in rows if one.one.name.startswith(letter)]))
    lines.append(line("all", rows))
    return "\n".join(lines)


def line(name: str, rows: list[Row]) -> str:
    """Return the figures of some programs."""
    counts = "".join(f"{sum(r.outcome == one for r in rows) or '.':>14}" for one in OUTCOMES)
    slowest = max(rows, key=lambda r: r.took_s)
    total_s, states = sum(r.took_s for r in rows), sum(r.states for r in rows)
    return f"{name:22}{counts}{states:10}{total_s:6.1f}  {slowest.one.name} {slowest.took_s:.1f} s"
