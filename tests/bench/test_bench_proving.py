"""What proofs cost: by proposer, on the examples, among forty objects, beside posts, of discs.

Run with `OMP_NUM_THREADS=1 pytest tests/bench/test_bench_proving.py -s -p no:xdist`. Times are
processor time of one core, medians of rounds in which every contender has its turn.
"""

import statistics
import time

import pytest

from tests.places import ROOT
from tests.proposers import PROPOSERS
from tests.support_forty import forty_objects
from tests.unit.check.collision.discs import turning
from tests.unit.check.collision.posts import passing
from vrts.check.collision.collision import check_collisions
from vrts.engine.run import Run
from vrts.pipeline.assess import assess
from vrts.pipeline.requesting import request_for

ROUNDS = 7
WITHIN, HARDLY = 5e-3, 1e-4  # [m] near misses of all posts, and of none


def cost(run: Run, by: str, *, near_miss: float | None = None) -> float:
    """Return the processor time of one check [ms]."""
    proposer = PROPOSERS[by]()
    before = time.process_time()
    check_collisions(run.scene, run, proposer=proposer, near_miss=near_miss)
    return 1e3 * (time.process_time() - before)


def test_what_proofs_cost_by_proposer() -> None:
    runs = {"forty objects": forty_objects()}
    for folder in sorted((ROOT / "examples").glob("0[1-4]*")):
        run = assess(request_for(folder / "solution.v2")).run
        assert run is not None
        runs[folder.name] = run
    print()
    for name, run in runs.items():
        spent: dict[str, list[float]] = {by: [] for by in PROPOSERS}
        for _ in range(ROUNDS):
            for by, own in spent.items():
                own.append(cost(run, by))
        usual = statistics.median(spent["coal"])
        shares = (f"{by} {statistics.median(own) / usual:.1f}" for by, own in spent.items())
        asked = check_collisions(run.scene, run).statistics["exact distances"]
        print(f"  {name:24s}{usual:7.1f} ms, {asked:5d} questions; of that: {', '.join(shares)}")


@pytest.mark.parametrize("posts", [20, 39])
def test_what_near_misses_cost_beside_the_proof(posts: int) -> None:
    run = passing(2.0, posts)
    spent: dict[float, list[float]] = {WITHIN: [], HARDLY: []}
    for _ in range(ROUNDS):
        for threshold, own in spent.items():
            own.append(cost(run, "coal", near_miss=threshold))
    proof, both = statistics.median(spent[HARDLY]), statistics.median(spent[WITHIN])
    found = len(check_collisions(run.scene, run, near_miss=WITHIN).near_misses)
    print(f"\n  {posts} posts: {proof:.1f} ms; with {found} near misses {both / proof:.1f} times")


def test_what_a_disc_costs_that_turns_beside_a_thing() -> None:
    spent: dict[float, list[float]] = {0.0: [], 1e-5: []}
    for _ in range(ROUNDS):
        for off, own in spent.items():
            scene, run = turning(2e-5, off)
            before = time.process_time()
            check_collisions(scene, run)
            own.append(1e3 * (time.process_time() - before))
    on, beside = (statistics.median(own) for own in spent.values())
    print(
        f"\n  a can that turns 0.02 mm beside a block: {on:.1f} ms;"
        f" 0.01 mm off the axis of its joint: {beside:.1f} ms"
    )
