"""The health address: well, or what is wrong; cheap, and about nobody."""

import asyncio
import sqlite3
from pathlib import Path
from typing import Any, cast

import pytest
from starlette.requests import Request

from tests.support_live import LiveServer
from vrts.live.protocol.from_server import NoSession
from vrts.live.rooms.control import ControlRight
from vrts.live.rooms.room import Room
from vrts.live.store.branches import Branch
from vrts.live.store.rooms import KeptRoom
from vrts.live.watching import health
from vrts.live.watching.health import DYING, UNWRITTEN, HealthPage

ASKED = cast("Request", None)  # nothing of it is read


class Hub:
    """As much of a hub as is looked at."""

    def __init__(self) -> None:
        self.rooms: dict[str, Room] = {}
        self.database = self
        self.writes = 0
        self.fault: Exception | None = None

    def everybody(self) -> list[Any]:
        return []

    async def do(self, _: object) -> None:
        self.writes += 1
        if self.fault is not None:
            raise self.fault


def test_it_is_well_until_nothing_can_be_written_or_sessions_die(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    hub = Hub()
    page = HealthPage(cast("Any", hub))

    async def ask() -> tuple[int, bytes]:
        answer = await page.answer(ASKED)
        return answer.status_code, bytes(answer.body)

    async def all_at_once() -> list[tuple[int, bytes]]:
        return await asyncio.gather(*(ask() for _ in range(50)))

    assert {status for status, _ in asyncio.run(all_at_once())} == {200}
    assert hub.writes == 1, "asking often costs nothing"
    room = Room(KeptRoom("r", "Secret", "s", 1, True, 0.0, 0.0), control=ControlRight())
    room.waits, hub.rooms["r"] = NoSession("died"), room
    status, body = asyncio.run(ask())
    assert (status, DYING.encode() in body, b"Secret" in body) == (503, True, False)
    room.branch = Branch("r", 1, "class", 0.0)
    assert asyncio.run(ask())[0] == 200, "what one person does in a private room is their own"
    room.branch = None
    assert asyncio.run(ask())[0] == 503
    room.offered = False  # its scene is not among those that are served: that was chosen
    assert asyncio.run(ask())[0] == 200
    monkeypatch.setattr(health, "FRESH_S", -1.0)
    hub.fault = sqlite3.OperationalError("database or disk is full")
    status, body = asyncio.run(ask())
    assert (status, UNWRITTEN.encode() in body) == (503, True)
    hub.fault = None
    assert asyncio.run(ask())[0] == 200


@pytest.mark.thorough
def test_a_server_tells_its_health_to_whoever_asks(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live") as server:
        answer = server.request("GET", "/health", origin="")
        assert answer.status == 200
        assert answer.json["status"] == "ok"
        assert set(answer.json) == {
            *("status", "problems", "up_s", "rooms", "sessions", "waiting", "people")
        }
        assert server.request("GET", "/health", host="evil.example", origin="").status == 421
