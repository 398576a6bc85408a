"""Programs on their way are only so many: slow ones of others keep nobody from saving."""

import asyncio
from pathlib import Path
from typing import Any

import pytest
from starlette.requests import Request

from vrts.live.front import program_pages
from vrts.live.front.program_pages import ProgramPages
from vrts.live.places import places_of
from vrts.live.rooms.hub import Hub
from vrts.live.settings import Settings
from vrts.live.store.accounts import Account
from vrts.live.store.database import Database

DROP = b'{"room":"","shelf":"own","name":"pick"}'


def sent_by(account: int, *, slow: bool = False) -> Request:
    """Return a request whose body is there, or never comes."""

    async def receive() -> dict[str, Any]:
        if slow:
            await asyncio.Event().wait()
        return {"type": "http.request", "body": DROP, "more_body": False}

    headers = [(b"content-type", b"application/json"), (b"cookie", f"who={account}".encode())]
    return Request({"type": "http", "method": "POST", "headers": headers}, receive)


async def who(cookies: dict[str, str]) -> Account:
    return Account(int(cookies["who"]), "x", cookies["who"] == "0", None)


def test_the_slowest_of_who_sends_most_gives_way(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(program_pages, "ALL_BODIES", 5)
    hub = Hub(Settings(tmp_path, places_of(("cans-on-bases",))), Database(tmp_path / "live.sqlite"))

    async def work() -> None:
        pages = ProgramPages(hub, who)

        async def begun(account: int) -> asyncio.Task[Any]:
            task = asyncio.create_task(pages.drop(sent_by(account, slow=True)))
            await asyncio.sleep(0.01)
            return task

        single = await begun(3)
        boss = [await begun(0) for _ in range(3)]
        slow = [await begun(account) for account in (1, 1, 2, 2)]
        assert (await pages.drop(sent_by(1))).status_code == 503, "two of a person"
        assert (await pages.drop(sent_by(0))).status_code == 204, "who leads is not counted"
        assert not any(task.done() for task in (single, *boss, *slow))
        for ended in (slow[0], slow[2], single):
            assert (await pages.drop(sent_by(9))).status_code == 204
            assert (await ended).status_code == 503
            await begun(20 + slow.index(ended) if ended in slow else 30)
        for task in asyncio.all_tasks() - {asyncio.current_task()}:
            task.cancel()
        hub.database.close()

    asyncio.run(work())
