"""A class of 300: marking with pages and recordings, without, and a cold process for each.

A 60 s task among 40 objects, two of five submissions with contacts, two processes. Run by hand:
`python -m pytest tests/bench/test_bench_marking.py -s`. Other work on the machine makes wall times
longer; processor times tell what marking itself takes.
"""

import resource
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

import pytest

from tests.bench.usual import scaled, slowness
from tests.support_class import TASK, entries
from vrts.marking.layout import Layout
from vrts.marking.marking import Done, Entry, mark_class
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place

COUNT, JOBS = 300, 2
RESULTS_S, FULL_S = 27.0, 54.0  # asked of 300 on two free cores of a usual machine
SAMPLE = 6  # of the cold processes
VRTS = Path(sys.executable).parent / "vrts"
MEMORY = 600_000_000  # bytes that a process may use
EXAMPLES = Path(__file__).parents[2] / "examples"
MOST_MARK = 10.0
CONTACTS = 0.3  # share of submissions that touch something


class Spent(NamedTuple):
    """What work took, in all processes [s]."""

    wall: list[float]
    processor: list[float]


@contextmanager
def measured() -> Generator[Spent]:
    """Measure a block."""
    spent = Spent([], [])
    begin, used = time.perf_counter(), _processor()
    yield spent
    spent.wall.append(time.perf_counter() - begin)
    spent.processor.append(_processor() - used)


def _processor() -> float:
    usages = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(usage.ru_utime + usage.ru_stime for usage in usages)


def told(name: str, spent: Spent, count: int) -> float:
    """Print what marking took, and return the processor time of one submission [s]."""
    wall, processor = spent.wall[0], spent.processor[0]
    print(
        f"\n{name}: {count} in {wall:.1f} s wall, {processor:.1f} s processor"
        f" ({1e3 * processor / count:.0f} ms each, {processor / JOBS:.1f} s on {JOBS} free cores)",
        end="",
    )
    return processor / count


def marked(out: Path, wanted: Wanted) -> tuple[Spent, list[Done]]:
    """Mark the class."""
    with measured() as spent:
        marker = Marker(Place(str(TASK)), wanted)
        done = list(mark_class(marker, tuple(entries(COUNT)), Layout(out), jobs=JOBS))
    return spent, done


@pytest.mark.parametrize("full", [False, True], ids=["results", "pages-and-recordings"])
def test_a_class_of_300(tmp_path: Path, full: bool) -> None:
    name = "pages and recordings" if full else "results only"
    before = slowness()
    spent, done = marked(tmp_path / "out", Wanted(pages=full, recordings=full))
    slow = before, slowness()
    each = told(name, spent, COUNT)
    asked = FULL_S if full else RESULTS_S
    print("", scaled(f"  300, {name}", spent.processor[0] / JOBS, asked, slow), sep="\n", end="")
    touching = sum(bool(one.result.metrics.contacts) for one in done)
    peak = max(one.peak for one in done)
    size = sum(path.stat().st_size for path in (tmp_path / "out").rglob("*.*") if path.is_file())
    print(
        f"\n  with contacts {touching}, largest process {peak / 1e6:.0f} MB,"
        f" slowest {max(one.seconds for one in done):.2f} s, written {size / 1e6:.0f} MB",
        end="",
    )
    assert len(done) == COUNT
    assert touching >= CONTACTS * COUNT
    assert 0 < peak <= MEMORY
    with measured() as cold:
        for entry in entries(SAMPLE):
            program = tmp_path / entry.title
            assert entry.data is not None
            program.write_bytes(entry.data)
            more = ["-o", tmp_path / entry.identifier, "--recordings"] if full else []
            words = [VRTS, "grade", TASK, program, "--jobs", "1", *more]
            subprocess.run([str(word) for word in words], check=True, capture_output=True)
    alone = told("a cold process each", cold, SAMPLE)
    wall = cold.wall[0] / SAMPLE
    print(
        f"\n  ratio: {alone / each:.1f} in processor time;"
        f" {wall * COUNT / spent.wall[0]:.1f} in wall time against {JOBS} processes"
    )


@pytest.mark.parametrize("example", ["01-cans-on-bases", "04-final-project"])
def test_a_class_with_what_would_mend_it(tmp_path: Path, example: str) -> None:
    """What `--mend` costs, what it finds, and that nobody's mark or page depends on it."""
    folder = EXAMPLES / example
    files = sorted((folder / "submissions").glob("*.v2"))
    each = tuple(Entry(path.stem, path.name, path.read_bytes()) for path in files)
    plain: dict[str, bytes] = {}
    for executions in (0, 100, 300):
        layout = Layout(tmp_path / f"mend-{executions}")
        wanted = Wanted(pages=True, mending=executions)
        with measured() as spent:
            marker = Marker(Place(str(folder)), wanted)
            done = list(mark_class(marker, each, layout, jobs=JOBS))
        told(f"{example}, --mend {executions}", spent, len(each))
        found = [one.result.mending for one in done if one.result.mending is not None]
        full = [one for one in found if one.mark == MOST_MARK]
        causes = Counter(one.cause for one in found).most_common(3)
        print(f"\n  {len(full)} of {len(each)} one change from the full mark; {causes}", end="")
        students = {
            str(path.relative_to(layout.student(entry.identifier).parent)): path.read_bytes()
            for entry in each
            for path in sorted(layout.student(entry.identifier).rglob("*"))
            if path.is_file()
        }
        plain = plain or students
        assert students == plain, "what students get does not depend on it"
        assert bool(found) == (executions > 0)
