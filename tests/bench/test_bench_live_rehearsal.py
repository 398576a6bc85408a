"""Rehearsals over the socket: from `rehearse` to `ready`, and each step, and what a process takes.

By hand: `python -m pytest tests/bench/test_bench_live_rehearsal.py -s -p no:xdist`. A process that
only sleeps tells how busy the machine is.
"""

import statistics
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.bench.machine import Metronome
from tests.support_live import LiveServer
from tests.unit.live.rehearsing.support import ENDLESS, HITS, TASK, Page, link, processes

TIMES = 4  # with all others fewer than a person may begin at once
STEPS = 40


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    folder = tmp_path_factory.mktemp("rehearsing") / "live"
    with LiveServer(folder, scenes=(str(TASK),), measured=True) as started:
        yield started


def took(work: Callable[[], Any]) -> float:
    """Return how long something takes [ms]."""
    begun = time.perf_counter()
    work()
    return 1000.0 * (time.perf_counter() - begun)


def ready(page: Page, text: str, **fields: Any) -> None:
    """Rehearse; nothing else than `ready` is measured."""
    told = page.rehearse(text, **fields)
    assert told["type"] == "ready", told


def megabytes(pid: int) -> float:
    """Return the memory of a process that nobody shares with it, at most."""
    rows = (Path("/proc") / str(pid) / "smaps_rollup").read_text().splitlines()
    own = [int(row.split()[1]) for row in rows if row.startswith("Private")]
    return sum(own) / 1000.0


def test_from_rehearse_to_ready_and_each_step(server: LiveServer) -> None:
    cookie = server.enter("Anna")
    browser = server.join(cookie, version=1)
    room = browser.wait("welcome")["room"]
    browser.wait("state", lambda m: m["state"] is not None)
    with Metronome() as control, link(server, cookie, room) as socket:
        page = Page(socket)
        first = took(lambda: ready(page, HITS))
        again = [took(lambda: ready(page, HITS)) for _ in range(TIMES)]
        now = [took(lambda: ready(page, HITS, **{"from": "now"})) for _ in range(TIMES // 2)]
        steps = [took(lambda: page.ask("go", what="over")) for _ in range(STEPS // 2)]
        steps += [took(lambda: page.ask("go", what="back")) for _ in range(STEPS // 2)]
        block = took(lambda: page.ask("block", number=0))
        memory = megabytes(processes(server)[0])
        endless = took(lambda: ready(page, ENDLESS))
        until = time.monotonic() + 30.0
        while len(processes(server)) < 2 and time.monotonic() < until:
            time.sleep(0.1)
        time.sleep(3.0)  # it loads what it needs
        page.ask("stop")
        warm = took(lambda: ready(page, HITS))
        late = control.so_far()
    print(
        f"\nrehearse to ready: {first:.0f} ms with the first process of a server, {warm:.0f} with"
        f" one that waited, then median {statistics.median(again):.0f}, from now"
        f" {statistics.median(now):.0f}, 600 s of an endless program {endless:.0f}"
        f"\n  a step forward or back: median {statistics.median(steps):.1f} ms, slowest"
        f" {max(steps):.1f}; a block of poses {block:.1f}; a process {memory:.0f} MB of its own;"
        f" who only sleeps wakes {late.p95:.1f} ms late (p95)",
        end="",
    )
    assert statistics.median(steps) < 1000.0
