"""What keeps a session going in a room: it ends with the room, and with nothing else."""

import asyncio
import errno
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any

import pytest

from vrts.live.places import places_of
from vrts.live.rooms import sessions as module
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.opening import close, make_room
from vrts.live.rooms.process import SessionProcess
from vrts.live.rooms.room import Room
from vrts.live.rooms.sessions import CANNOT_BEGIN, STARTING, Sessions
from vrts.live.settings import Settings
from vrts.live.store.database import Database

SCENE = "cans-on-bases"


class Pretended(SessionProcess):
    """A process that is none: it never gets ready, and runs until it is stopped."""

    began: list["Pretended"]
    faults: list[OSError]

    async def run(self) -> None:
        """Run until it is stopped."""
        if self.faults:
            raise self.faults.pop()
        self.began.append(self)
        while not self._stopped:
            await asyncio.sleep(0.001)


@pytest.fixture(autouse=True)
def pretended(monkeypatch: pytest.MonkeyPatch) -> type[Pretended]:
    Pretended.began, Pretended.faults = [], []
    monkeypatch.setattr(module, "SessionProcess", Pretended)
    monkeypatch.setattr(module, "RETRY_S", 0.001)
    return Pretended


async def until(there: Callable[[], bool]) -> None:
    """Wait until something is so, for two seconds at most."""
    async with asyncio.timeout(2.0):
        while not there():
            await asyncio.sleep(0.001)


def in_hub(tmp_path: Path, work: Callable[[Hub, Sessions], Coroutine[Any, Any, None]]) -> None:
    """Do something with a server's rooms, and end them."""

    async def all_of_it() -> None:
        hub = Hub(Settings(tmp_path, places_of((SCENE,))), Database(tmp_path / "live.sqlite"))
        sessions = Sessions(hub)
        await work(hub, sessions)
        sessions.stop()
        await hub.stop()

    asyncio.run(all_of_it())


def keepers() -> int:
    """Return how many rooms are kept going."""
    return sum("_keep_going" in repr(task) for task in asyncio.all_tasks())


async def opened(hub: Hub, sessions: Sessions, scene: str = SCENE) -> Room:
    room = await make_room(hub, "Class", scene)
    sessions.begin(room)
    return room


def test_a_room_that_is_closed_before_its_turn_begins_no_session(tmp_path: Path) -> None:
    async def work(hub: Hub, sessions: Sessions) -> None:
        rooms = [await opened(hub, sessions) for _ in range(STARTING)]
        await until(lambda: len(Pretended.began) == STARTING)
        late = await opened(hub, sessions)
        await until(lambda: late.session > 0)
        for _ in range(10):
            await hub.database.do(lambda _: None)
            await asyncio.sleep(0.001)
        await close(hub, late)
        for room in rooms:
            await close(hub, room)
        await until(lambda: keepers() == 0)
        assert len(Pretended.began) == STARTING

    in_hub(tmp_path, work)


def test_a_room_that_is_closed_while_it_waits_for_its_supervisor_ends(tmp_path: Path) -> None:
    async def work(hub: Hub, sessions: Sessions) -> None:
        room = await opened(hub, sessions, "not-offered")
        await until(lambda: room.waits is not None)
        assert keepers() == 1
        await close(hub, room)
        await until(lambda: keepers() == 0)
        assert Pretended.began == []

    in_hub(tmp_path, work)


def test_a_session_that_cannot_begin_is_tried_again(tmp_path: Path) -> None:
    async def work(hub: Hub, sessions: Sessions) -> None:
        Pretended.faults = [OSError(errno.EAGAIN, "no more processes") for _ in range(3)]
        room = await opened(hub, sessions)
        await until(lambda: len(Pretended.began) == 1)
        assert [said.text for said, _ in room.chat] == [
            f"{CANNOT_BEGIN}: no more processes; it is tried again"
        ], "it is said once"
        rooms = [room, *[await opened(hub, sessions) for _ in range(1, STARTING)]]
        await until(lambda: len(Pretended.began) == STARTING)
        for room in rooms:
            await close(hub, room)
        await until(lambda: keepers() == 0)

    in_hub(tmp_path, work)
