"""What the server's own objects take over days in which thousands come and go; printed.

Run by hand: `python -m pytest tests/bench/test_bench_live_memory.py -s`; `VRTS_HOURS=96` makes it
longer. The application is called as uvicorn calls it, with sessions that are none, and its clock is
set on by an hour after each hour (`tests/bench/live_in_process.py`). All bytes are counted that
Python gives out, after a collection, and told by the lines of vrts that hold most of what is new.
Each who comes leaves a line of chat, a few messages for those who come back and a name, until rooms
and names are as many as are remembered.
"""

import asyncio
import gc
import json
import os
import time
import tracemalloc
from pathlib import Path

import pytest
from starlette.types import ASGIApp

from tests.bench.live_in_process import Page, Pretended, asked, running
from tests.bench.live_term_people import GIVEN
from vrts.live.entrance.by_hand import supervisor_link
from vrts.live.front.app import application
from vrts.live.lasting import clock
from vrts.live.places import places_of
from vrts.live.rooms import sessions
from vrts.live.settings import DATABASE, Settings
from vrts.live.store.database import opened

HOURS = int(os.environ.get("VRTS_HOURS", "24"))
JOINS = 84  # an hour
MOST = 1800.0  # bytes that one more person may leave behind, before the limits are reached
SHOWN = 12  # places in the code
ROOMS = ("Class", "Two", "Three", "Four", "Five", "Six")


class Ahead:
    """The module `time` with clocks that are ahead."""

    def __init__(self) -> None:
        self.seconds = 0.0

    def monotonic(self) -> float:
        return time.monotonic() + self.seconds

    def clock_gettime(self, which: int) -> float:
        return time.clock_gettime(which) + self.seconds


class Hours:
    """The hours of a server."""

    def __init__(self, app: ASGIApp, folder: Path, ahead: Ahead) -> None:
        """Take an application that has started."""
        self.app, self.folder, self.ahead = app, folder, ahead
        self.joined = 0

    async def begin(self) -> None:
        """Let the supervisor in."""
        connection = opened(self.folder / DATABASE)
        token = supervisor_link(connection, clock.wall())
        connection.close()
        self.cookie = await self.enter("", token)
        self.boss = Page(self.app, self.cookie)
        self.boss.send("join")
        snapshot = await self.boss.wait("snapshot")
        self.rooms = [room["id"] for room in snapshot["rooms"]]

    async def enter(self, name: str, code: str) -> str:
        """Enter; return the cookie."""
        body = {"code": code, "name": name}
        status, cookies, data = await asked(self.app, "POST", "/enter", body)
        assert status == 200, data
        return cookies

    async def hour(self, number: int) -> None:
        """Let an hour happen."""
        if number % 6 == 1:
            await asked(self.app, "POST", "/ways", {"do": "renew"}, self.cookie)
        code = json.loads((await asked(self.app, "GET", "/code", None, self.cookie))[2])["code"]
        for _ in range(JOINS):
            await self._come(code)
        await self.boss.wait("people")
        self.boss.send("broadcast", text=f"hour {number}")
        self.boss.send("end_announcement")
        await self.boss.wait("announced", id=0)
        self.ahead.seconds += 3600.0
        self.boss.send("watch_wall", on=True)  # which is shown once a second, after the rest
        await self.boss.wait("wall")
        await self.boss.wait("wall")
        self.boss.send("watch_wall", on=False)
        self.boss.door.said.clear()

    async def _come(self, code: str) -> None:
        self.joined += 1
        number = self.joined
        room = self.rooms[number % len(self.rooms)]
        cookie = await self.enter(f"{GIVEN[number % len(GIVEN)]} {number}", code)
        page = Page(self.app, cookie)
        page.send("join", room=room, rate=1)
        await page.wait("snapshot")
        page.send("say", text=f"line {number}")
        await page.wait("chat", text=f"line {number}")
        page.send("request_control")
        lease = ""
        while not lease:
            lease = (await page.wait("control"))["lease"]
        line = {"type": "line", "line": f"DO a = {number}"}
        page.send("command", lease=lease, number=1, action=line)
        await page.wait("result", of=1)
        kept = {"room": room, "shelf": "own", "name": "mine", "text": "READY", "seen": 0}
        status, _, data = await asked(self.app, "POST", "/programs/keep", kept, cookie)
        assert status == 200, data
        wrong = {"user": f"nobody {number}", "password": "wrong"}
        if number % 20 == 0:
            await asked(self.app, "POST", "/login", wrong)
        if number % 3 == 0:
            await asked(self.app, "POST", "/logout", None, cookie)
        page.send("hand_back")
        await page.close()


def test_memory_of_the_servers_objects(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ahead = Ahead()
    monkeypatch.setattr(clock, "time", ahead)
    monkeypatch.setattr(sessions, "SessionProcess", Pretended)
    settings = Settings(tmp_path, places_of(("cans-on-bases",)), log_key=tmp_path.parent / "k/key")
    app = application(settings, "http://127.0.0.1:8000", ROOMS, with_code=True)
    sizes: list[float] = []

    async def all_of_it() -> None:
        middle: tracemalloc.Snapshot | None = None
        async with running(app):
            hours = Hours(app, tmp_path, ahead)
            await hours.begin()
            tracemalloc.start()
            for number in range(HOURS):
                await hours.hour(number)
                gc.collect()
                sizes.append(tracemalloc.get_traced_memory()[0] / 1e3)
                if number == HOURS // 2 - 1:
                    middle = tracemalloc.take_snapshot()
            last = tracemalloc.take_snapshot()
            assert middle is not None
            for row in last.compare_to(middle, "lineno")[:SHOWN]:
                place = str(row.traceback).rpartition("/vrts/")[2]
                print(f"  {row.size_diff / 1e3:+8.1f} kB in {row.count_diff:+d}: {place}")
            await hours.boss.close()

    began_s, used_s = time.monotonic(), time.process_time()
    asyncio.run(all_of_it())
    tracemalloc.stop()
    half = sizes[len(sizes) // 2 - 1]
    each = 1e3 * (sizes[-1] - half) / (JOINS * (HOURS - HOURS // 2))
    print(
        f"\n{HOURS} hours, {JOINS * HOURS} people:"
        f" {', '.join(f'{size:.0f}' for size in sizes)} kB by the hour; in the second half"
        f" {sizes[-1] - half:+.1f} kB, {each:.0f} bytes a person;"
        f" took {time.monotonic() - began_s:.0f} s,"
        f" {time.process_time() - used_s:.0f} s of processor"
    )
    assert each <= MOST
