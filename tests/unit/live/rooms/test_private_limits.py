"""How many private rooms may be begun, and when none can be."""

import asyncio
from pathlib import Path

import pytest

from vrts.live import limits
from vrts.live.limits import BRANCHES, Buckets
from vrts.live.places import places_of
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import NO_DISK, Hub
from vrts.live.rooms.member import Member
from vrts.live.rooms.opening import make_room
from vrts.live.rooms.private.branching import branch
from vrts.live.rooms.sessions import Sessions
from vrts.live.session.views.frame import PoseFrame, packed
from vrts.live.settings import Settings
from vrts.live.store.accounts import Account
from vrts.live.store.database import Database


def test_an_account_has_a_budget_whatever_places_it_has(monkeypatch: pytest.MonkeyPatch) -> None:
    buckets = Buckets(*BRANCHES)
    assert [buckets.take(1, 1000.0) for _ in range(7)] == [True] * 6 + [False]
    assert buckets.take(2, 1000.0), "others have their own"
    assert not buckets.take(1, 1119.0)
    assert buckets.take(1, 1121.0)
    assert not buckets.take(1, 1121.0)
    monkeypatch.setattr(limits, "ACCOUNTS", 10)
    assert [buckets.take(3, 1121.0) for _ in range(7)] == [True] * 6 + [False]
    for account in range(4, 30):
        assert buckets.take(account, 1121.0)
        assert not buckets.take(1, 1121.0), "who asks again and again is not forgotten"
    assert buckets.take(3, 1121.0), "not all are remembered"


def test_private_rooms_are_begun_one_after_another_and_not_too_often(tmp_path: Path) -> None:
    async def work() -> list[str]:
        hub = Hub(
            Settings(tmp_path, places_of(("cans-on-bases",))), Database(tmp_path / "live.sqlite")
        )
        room = await make_room(hub, "Class", "cans-on-bases")
        room.frame = packed(PoseFrame(1, 1, 9.0, (0.0,) * 6, 0.0, 0, 0))
        account, found = Account(1, "Anna", False, None), list[str]()

        async def ask() -> None:  # each time from a place of its own
            try:
                await branch(hub, Sessions(hub), Member(account, room.id), 1.0)
            except NotObeyed as problem:
                found.append(problem.text)

        hub.branching.add(2)
        await ask()
        hub.branching.clear()
        hub.journal.problem = "full"
        await ask()
        hub.journal.problem = ""
        for _ in range(8):
            await ask()
        assert not hub.branching
        hub.database.close()
        return found

    nothing = "there is no session to go on from"
    assert asyncio.run(work()) == [
        "the server is making a private room for somebody else",
        NO_DISK,
        *[nothing] * 6,
        *["you have begun many private rooms already"] * 2,
    ]
