"""The pace of frames in a room with a task while its program runs and its mark is found; printed.

Run by hand: `python -m pytest tests/bench/test_bench_live_task.py -s -p no:xdist`. The solution of
the first example runs again and again. Intervals are between arrivals at one viewer; how often the
mark was told, and how many bytes that took, stands beside them.
"""

import itertools
import json
import time
from pathlib import Path

from tests.support_live import LiveServer

SECONDS = 20.0
TASK = Path("examples/01-cans-on-bases/task.toml")
AGAIN = """\
.PROGRAM again
10 CALL main
GOTO 10
.END
"""


def test_the_pace_of_frames_in_a_room_with_a_task(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live", scenes=(str(TASK),), measured=True) as server:
        browser = server.join(server.supervisor())
        snapshot = browser.wait("snapshot")
        if snapshot["state"] is None:
            browser.wait("state", lambda m: m["state"] is not None)
        lease = browser.take_control()
        text = (TASK.parent / "solution.v2").read_text() + AGAIN
        browser.answer(browser.command(lease, "upload", name="again.v2", text=text))
        browser.answer(browser.command(lease, "line", line="EXECUTE again"))
        browser.take_frames(50)
        browser.came.clear()
        arrivals: list[float] = []
        until = time.monotonic() + SECONDS
        while time.monotonic() < until:
            before = len(browser.frames)
            browser.take()
            if len(browser.frames) > before:
                arrivals.append(time.monotonic())
    gaps = sorted(b - a for a, b in itertools.pairwise(arrivals))
    told = [m for m in browser.came if m["type"] == "event" and m["event"]["type"] == "marked"]
    size = sum(len(json.dumps(m)) for m in told)
    share = [1000 * gaps[int(part * (len(gaps) - 1))] for part in (0.5, 0.95, 0.99, 1.0)]
    print(
        f"\n{len(arrivals) / SECONDS:.1f} frames/s; between them {share[0]:.1f} ms (median),"
        f" {share[1]:.1f} (95 %), {share[2]:.1f} (99 %), {share[3]:.1f} (most);"
        f" the mark was told {len(told)} times, {size} bytes in {SECONDS:g} s"
    )
    assert len(arrivals) > 0.8 * 50 * SECONDS
