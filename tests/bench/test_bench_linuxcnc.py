"""Rehearsals on LinuxCNC: how near it is on every program, and a hundred of them in a row."""

import os
import tempfile
import time
from itertools import pairwise
from pathlib import Path

import pytest

from tests.oracle.urscript.drawn import PUMA560, drawn
from tests.unit.dispatch.rehearsing.test_rehearsals import CASES, Case, rehearsed
from vrts.dispatch.rehearsing.installed import installed
from vrts.dispatch.rehearsing.rehearse import Rehearsal
from vrts.dispatch.verified import Verified, verified
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.pipeline.scenes import free_setting, with_scenario
from vrts.pipeline.where import Where

DRAWN = int(os.environ.get("VRTS_DRAWN", "20"))
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


def test_how_long_waits_by_the_clock_take() -> None:
    """At the speed of the clock, since a faster one makes LinuxCNC's own pauses longer."""
    print("\npauses between stretches [s]: of the run, of LinuxCNC")
    for case in CASES:
        if case.program.parent.name != "13-timers":
            continue
        with tempfile.TemporaryDirectory() as folder:
            assert not isinstance(WHAT, str)
            found = rehearsed(case, Path(folder), WHAT, 1.0)
        motions = found.run.motions
        for one, other in pairwise(found.stretches):
            ended, begun = motions[one.last - 1].end_s, motions[other.first - 1].start_s
            moved = ended - motions[one.first - 1].start_s + one.longer_s
            print(
                f"{case.name:28} {begun - ended:6.3f} {other.begins_s - one.begins_s - moved:6.3f}"
            )
        assert found.holds, [d.headline for d in found.diagnostics]


def test_how_near_linuxcnc_is_on_programs_drawn_by_chance(tmp_path: Path) -> None:
    """Both ways of their decisions, jumps too; those that reach too far are left out."""
    rehearsals = 0
    for number in range(DRAWN):
        text = drawn(number, PUMA560)
        place = tmp_path / "program.v2"
        place.write_text(text)
        for inputs in ((1003,), (1001, 1002, 1003)):
            scenario = tmp_path / "inputs.toml"
            rows = (f"[[inputs]]\nsignal = {signal}\non_s = [0.0]\n" for signal in inputs)
            scenario.write_text('title = "inputs"\n' + "".join(rows))
            case = Case(place, scenario, scene="one-can-puma560")
            if not verifies(case):
                continue
            found, took = once(case)
            if not found.holds:  # as the thorough tests do: LinuxCNC loses its place at times
                print(f"again: {[d.headline for d in found.diagnostics]}", flush=True)
                found, took = once(case)
            print(f"{number:4} {len(inputs)} {took:5.1f} s  {figures(found)}", flush=True)
            assert found.holds, [d.headline for d in found.diagnostics]
            rehearsals += 1
    print(f"{rehearsals} rehearsals")
    assert rehearsals > DRAWN / 2


def verifies(case: Case) -> bool:
    """Return whether a program drawn by chance stays within reach."""
    assert case.scene is not None
    assert case.scenario is not None
    setting = with_scenario(free_setting(Where(case.scene), case.program.parent), case.scenario)
    request = Request(ProgramFile(case.program.read_bytes(), case.program.name), setting)
    return isinstance(verified(request), Verified)


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
