"""Rehearsals on LinuxCNC while other processes keep every core busy: how often one goes wrong.

`VRTS_REHEARSALS` says how many (100), `VRTS_BUSY` how many busy loops run beside them (2), and
`VRTS_KEPT` names a folder for samples and log of those that fail.
"""

import os
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from tests.unit.dispatch.rehearsing.test_rehearsals import CASES, SPEED, rehearsed
from vrts.dispatch.rehearsing.installed import installed
from vrts.dispatch.rehearsing.rehearse import Rehearsal

RUNS = int(os.environ.get("VRTS_REHEARSALS", "100"))
BUSY = int(os.environ.get("VRTS_BUSY", "2"))
KEPT = os.environ.get("VRTS_KEPT")
TOLD = 10  # rehearsals between two lines of progress
WHAT = installed()
pytestmark = pytest.mark.skipif(isinstance(WHAT, str), reason="needs LinuxCNC")


@contextmanager
def busy(loops: int) -> Generator[None]:
    """Keep so many cores busy.

    Each loop has a session of its own, as LinuxCNC has: a scheduler that shares cores by sessions
    gives it as much.
    """
    words = (sys.executable, "-c", "while True: pass")
    begun = [subprocess.Popen(words, start_new_session=True) for _ in range(loops)]
    try:
        yield
    finally:
        for process in begun:
            process.kill()
            process.wait()


def test_rehearsals_hold_while_the_machine_is_busy() -> None:
    assert not isinstance(WHAT, str)
    tried: Counter[str] = Counter()
    failed: Counter[str] = Counter()
    took: list[float] = []
    print(f"\n{RUNS} rehearsals at {SPEED:g} x, {BUSY} busy loops, {os.cpu_count()} cores")
    with busy(BUSY):
        for number in range(RUNS):
            case = CASES[number % len(CASES)]
            begun = time.perf_counter()
            with tempfile.TemporaryDirectory() as folder:
                found = rehearsed(case, Path(folder), WHAT)
            took.append(time.perf_counter() - begun)
            tried[case.name] += 1
            if not found.holds:
                failed[case.name] += 1
                print(f"{number:4} {case.name} {took[-1]:.1f} s FAILED", flush=True)
                for one in found.diagnostics:
                    print(f"     {one.headline} {'; '.join(one.notes)}", flush=True)
                keep(f"{number:04}-{case.name.replace(' ', '-')}", found)
            if number % TOLD == TOLD - 1:
                bad = sum(failed.values())
                print(
                    f"{number + 1:4} rehearsals, {bad} failed, {np.mean(took):.1f} s each on"
                    f" average, {max(took):.1f} s the longest, load {os.getloadavg()[0]:.1f}",
                    flush=True,
                )
    for name, count in tried.items():
        print(f"{name:34} {count - failed[name]:3} of {count:3} held")
    print(f"{RUNS - sum(failed.values())} of {RUNS} rehearsals held")
    assert not failed


def keep(name: str, found: Rehearsal) -> None:
    """Write what a rehearsal that failed left, to look for the cause."""
    if KEPT is None:
        return
    folder = Path(KEPT)
    folder.mkdir(parents=True, exist_ok=True)
    np.savez_compressed(
        folder / f"{name}.npz", joints=found.samples.joints, motions=found.samples.motions
    )
    (folder / f"{name}.log").write_text(
        "\n".join((*found.words, *(d.headline for d in found.diagnostics), found.log))
    )
