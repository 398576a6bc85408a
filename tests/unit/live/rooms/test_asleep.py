"""Rooms that fall asleep and wake: no process meanwhile, and nothing of what was done is lost."""

import asyncio
import shutil
from collections.abc import AsyncGenerator, Callable, Coroutine
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import psutil
import pytest

from tests.bench.live_in_process import Page, asked, running
from vrts.live.entrance.by_hand import supervisor_link
from vrts.live.front import app as module
from vrts.live.lasting.clock import wall
from vrts.live.logs.unfinished import unfinished
from vrts.live.places import places_of
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.room import Room
from vrts.live.rooms.sessions import WAKING, Sessions
from vrts.live.session.again.carrying_on import STOPPED
from vrts.live.session.again.replay import replay
from vrts.live.session.channel.messages import Start
from vrts.live.session.growing.folder import ASLEEP
from vrts.live.settings import DATABASE, SESSIONS, Settings
from vrts.live.store import log
from vrts.live.store.database import opened

SCENE = "cans-on-bases"
PATIENCE_S = 120.0
SWING = ".PROGRAM swing()\n DRIVE 1,20,50\n turns = 7\n SIGNAL 3\n.END\n"
ENDLESS = ".PROGRAM loop()\n x = 0\n 10 x = x+1\n GOTO 10\n.END\n"


class Serving:
    """A server in this process, with who supervises it."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.folder = folder
        settings = Settings(folder, places_of((SCENE,)), log_key=folder.parent / "key")
        begun: list[tuple[Hub, Sessions]] = []

        class Known(Sessions):
            def __init__(self, hub: Hub) -> None:
                super().__init__(hub)
                begun.append((hub, self))

        monkeypatch.setattr(module, "Sessions", Known)
        self.app = module.application(settings, "http://127.0.0.1:8000", ("Ada",), with_code=True)
        self.hub, self.sessions = begun[-1]
        self.boss: Page
        self.number = 0
        self.lease = ""

    @property
    def room(self) -> Room:
        """The only room."""
        return next(iter(self.hub.rooms.values()))

    async def come(self) -> dict[str, Any]:
        """Enter as supervisor; return the first snapshot."""
        connection = opened(self.folder / DATABASE)
        token = supervisor_link(connection, wall())
        connection.close()
        body = {"code": token, "name": ""}
        status, self.cookie, _ = await asked(self.app, "POST", "/enter", body)
        assert status == 200
        return await self.open()

    async def open(self) -> dict[str, Any]:
        """Open the room's page and take control."""
        self.boss = Page(self.app, self.cookie)
        self.boss.send("join", room=self.room.id, rate=1)
        snapshot = await self.boss.wait("snapshot")
        self.boss.send("request_control")
        while not self.lease:
            self.lease = (await self.boss.wait("control"))["lease"]
        return snapshot

    async def seen(self) -> dict[str, Any]:
        """Return what somebody else sees who joins now."""
        page = Page(self.app, self.cookie)
        page.send("join", room=self.room.id, rate=1)
        snapshot = await page.wait("snapshot")
        await page.close()
        return snapshot

    async def state(self) -> dict[str, Any]:
        """Return the state of the session when it is there."""
        while (state := (await self.boss.wait("state"))["state"]) is None:
            pass
        return state

    def command(self, action: str, **fields: Any) -> int:
        """Give a command; return its number."""
        self.number += 1
        action_ = {"type": action, **fields}
        self.boss.send("command", lease=self.lease, number=self.number, action=action_)
        return self.number

    async def done(self, action: str, **fields: Any) -> str:
        """Give a command; return what is answered when it is recorded."""
        result = (await self.boss.wait("result", of=self.command(action, **fields)))["result"]
        assert result["accepted"], result
        return str(result["text"])

    async def at_rest(self) -> None:
        """Wait until nothing is under way, and sleep."""
        while True:
            try:
                await self.sessions.sleep(self.room)
            except NotObeyed:
                await asyncio.sleep(0.01)
            else:
                return

    def process(self) -> psutil.Process:
        """Return the process of the session."""
        assert self.room.process is not None
        assert self.room.process.pid is not None
        return psutil.Process(self.room.process.pid)


@asynccontextmanager
async def served(folder: Path, monkeypatch: pytest.MonkeyPatch) -> AsyncGenerator[Serving]:
    """Serve a folder."""
    serving = Serving(folder, monkeypatch)
    async with running(serving.app):
        yield serving
        await serving.boss.close()


def within(work: Callable[[], Coroutine[Any, Any, None]]) -> None:
    """Do something, which may take its time."""

    async def all_of_it() -> None:
        async with asyncio.timeout(PATIENCE_S):
            await work()

    asyncio.run(all_of_it())


def kinds(folder: Path, room: str) -> list[str]:
    """Return the kinds of the records of a log, which has to be whole."""
    connection = opened(folder / DATABASE)
    assert log.verify(connection, room) == ""
    found = [logged.record.kind for logged in log.records(connection, room)]
    connection.close()
    return found


