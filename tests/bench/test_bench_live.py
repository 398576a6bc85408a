"""The live server under load, on loopback, with the viewers in another process; printed.

Run by hand: `python -m pytest tests/bench/test_bench_live.py -s`. A looping program moves the arm.
Delays are from the time a frame tells to its arrival, above the quickest of all frames (which takes
about half a millisecond); so they hold the session's own lateness too. Aims, on two idle cores: 100
viewers: p95 at most 5 ms, 20 % of a core; 500: 49 frames a second each, 20 ms, 80 %, 100 MB.
"""

import json
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

from tests.support_live import Browser, LiveServer
from vrts.live.session.frame import unpacked

SECONDS = 15.0
LOOP = ".PROGRAM loop()\n10 DRIVE 1,30,100\n DRIVE 1,-30,100\n GOTO 10\n.END\n"


def operator(server: LiveServer) -> tuple[Browser, str]:
    """Return somebody with the control right, in a session that runs."""
    browser = server.join(server.enter("Operator"))
    state = browser.wait("snapshot")["state"]
    browser.wait("control")
    if state is None:
        browser.wait("state")
    return browser, browser.take_control()


@pytest.mark.parametrize("viewers", [100, 500])
def test_viewers(tmp_path: Path, viewers: int) -> None:
    with LiveServer(tmp_path / "live") as server:
        browser, lease = operator(server)
        browser.command(lease, "upload", name="loop.v2", text=LOOP)
        browser.command(lease, "line", line="EXECUTE loop")
        browser.wait("now", lambda m: m["status"]["mode"] == "running")
        browser.send("rate", rate=1)
        cookies = [server.enter(f"Viewer {n}") for n in range((viewers + 7) // 8)]
        words = [sys.executable, "-m", "tests.bench.live_viewers", str(server.port)]
        generator = subprocess.Popen(
            [*words, str(viewers), str(SECONDS), *cookies], stdout=subprocess.PIPE, text=True
        )
        assert generator.stdout is not None
        assert generator.stdout.readline() == "measuring\n"
        process = psutil.Process(server.process.pid)
        before, began = process.cpu_times(), time.monotonic()
        line = generator.stdout.readline()
        after, passed = process.cpu_times(), time.monotonic() - began
        generator.wait()
        generator.stdout.close()
        found = json.loads(line)
        used = after.user + after.system - before.user - before.system
        print(
            f"\n{viewers} viewers: {found['fps']:.1f} fps (slowest {found['slowest_fps']:.1f}),"
            f" delay p50 {found['p50_ms']:.1f} p95 {found['p95_ms']:.1f}"
            f" p99 {found['p99_ms']:.1f} ms, server {100 * used / passed:.0f} % of a core,"
            f" {process.memory_info().rss / 1e6:.0f} MB, load average {os.getloadavg()[0]:.1f}"
        )


def test_command_to_first_changed_frame(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live") as server:
        browser, lease = operator(server)
        times: list[float] = []
        for n in range(30):
            browser.quiet(1.2)
            still = unpacked(browser.frames[-1]).joints
            began = time.perf_counter()
            way = 1 if n % 2 else -1
            browser.command(lease, "step", frame="joint", axis=0, way=way, size=0.05)
            while unpacked(browser.frames[-1]).joints == still:
                browser.take()
            times.append(1e3 * (time.perf_counter() - began))
        times.sort()
        print(
            f"\ncommand to first changed frame: median {statistics.median(times):.0f} ms,"
            f" p95 {times[int(0.95 * len(times))]:.0f} ms (aims 35 and 60),"
            f" load average {os.getloadavg()[0]:.1f}"
        )
