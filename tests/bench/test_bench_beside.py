"""What it is worth to certify motion in a worker while the search goes on, in pairs.

Run by hand: `python -m pytest tests/bench/test_bench_beside.py -s -p no:xdist`.

The processor time of the process that searches is about what a proof takes where nothing else is
done on the machine: with other work on it the clock says little.
"""

import subprocess
import sys
from pathlib import Path
from statistics import median

import pytest

from tests.bench.test_bench_prove import MOVES, STOPS, example
from tests.places import ROOT
from tests.support_planted import planted
from tests.unit.prove.explore.test_beside import TURNS

PAIRS = 3
PROVES = """
import os, resource, sys, time
from click.testing import CliRunner
from vrts.base.workers import Workers
from vrts.cli.main import vrts
from vrts.prove.asking import Here

CliRunner().invoke(vrts, ["prove", "--help"])  # so that much is loaded
if sys.argv[1] == "here":
    Workers.beside = lambda self, ask, thing: Here(ask, thing)
clock_s, before = time.perf_counter(), os.times()
words = ["prove", *sys.argv[3:], "--jobs", sys.argv[2], "--format", "json"]
found = CliRunner().invoke(vrts, words)
after = os.times()
print(
    time.perf_counter() - clock_s,
    after.user + after.system - before.user - before.system,
    after.children_user + after.children_system,
    resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024,
    hash(found.stdout),
)
"""
TEXTS = {
    "turns": ".PROGRAM main()\n" + TURNS.format(6) + "\n.END\n",
    "moves": MOVES + STOPS,
    "example 01": example(reaction=True),
}
WAYS = [("1", "here"), ("2", "here"), ("2", "beside")]


def words_of(name: str, folder: Path) -> list[str]:
    """Write a program; return the arguments of `vrts prove`."""
    if name not in TEXTS:
        return next(one for one in planted() if one.name == name).written(folder)
    path = folder / "program.v2"
    path.write_text(TEXTS[name])
    return [str(path), *(("--scene", "cans-on-bases") if name == "example 01" else ())]


@pytest.mark.parametrize("name", ["turns", "T04", "O01", "moves", "example 01"])
def test_certified_beside_the_search(name: str, tmp_path: Path) -> None:
    """Prints the medians of one job, of two without it, and of two with it; the same is told."""
    words = words_of(name, tmp_path)
    took: dict[tuple[str, str], list[list[float]]] = {way: [] for way in WAYS}
    told: set[float] = set()
    for _ in range(PAIRS):
        for (jobs, where), rows in took.items():
            ran = subprocess.run(
                [sys.executable, "-c", PROVES, where, jobs, *words],
                capture_output=True,
                check=True,
                cwd=ROOT,
                env={"PYTHONHASHSEED": "0", "PATH": "/usr/bin:/bin"},
            )
            *row, what = map(float, ran.stdout.split())
            rows.append(row)
            told.add(what)
    print(f"\n{name}")
    for (jobs, where), rows in took.items():
        clock_s, own_s, workers_s, peak_mb = map(median, zip(*rows, strict=True))
        print(
            f"  --jobs {jobs}, certified {where:6}: {own_s:.2f} s of processor time here,"
            f" {workers_s:.2f} s in workers ({peak_mb:.0f} MB); by the clock {clock_s:.2f} s"
        )
    assert len(told) == 1
