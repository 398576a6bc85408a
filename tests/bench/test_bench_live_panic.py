"""How soon PANIC stops the arm while a message of the same sender takes seconds.

Run by hand: `python -m pytest tests/bench/test_bench_live_panic.py -s`. A lock on the database has
a line of chat wait for 2 s; PANIC is pressed meanwhile. The time ends when the browser is told.
"""

import time
from pathlib import Path

from tests.support_live import LiveServer
from vrts.live.settings import DATABASE
from vrts.live.store.database import opened

ROUNDS, TAKES_S = 10, 2.0


def test_panic_beside_a_slow_message(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live", measured=True) as server:
        anna = server.join(server.enter("Anna"))
        anna.wait("state", lambda m: m["state"] is not None)
        anna.take_control()
        other = opened(server.folder / DATABASE)
        took: list[float] = []
        for _ in range(ROUNDS):
            other.execute("BEGIN IMMEDIATE")
            anna.send("say", text="slow")
            anna.quiet(0.3)
            begun = time.perf_counter()
            anna.send("panic")
            anna.wait("stopped")
            took.append(1000.0 * (time.perf_counter() - begun))
            anna.quiet(TAKES_S - 0.3)
            other.execute("ROLLBACK")
            anna.wait("chat")
        other.close()
    took.sort()
    print(
        f"\nPANIC beside a message of {TAKES_S:.0f} s: median {took[ROUNDS // 2]:.1f} ms,"
        f" longest {took[-1]:.1f} ms of {ROUNDS}"
    )
