"""A term of live teaching without its waiting: joins, deaths of sessions, backups; printed.

Run by hand: `python -m pytest tests/bench/test_bench_live_term.py -s`; `VRTS_TERM=0.1` does a
tenth.
Every command that was acknowledged is looked for in the logs at the end. Memory is looked at while
all sessions run, in steps; the second half may grow by 5 %. Steps of the clock are tried by
`tests/unit/live/rooms/test_clock_steps.py`.
"""

import os
import time
from pathlib import Path

import psutil

from tests.support_commands import vrts_text
from tests.support_live import Browser, LiveServer
from tests.unit.live.rooms.test_session_deaths import settled
from vrts.live.logs.log_file import read_log
from vrts.live.settings import DATABASE
from vrts.live.store import log
from vrts.live.store.database import opened

SHARE = float(os.environ.get("VRTS_TERM", "1"))
JOINS, DEATHS, BACKUPS, STEPS = int(2000 * SHARE), int(300 * SHARE), 20, 20
GROWTH = 0.05
PEOPLE = 20


def sizes(server: LiveServer) -> tuple[float, float]:
    """Return memory of the server and of its sessions together [MB]."""
    own = psutil.Process(server.process.pid)
    return own.memory_info().rss / 1e6, sum(c.memory_info().rss for c in own.children()) / 1e6


def test_a_term(tmp_path: Path) -> None:
    folder, began_s = tmp_path / "live", time.monotonic()
    with LiveServer(folder, "--idle", "0", measured=True) as server:
        boss_cookie = server.supervisor()
        boss, _ = settled(server, boss_cookie)
        room, lease = boss.came[0]["room"], boss.take_control()
        cookies = [server.enter(f"Student {n}") for n in range(PEOPLE)]
        acknowledged: list[int] = []
        looks: list[tuple[float, float]] = []
        joined = died = 0

        def command(value: int) -> None:
            of = boss.command(lease, "line", line=f"DO a = {value}")
            if boss.answer(of)["type"] == "result":
                acknowledged.append(value)

        for step in range(1, STEPS + 1):
            while joined < JOINS * step // STEPS:
                someone: Browser = server.join(cookies[joined % PEOPLE])
                someone.wait("snapshot")
                someone.socket.close()
                joined += 1
            while died < DEATHS * step // STEPS:
                command(died)
                for child in psutil.Process(server.process.pid).children():
                    child.kill()
                died += 1
                boss.wait("state", lambda m: m["state"] is not None)
            if step % (STEPS // min(BACKUPS, STEPS)) == 0:
                said = vrts_text("serve", "--folder", folder, "--backup", tmp_path / "copy.sqlite")
                assert said.returncode == 0, said.stderr
            boss.came.clear()
            boss.frames.clear()
            looks.append(sizes(server))
        text = server.request("GET", f"/log/{room}", cookie=boss_cookie).body
    lines = [str(entry.order) for session in read_log(text) for entry in session.entries]
    lost = [v for v in acknowledged if not any(f"DO a = {v}'" in line for line in lines)]
    for path in (tmp_path / "copy.sqlite", folder / DATABASE):
        connection = opened(path)
        assert log.verify(connection, room) == ""
        connection.close()
    middle, last = looks[len(looks) // 2 - 1], looks[-1]
    grown = [after / before - 1.0 for before, after in zip(middle, last, strict=True)]
    print(
        f"\n{joined} joins, {died} deaths, {len(acknowledged)} commands acknowledged, {len(lost)}"
        f" lost, in {time.monotonic() - began_s:.0f} s; load {os.getloadavg()[0]:.1f}\n"
        f"  server {middle[0]:.1f} to {last[0]:.1f} MB ({100 * grown[0]:+.1f} %), sessions"
        f" {middle[1]:.1f} to {last[1]:.1f} MB ({100 * grown[1]:+.1f} %) in the second half"
    )
    assert not lost
    assert max(grown) <= GROWTH
