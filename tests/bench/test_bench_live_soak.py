"""Five minutes of a class: 100 clients, a looping program, chat; memory of server and session.

Run by hand: `python -m pytest tests/bench/test_bench_live_soak.py -s`; `VRTS_SOAK_S=600` makes it
longer. What a session remembers by design counts as growth of its process: states to rewind to,
motions and events of the last hour. `test_bench_live_session.py` shows that this has an end, with
half an hour on a clock that runs faster.
"""

import os
import time
from pathlib import Path

from tests.bench.live_stage import Stage
from tests.bench.machine import used
from tests.bench.test_bench_live import Viewers, words
from tests.support_live import session_processes

SECONDS = float(os.environ.get("VRTS_SOAK_S", "300"))
PAUSE = 30.0  # [s] between looks
VIEWERS = 100
GROWTH = {"server": 4.0, "session": 1.5}  # [MB] a minute at most, after the first one
LOOP = """\
.PROGRAM loop()
10 DRIVE 1,30,100
    SIGNAL 3
    TYPE "there ", n
    DRIVE 1,-30,100
    SIGNAL -3
    n = n + 1
    GOTO 10
.END
"""


def test_memory_of_five_minutes(tmp_path: Path) -> None:
    with Stage(tmp_path, moving=False) as stage:
        (operator,) = stage.operators
        link = operator.socket
        link.command(operator.lease, "upload", name="loop.v2", text=LOOP)
        link.command(operator.lease, "line", line="DO n = 0")
        link.command(operator.lease, "line", line="EXECUTE loop,-1")
        viewers = Viewers(stage, VIEWERS, SECONDS)
        (session,) = session_processes(stage.process.pid)
        looks: list[tuple[float, float, float]] = []
        began_s = time.monotonic()
        begin = used(stage.process)
        print()
        while (passed_s := time.monotonic() - began_s) < SECONDS - 1.0:
            link.send("say", text=f"after {passed_s:.0f} s")
            link.wait("chat")
            sizes = [p.memory_info().rss / 1e6 for p in (stage.process, session)]
            looks.append((passed_s, *sizes))
            print(
                f"{passed_s:4.0f} s: server {sizes[0]:.1f} MB, {stage.process.num_fds()} files;"
                f" session {sizes[1]:.1f} MB"
            )
            due_s = began_s + min(passed_s + PAUSE, SECONDS - 1.0)
            while time.monotonic() < due_s:
                link.take()
        spent = used(stage.process).since(begin)
        seen = viewers.seen()
        database = sum(file.stat().st_size for file in (tmp_path / "live").glob("*.sqlite*")) / 1e6
        print(
            f"{seen.fps:.1f} fps (slowest {seen.slowest_fps:.1f}), delay p50, p95, p99"
            f" {words(seen.arrived)} ms; server {100 * spent.server:.0f} %, session"
            f" {100 * spent.sessions:.0f} % of a core; database {database:.1f} MB"
        )
    minute = next(look for look in looks if look[0] >= min(60.0, 0.2 * SECONDS))
    last = looks[-1]
    for name, first_mb, last_mb in zip(GROWTH, minute[1:], last[1:], strict=True):
        growth = 60.0 * (last_mb - first_mb) / (last[0] - minute[0])
        print(f"{name}: {growth:+.2f} MB a minute after the first")
        assert growth < GROWTH[name]
