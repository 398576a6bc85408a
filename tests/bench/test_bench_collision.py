"""What the certified collision check costs, and what samplers cost on the same program.

Run with `OMP_NUM_THREADS=1 pytest tests/bench/test_bench_collision.py -s`. Times are processor time
of one core, medians of rounds in which every contender has its turn, so that they hold on a busy
machine too. Figures that depend on the machine are printed, ratios are asserted.
"""

import cProfile
import pstats
import statistics
import time
from collections.abc import Callable

import numpy as np

from tests.bench.samplers import fcl_sampler, trimesh_sampler
from tests.support_forty import forty_objects
from vrts.check.collision.collision import check_collisions
from vrts.check.curves.timeline_arrays import curves
from vrts.check.verdict import CollisionReport
from vrts.engine.run import Run
from vrts.geometry.proposing.nobody import Nobody

ROUNDS = 11
CONTACTS_MS, CLEARANCE_MS = 40.0, 80.0  # asked for
SHARES = {  # function that stands for a part of the work: what that is
    ("curves.py", "curves"): "timeline as arrays (numpy)",
    ("pairs.py", "plan"): "pairs and their rules (Python, distances)",
    ("broad.py", "gaps"): "bounds of all first intervals (numpy)",
    ("search.py", "_step"): "halving (numpy, proofs)",
    ("teller.py", "touches"): "times and depths of contacts",
    ("prover.py", "proposed"): "of all that: proposals, and what they prove",
    ("prover.py", "searched_for"): "of all that: our own search for directions and points",
}


def cost(work: Callable[..., object], *arguments: object) -> float:
    """Return the processor time of some work [ms]."""
    before = time.process_time()
    work(*arguments)
    return 1e3 * (time.process_time() - before)


def test_a_program_of_60_seconds_among_40_objects() -> None:
    run = forty_objects()
    motion = curves(run.timeline.segments)
    peers = {"trimesh": trimesh_sampler(run, motion), "python-fcl": fcl_sampler(run, motion)}
    every_20_ms = np.arange(0.0, run.horizon_s, 0.02)
    every_1_ms = every_20_ms + 0.007  # one instant in twenty, the same share of every motion
    parts = np.array_split(every_20_ms, ROUNDS), np.array_split(every_1_ms, ROUNDS)
    certified: dict[str, list[float]] = {"contacts": [], "clearance": [], "contacts, own": []}
    sampled = {f"{name} {step}": 0.0 for name in peers for step in ("20 ms", "1 ms")}
    report = check_collisions(run.scene, run)
    checked(run, report)
    checked(run, check_collisions(run.scene, run, proposer=Nobody()))
    for turn in range(ROUNDS):
        certified["contacts"].append(
            cost(lambda: check_collisions(run.scene, run, clearance=False))
        )
        certified["clearance"].append(cost(lambda: check_collisions(run.scene, run)))
        certified["contacts, own"].append(
            cost(lambda: check_collisions(run.scene, run, clearance=False, proposer=Nobody()))
        )
        for name, sampler in peers.items():
            sampled[f"{name} 20 ms"] += cost(sampler, parts[0][turn])
            sampled[f"{name} 1 ms"] += 20.0 * cost(sampler, parts[1][turn])
    contacts, clearance, by_own = (statistics.median(own) for own in certified.values())
    print(
        f"\n{run.horizon_s:.1f} s, {len(run.timeline.segments)} segments, "
        f"{len(run.scene.bodies)} bodies with the floor, {dict(report.statistics)}\n"
        f"  certified contacts          {contacts:8.1f} ms (asked {CONTACTS_MS:.0f}), "
        f"{1e3 * run.horizon_s / contacts:.0f} x real time\n"
        f"  and clearance to 0.1 mm     {clearance:8.1f} ms (asked {CLEARANCE_MS:.0f})\n"
        f"  certified contacts, unaided {by_own:8.1f} ms"
    )
    for name, spent in sampled.items():
        how = "one instant in 20, times 20" if name.endswith(" 1 ms") else "all instants"
        print(f"  sampler {name:20s}{spent:8.0f} ms ({how}): {spent / contacts:.0f} x")
    if contacts > CONTACTS_MS or clearance > CLEARANCE_MS:
        print(shares(run))
    for name, spent in sampled.items():
        assert spent >= (100.0 if name.endswith(" 1 ms") else 8.0) * contacts, name


def checked(run: Run, report: CollisionReport) -> None:
    """Assert what is known of the program."""
    assert run.horizon_s > 59.0
    assert report.certified
    assert not report.contacts
    assert report.clearance is not None
    assert abs(report.clearance.distance_m - 5.72e-3) < 1.5e-4 + report.clearance.tolerance_m


def shares(run: Run) -> str:
    """Return where the time goes."""
    profile = cProfile.Profile(time.process_time)
    profile.enable()
    for _ in range(ROUNDS):
        check_collisions(run.scene, run)
    profile.disable()
    stats = pstats.Stats(profile).stats  # pyright: ignore[reportAttributeAccessIssue, reportUnknownMemberType, reportUnknownVariableType]
    rows: list[tuple[str, str, float]] = [
        (file.rsplit("/", 1)[-1], name, float(own[3]))  # pyright: ignore[reportUnknownMemberType, reportUnknownArgumentType]
        for (file, _, name), own in stats.items()  # pyright: ignore[reportUnknownMemberType, reportUnknownVariableType]
    ]
    whole = next(spent for _, name, spent in rows if name == "check_collisions")
    lines = ["  where the time goes, under the profiler:"]
    for (file, function), what in SHARES.items():
        spent = sum(s for f, name, s in rows if (f, name) == (file, function))
        lines.append(f"    {100 * spent / whole:5.1f} %  {what}")
    return "\n".join(lines)
