"""One connection of a rehearsal, with a process and a socket that the test plays."""

import asyncio
import json
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any, cast

import pytest
from starlette.websockets import WebSocket

from tests.support_live import Json
from vrts.live.rehearsing import offering
from vrts.live.rehearsing.asked import Begin, PassedOn, Rehearse
from vrts.live.rehearsing.offering import Rehearsals, Whose
from vrts.live.rehearsing.process import RehearsalProcess
from vrts.live.rehearsing.talk import TOO_OFTEN, Offered, serve_rehearsal
from vrts.live.rehearsing.told import Closed
from vrts.live.session.channel.messages import Start

SAID = "it is gone"


class Played:
    """A process that says nothing by itself."""

    alive, behind = True, False

    def __init__(self) -> None:
        self.asked: list[PassedOn] = []
        self.killed = False
        self.answers: asyncio.Queue[bytes | None] = asyncio.Queue()

    def ask(self, question: PassedOn) -> None:
        self.asked.append(question)

    async def answer(self) -> bytes | None:
        return await self.answers.get()

    async def why(self) -> str:
        return SAID

    async def end(self, *, killed: bool = True) -> None:
        self.killed = killed
        await asyncio.sleep(0)


class Talk:
    """A connection, and both of its ends."""

    def __init__(self, place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.processes: list[Played] = []
        self.told: asyncio.Queue[Json] = asyncio.Queue()
        self.said: asyncio.Queue[Json] = asyncio.Queue()
        self.begins = asyncio.Event()  # `where` answers
        self.begins.set()
        self.ordered = asyncio.Event()  # it was asked
        self.of = 0
        monkeypatch.setattr(offering, "begun", self._begun)
        whose = Whose(1, "a")
        offered = Offered(Rehearsals(place), whose, self._where, self._still)
        serving = serve_rehearsal(offered, cast("WebSocket", self))
        self.task = asyncio.get_running_loop().create_task(serving)

    def rehearse(self) -> int:
        self.of += 1
        text = json.dumps({"type": "rehearse", "id": self.of, "text": ""})
        self.said.put_nowait({"type": "websocket.receive", "text": text})
        return self.of

    async def _begun(self, folder: Path, *, warm: bool = False) -> RehearsalProcess:
        del folder, warm
        self.processes.append(Played())
        return cast("RehearsalProcess", self.processes[-1])

    async def _where(self, order: Rehearse) -> Begin:
        self.ordered.set()
        await self.begins.wait()
        return Begin(Start(1, ""), order)

    async def _still(self) -> Closed | None:
        return None

    # --- as a WebSocket -----------------------------------------------------------------------

    async def accept(self) -> None:
        pass

    async def receive(self) -> Json:
        return await self.said.get()

    async def send_text(self, text: str) -> None:
        self.told.put_nowait(json.loads(text))

    async def close(self, code: int) -> None:
        del code


def played(
    place: Path,
    monkeypatch: pytest.MonkeyPatch,
    work: Callable[[Talk], Coroutine[Any, Any, None]],
) -> None:
    """Have a connection, and do something with it."""

    async def whole() -> None:
        talk = Talk(place, monkeypatch)
        await work(talk)
        talk.task.cancel()
        await asyncio.gather(talk.task, return_exceptions=True)
        assert all(process.killed for process in talk.processes[-1:])

    asyncio.run(whole())


def test_nobody_rehearses_too_often_in_a_seat_that_is_held(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def work(talk: Talk) -> None:
        for _ in range(10):
            talk.rehearse()
            while len(asked := talk.processes[0].asked if talk.processes else []) < talk.of:
                await asyncio.sleep(0)
            assert asked
            talk.processes[0].answers.put_nowait(b'{"type":"ready"}')
            assert (await talk.told.get())["type"] == "ready"
        talk.rehearse()
        refused = await talk.told.get()
        assert (refused["id"], refused["message"]) == (11, TOO_OFTEN)
        assert len(talk.processes[0].asked) == 10

    played(tmp_path, monkeypatch, work)


def test_the_death_of_a_process_is_told_of_the_rehearsal_that_it_had(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def work(talk: Talk) -> None:
        talk.rehearse()
        while not talk.processes:
            await asyncio.sleep(0)
        talk.processes[0].answers.put_nowait(b'{"type":"ready"}')
        await talk.told.get()
        talk.begins.clear()
        talk.ordered.clear()
        talk.rehearse()
        await talk.ordered.wait()
        talk.processes[0].answers.put_nowait(None)
        ended = await talk.told.get()
        assert (ended["type"], ended["id"], ended["message"]) == ("ended", 1, SAID)
        talk.begins.set()
        while len(talk.processes) < 2 or not talk.processes[1].asked:
            await asyncio.sleep(0)
        (begun,) = talk.processes[1].asked
        assert isinstance(begun, Begin)
        assert begun.order.id == 2

    played(tmp_path, monkeypatch, work)


@pytest.mark.parametrize("ticks", range(12))
def test_a_process_is_killed_whenever_the_connection_is_given_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, ticks: int
) -> None:
    async def work(talk: Talk) -> None:
        talk.rehearse()
        while not talk.processes or not talk.processes[0].asked:
            await asyncio.sleep(0)
        talk.said.put_nowait({"type": "websocket.disconnect"})
        for _ in range(ticks):
            await asyncio.sleep(0)

    played(tmp_path, monkeypatch, work)
