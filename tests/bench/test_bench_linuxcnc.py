"""Rehearsals on LinuxCNC: how near it is on every program, and a hundred of them in a row."""

import os
import tempfile
import time
from pathlib import Path

import pytest

from tests.unit.dispatch.rehearsing.test_rehearsals import CASES, Case, rehearsed
from vrts.dispatch.rehearsing.installed import installed
from vrts.dispatch.rehearsing.rehearse import Rehearsal

RUNS = int(os.environ.get("VRTS_REHEARSALS", "100"))
WHAT = installed()
pytestmark = pytest.mark.skipif(isinstance(WHAT, str), reason="needs LinuxCNC")


def once(case: Case) -> tuple[Rehearsal, float]:
    """Return a rehearsal in a folder of its own, and the seconds that it took."""
    assert not isinstance(WHAT, str)
    begun = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        return rehearsed(case, Path(folder), WHAT), time.perf_counter() - begun


def figures(found: Rehearsal) -> str:
    """Return the worst of each kind of stretch."""
    parts: list[str] = []
    for rounded, kind in ((False, "stops"), (True, "rounded")):
        chosen = [s for s in found.stretches if s.rounded is rounded and not s.missing]
        if chosen:
            parts.append(
                f"{len(chosen):2} {kind} {max(s.path_mm for s in chosen):.4f}"
                f" {max(s.equal_mm for s in chosen):.4f} {max(s.end_mm for s in chosen):.4f} mm"
                f" {1e3 * max(abs(s.longer_s) for s in chosen):.2f} ms"
            )
    return "; ".join(parts)


def test_how_near_linuxcnc_is_on_every_program() -> None:
    print("\npath, equal time, end [mm], duration [ms]")
    for case in CASES:
        found, took = once(case)
        print(f"{case.name:34} {took:5.1f} s  {figures(found)}", flush=True)
        assert found.holds, [d.headline for d in found.diagnostics]


def test_a_hundred_in_a_row() -> None:
    failed: list[str] = []
    worst = 0.0
    for k in range(RUNS):
        case = CASES[k % len(CASES)]
        found, _ = once(case)
        worst = max(worst, *(s.equal_mm for s in found.stretches), 0.0)
        if not found.holds:
            failed.append(f"{case.name}: {[d.headline for d in found.diagnostics]}")
            print(failed[-1], flush=True)
    print(f"\n{RUNS - len(failed)} of {RUNS} held; farthest at equal times {worst:.3f} mm")
    assert not failed