async def until_gone(process: psutil.Process) -> None:
    """Wait until a process has ended."""
    while process.is_running() and process.status() != psutil.STATUS_ZOMBIE:
        await asyncio.sleep(0.001)


def test_a_room_sleeps_without_a_process_and_wakes_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    folder = tmp_path / "live"
    folder.mkdir()
    held: list[Path] = []

    async def first() -> None:
        async with served(folder, monkeypatch) as live:
            await live.come()
            if not live.room.process or not live.room.process.ready:
                await live.state()
            await live.done("upload", name="loop.v2", text=ENDLESS)
            await live.done("line", line="EXECUTE loop")
            with pytest.raises(NotObeyed, match="a program is running"):
                await live.sessions.sleep(live.room)
            await live.done("line", line="ABORT")
            await live.done("upload", name="swing.v2", text=SWING)
            await live.done("line", line="EXECUTE swing")
            process = live.process()

            settled = live.hub.journal.settled

            async def copied() -> None:
                await settled()
                shutil.copytree(folder, tmp_path / "before the record")

            monkeypatch.setattr(live.hub.journal, "settled", copied)
            await live.at_rest()
            monkeypatch.setattr(live.hub.journal, "settled", settled)
            shutil.copytree(folder, tmp_path / "after the record")
            await until_gone(process)
            assert live.room.rest == "asleep"
            assert live.room.reached is not None, "the wall still shows it"

            snapshot = await live.seen()
            assert snapshot["state"]["status"]["signals"] == [3], "the last that was seen"
            assert [p["name"] for p in snapshot["state"]["programs"]] == ["loop", "swing"]
            status, _, scene = await asked(
                live.app, "GET", snapshot["scene_url"], None, live.cookie
            )
            assert (status, scene[:1]) == (200, b"{")
            assert live.room.rest == "asleep", "who looks wakes nobody"
            number = live.command("line", line="LISTR turns")
            await live.boss.wait("no_session", why=WAKING)
            await live.boss.wait("no_session", why="")
            assert "7" in (await live.boss.wait("result", of=number))["result"]["text"]
            assert live.room.session == snapshot["session"]
            await live.done("line", line="DO turns = 8")
            await live.at_rest()

    async def again() -> None:
        async with served(folder, monkeypatch) as live:
            snapshot = await live.come()
            assert live.room.process is None
            assert snapshot["state"]["status"]["signals"] == [3]
            assert "8" in await live.done("line", line="LISTR turns")
            state = (await live.seen())["state"]
            assert STOPPED not in [row["text"] for row in state["events"]]
            await live.at_rest()
            for file in (folder / SESSIONS).glob(f"*/{ASLEEP}"):
                held.append(file)
                file.write_bytes(file.read_bytes()[:-1])
            assert "8" in await live.done("line", line="LISTR turns"), "from the log"
            state = (await live.seen())["state"]
            assert STOPPED not in [row["text"] for row in state["events"]]

    within(first)
    within(again)
    assert len(held) == 1
    assert len([r for r in caplog.records if "wakes from its log" in r.getMessage()]) == 1
    (room,) = {path.name.rpartition("-")[0] for path in (folder / SESSIONS).glob("*-*")}
    found = kinds(folder, room)
    assert [kind for kind in found if kind in ("sleep", "wake", "carry_on", "begin")] == [
        *("begin", "sleep", "wake", "sleep", "wake", "sleep", "wake")
    ]
    connection = opened(folder / DATABASE)
    before = unfinished(connection, room, SCENE)
    connection.close()
    assert before is not None
    run = replay(Start(0, "", SCENE), before.session.entries, before.until_s)
    assert run.at(run.until_s).variables["turns"] == 8.0


@pytest.mark.thorough
@pytest.mark.parametrize("moment", ["before the record", "after the record"])
def test_a_server_that_is_killed_while_a_room_falls_asleep_loses_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, moment: str
) -> None:
    folder = tmp_path / "live"
    folder.mkdir()

    async def first() -> None:
        async with served(folder, monkeypatch) as live:
            await live.come()
            if not live.room.process or not live.room.process.ready:
                await live.state()
            await live.done("line", line="DO turns = 8")
            settled = live.hub.journal.settled

            async def copied() -> None:
                await settled()
                shutil.copytree(folder, tmp_path / "before the record")

            monkeypatch.setattr(live.hub.journal, "settled", copied)
            await live.at_rest()
            monkeypatch.setattr(live.hub.journal, "settled", settled)
            shutil.copytree(folder, tmp_path / "after the record")

    async def again() -> None:
        async with served(tmp_path / moment, monkeypatch) as live:
            await live.come()
            if moment == "before the record":
                while live.room.process is None or not live.room.process.ready:
                    await asyncio.sleep(0.001)
            else:
                assert live.room.process is None
            assert "8" in await live.done("line", line="LISTR turns")

    within(first)
    within(again)
