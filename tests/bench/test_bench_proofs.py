"""What certificates cost: bytes, and the time to check them beside that of the search.

Run with `OMP_NUM_THREADS=1 pytest tests/bench/test_bench_proofs.py -s -p no:xdist`. Times are
processor time, medians of rounds in which search and checker have their turns one after the other,
so that they hold on a busy machine too. Sizes and ratios are asserted.
"""

import statistics
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_forty import forty_objects
from vrts.check.collision.collision import check_collisions
from vrts.check.proof.certificate import certificate_bytes
from vrts.check.proof.checker import check
from vrts.check.proof.record import certified
from vrts.engine.run import Run
from vrts.pipeline.execution import executed
from vrts.pipeline.requesting import request_for

ROUNDS = 9
MOST_TIMES = 1.5  # the checker may take so many times as long as the search
MOST_BYTES = 20_000
EXAMPLES = sorted((ROOT / "examples").glob("0[1-4]*"))


def cost(work: Callable[..., object], *arguments: object) -> float:
    """Return the processor time of some work [ms]."""
    before = time.process_time()
    work(*arguments)
    return 1e3 * (time.process_time() - before)


def run_of(folder: Path) -> Run:
    run = executed(request_for(folder / "solution.v2")).run
    assert run is not None
    return run


@pytest.mark.parametrize("name", [*(folder.name for folder in EXAMPLES), "forty objects, 60 s"])
def test_certificates_are_small_and_checked_as_fast_as_they_are_found(name: str) -> None:
    run = forty_objects() if name.startswith("forty") else run_of(ROOT / "examples" / name)
    report = check_collisions(run.scene, run)
    made = certified(run.scene, run, report)
    size = len(certificate_bytes({}, made.claims, made.evidence))
    search: list[float] = []
    checking: list[float] = []
    for _ in range(ROUNDS):
        again = Run(run.history, run.until_s)  # nothing is remembered of it
        search.append(cost(check_collisions, run.scene, again))
        checking.append(cost(check, run.scene, again, made.claims, made.evidence))
    found, checked = statistics.median(search), statistics.median(checking)
    writing = cost(certified, run.scene, run, report)
    print(
        f"\n{name}: {size:,} bytes, {made.proven.rows:,} pairs, {made.proven.leaves:,} intervals;"
        f" search {found:.1f} ms, checker {checked:.1f} ms ({checked / found:.2f} times),"
        f" writing {writing:.0f} ms"
    )
    assert size <= MOST_BYTES
    assert checked <= MOST_TIMES * found
