"""What tests cost: wall and CPU time of each, with every process below them.

A plugin of pytest, loaded by `python -m tests --times`, which prints the table. Processes that
live on, such as browsers and servers, are looked at before and after each test.
"""

import json
import os
import resource
import time
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

FOLDER = "VRTS_TEST_TIMES"  # environment: where workers write
SECONDS = Path(__file__).with_name("seconds.txt")  # of files that take longest
TICKS = os.sysconf("SC_CLK_TCK")
SHOWN = 40
LEAST_S = 0.5  # of files that `seconds.txt` names


class Cost(NamedTuple):
    """Of a test, or of several [s]."""

    wall: float
    here: float  # CPU of the worker
    below: float  # CPU of processes below it

    @property
    def cpu(self) -> float:
        """CPU time of everything."""
        return self.here + self.below

    def plus(self, other: "Cost") -> "Cost":
        """Return the sum."""
        return Cost(self.wall + other.wall, self.here + other.here, self.below + other.below)


def below(process: int) -> float:
    """Return the CPU time of the processes below one, with those that they have waited for [s]."""
    found = 0.0
    for path in Path(f"/proc/{process}/task").glob("*/children"):
        try:
            children = path.read_text().split()
        except OSError:  # ended meanwhile
            continue
        for child in children:
            try:
                fields = Path(f"/proc/{child}/stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            found += sum(map(int, fields[11:15])) / TICKS + below(int(child))
    return found


def now() -> Cost:
    """Return what has been used until now."""
    here = resource.getrusage(resource.RUSAGE_SELF)
    ended = resource.getrusage(resource.RUSAGE_CHILDREN)
    return Cost(
        time.perf_counter(),
        here.ru_utime + here.ru_stime,
        ended.ru_utime + ended.ru_stime + below(os.getpid()),
    )


def difference(before: Cost, after: Cost) -> Cost:
    """Return what was used between two instants."""
    return Cost(*(b - a for a, b in zip(before, after, strict=True)))


@pytest.hookimpl(hookwrapper=True, tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    """Write the cost of a test, of its fixtures too."""
    before = now()
    yield
    row = [item.nodeid, *difference(before, now())]
    with (Path(os.environ[FOLDER]) / str(os.getpid())).open("a", encoding="utf-8") as file:
        file.write(json.dumps(row) + "\n")


def read(folder: Path) -> dict[str, Cost]:
    """Return the cost of each test."""
    rows = (json.loads(line) for path in folder.iterdir() for line in path.open(encoding="utf-8"))
    return {name: Cost(*numbers) for name, *numbers in rows}


def by_file(costs: dict[str, Cost]) -> dict[str, Cost]:
    """Return the cost of each file of tests."""
    found: dict[str, Cost] = defaultdict(lambda: Cost(0.0, 0.0, 0.0))
    for name, cost in costs.items():
        file = name.split("::")[0]
        found[file] = found[file].plus(cost)
    return dict(found)


def table(costs: dict[str, Cost]) -> str:
    """Return the slowest tests, by CPU time, and the sum of all."""
    ranked = sorted(costs.items(), key=lambda item: -item[1].cpu)[:SHOWN]
    rows = ["     CPU    here   below    wall [s]"]
    total = Cost(0.0, 0.0, 0.0)
    for cost in costs.values():
        total = total.plus(cost)
    for name, cost in [*ranked, (f"{len(costs)} tests", total)]:
        rows.append(f"{cost.cpu:8.2f}{cost.here:8.2f}{cost.below:8.2f}{cost.wall:8.2f}  {name}")
    return "\n".join(rows)


def keep(costs: dict[str, Cost]) -> None:
    """Write the seconds of the files that take longest; what was not measured keeps its own.

    They are right where the machine had nothing else to do: look at them before they are committed.
    """
    known = seconds() | {name: cost.wall for name, cost in by_file(costs).items()}
    ranked = sorted(known.items(), key=lambda item: (-round(item[1], 1), item[0]))
    lines = [f"{wall:.1f} {name}\n" for name, wall in ranked if wall >= LEAST_S]
    SECONDS.write_text("".join(lines), encoding="utf-8")


def seconds() -> dict[str, float]:
    """Return the seconds of the files that take longest."""
    if not SECONDS.exists():
        return {}
    lines = SECONDS.read_text(encoding="utf-8").splitlines()
    return {name: float(number) for number, name in (line.split() for line in lines)}
