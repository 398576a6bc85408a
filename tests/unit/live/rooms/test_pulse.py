"""What time brings about goes on, whatever goes wrong in a part of it."""

import asyncio
from pathlib import Path

import pytest

from vrts.live.places import places_of
from vrts.live.rooms import pulse as module
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.opening import make_room
from vrts.live.rooms.pulse import pulse
from vrts.live.rooms.room import Room
from vrts.live.settings import Settings
from vrts.live.store.database import Database


def test_what_fails_in_a_round_is_logged_and_the_others_go_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    rounds: list[str] = []

    async def forgets(_: Hub) -> None:
        raise PermissionError("a part that fails")

    async def ends(hub: Hub) -> None:
        rounds.append("ended")
        hub.stopping = True

    def breaks(_: Hub, room: Room, __: float) -> None:
        rounds.append(room.kept.name)
        raise ValueError("a room that fails")

    monkeypatch.setattr(module, "PULSE", 0.0)
    monkeypatch.setattr(module, "forget_purged", forgets)
    monkeypatch.setattr(module, "end_empty", ends)
    monkeypatch.setattr(module, "_pulse_room", breaks)

    async def work() -> None:
        hub = Hub(
            Settings(tmp_path, places_of(("cans-on-bases",))), Database(tmp_path / "live.sqlite")
        )
        for name in "ab":
            await make_room(hub, name, "cans-on-bases")
        async with asyncio.timeout(2.0):
            await pulse(hub)
        hub.database.close()

    asyncio.run(work())
    assert rounds == ["a", "b", "ended"]
    faults = [str(row.exc_info[1]) for row in caplog.records if row.exc_info]
    assert faults == ["a room that fails", "a part that fails"], "each once a while"
