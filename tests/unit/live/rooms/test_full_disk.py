"""A disk that is full while a class works: nothing is acknowledged that is not recorded."""

import asyncio
import resource
import sqlite3
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any

import pytest

from tests.support_live import Browser, LiveServer
from tests.unit.live.rooms.test_session_deaths import boss_cookie, done, session_of, settled
from vrts.live.logs.log_file import read_log
from vrts.live.notices.kept import EVERYWHERE, KeptNotice, notice_of
from vrts.live.places import places_of
from vrts.live.protocol.from_server import Stopped
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.keeping import end_stopped, keep_notice_soon, keep_notices
from vrts.live.rooms.room import Room
from vrts.live.session.views.frame import unpacked
from vrts.live.settings import DATABASE, Settings
from vrts.live.store import log
from vrts.live.store.database import Answer, Connection, Database, opened
from vrts.live.store.log import Entry
from vrts.live.store.rooms import KeptRoom
from vrts.live.store.waiting.journal import Journal


def disk(server: LiveServer, *, full: bool) -> None:
    """Have every write of the server's to a file fail, as on a full disk, or not."""
    _, most = resource.prlimit(server.process.pid, resource.RLIMIT_FSIZE)
    resource.prlimit(server.process.pid, resource.RLIMIT_FSIZE, (0 if full else most, most))


def refused_by_disk(boss: Browser, lease: str, line: str) -> str:
    """Give a command; return the code with which it was refused."""
    answer = boss.answer(boss.command(lease, "line", line=line))
    assert answer["type"] == "refused", "not acknowledged"
    return answer["code"]


def until_it_took_effect(boss: Browser) -> None:
    """Wait until session time is well after the last command."""
    since_s = unpacked(boss.take_frames(1)[0]).time_s
    while unpacked(boss.take_frames(1)[0]).time_s < since_s + 0.2:
        pass


@pytest.mark.thorough
def test_nothing_is_acknowledged_while_the_disk_is_full(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live") as server:
        boss, _ = settled(server, server.supervisor())
        room, lease = boss.came[0]["room"], boss.take_control()
        done(boss, lease, "line", line="DO a = 1")
        disk(server, full=True)
        assert refused_by_disk(boss, lease, "DO b = 2") == "log", "it was done, but not recorded"
        told = [m["text"] for m in boss.came if m["type"] == "chat"]
        assert any("takes nothing more" in text for text in told)
        assert refused_by_disk(boss, lease, "DO c = 3") == "disk", "nothing more is done"
        boss.send("say", text="hello")
        assert boss.wait("refused")["code"] == "disk"
        assert server.request("POST", "/enter", {"code": server.code, "name": "x"}).status == 503
        boss.send("broadcast", text="save your work")
        assert boss.wait("announced")["text"] == "save your work"
        until_it_took_effect(boss)  # a panic before that would have ended it
        boss.send("panic")  # is always obeyed
        session_of(server).kill()  # and even now nothing is lost
        disk(server, full=False)
        boss.wait("chat", lambda m: "has room again" in m["text"])
        boss.wait("state", lambda m: m["state"] is not None)
        for name, value in (("a", "1"), ("b", "2")):
            assert value in done(boss, lease, "line", line=f"LISTR {name}")
        assert "Undefined" in done(boss, lease, "line", line="LISTR c")
        boss.send("say", text="hello again")
        boss.wait("chat", lambda m: m["text"] == "hello again")
        text = server.request("GET", f"/log/{room}", cookie=boss_cookie(boss)).body
    lines = [str(entry.order) for (one,) in (read_log(text),) for entry in one.entries]
    assert [n for n in "abc" if any(f"DO {n} =" in line for line in lines)] == ["a", "b"]
    connection = opened(tmp_path / "live" / DATABASE)
    assert log.verify(connection, room) == ""
    connection.close()


class Failing(Database):
    """A database that fails a few times, as with a full disk."""

    left = 2

    async def do(self, job: Callable[[Connection], Answer]) -> Answer:
        if self.left:
            self.left -= 1
            raise sqlite3.OperationalError("database or disk is full")
        return await super().do(job)


def test_what_everybody_has_to_see_is_kept_when_the_disk_has_room_again(tmp_path: Path) -> None:
    database = Failing(tmp_path / "live.sqlite")
    hub = Hub(Settings(tmp_path, places_of(("cans-on-bases",))), database)
    room = hub.rooms["r"] = Room(KeptRoom("r", "Class", "cans-on-bases", 1, True, 0.0, 0.0))

    async def kept() -> list[str]:
        database.left = 0
        rows = [await database.do(lambda c, r=r: notice_of(c, r)) for r in ("r", EVERYWHERE)]
        return [row.name for row in rows if row is not None]

    async def work() -> None:
        stop = KeptNotice("r", 0, 1.0, None, "Anna", "operator")
        keep_notice_soon(hub, "r", stop)
        keep_notice_soon(hub, EVERYWHERE, stop._replace(room=EVERYWHERE, account=77))  # purged
        await asyncio.sleep(0.0)
        assert hub.unkept
        assert await kept() == []
        await keep_notices(hub)
        assert await kept() == ["Anna"]
        room.stopped = Stopped(1.0, "", "Anna", "operator")
        database.left = 1
        end_stopped(hub, room)
        await asyncio.sleep(0.0)
        assert await kept() == ["Anna"]
        await keep_notices(hub)
        assert await kept() == []
        assert not hub.unkept
        await hub.stop()

    asyncio.run(work())


def test_records_are_written_in_order_whatever_fails_between(tmp_path: Path) -> None:
    database = Failing(tmp_path / "live.sqlite")
    told: list[bool] = []
    bad: Any = None  # which no log can hold

    def entry(number: int) -> Entry:
        kind = bad if number == 7 else "line"
        return Entry("r", 1, float(number), 0.0, kind, True, None, "", "{}")

    async def all_of_it() -> list[BaseException | None]:
        tasks: list[asyncio.Task[None]] = []

        def spawn(work: Coroutine[Any, Any, None]) -> None:
            tasks.append(asyncio.create_task(work))

        journal = Journal(database, spawn, lambda problem: told.append(bool(problem)))
        futures = [journal.put(entry(number)) for number in range(12)]
        await journal.settled()
        return [future.exception() for future in futures]

    found = asyncio.run(all_of_it())
    database.close()
    assert all(isinstance(one, sqlite3.OperationalError) for one in found), "who waited was told"
    assert told == [True, False]
    connection = opened(tmp_path / "live.sqlite")
    rows = connection.execute("SELECT at_s FROM log ORDER BY seq").fetchall()
    connection.close()
    assert [row[0] for row in rows] == [float(n) for n in range(12) if n != 7]
