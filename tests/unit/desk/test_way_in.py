"""Who is let in, and how a browser learns of it; who is not, uses up nothing."""

import asyncio
import socket
from collections.abc import AsyncIterator
from pathlib import Path
from typing import cast

import pytest
from starlette.requests import Request
from starlette.responses import StreamingResponse
from starlette.types import Message

from tests.support_desk import write_desk_class
from vrts.desk.again.marking import Marking
from vrts.desk.desk import Desk
from vrts.desk.front import app
from vrts.desk.front.events import MOST, Events
from vrts.desk.serving import way_in
from vrts.desk.told import GraderTold
from vrts.desk.upkeep import Upkeep
from vrts.marking.layout import Layout


def test_the_token_is_in_a_file_of_the_owner_while_the_desk_runs(tmp_path: Path) -> None:
    layout = Layout(tmp_path)
    layout.staff.mkdir()
    with way_in(layout, "http://127.0.0.1:8100/?token=secret", 8100) as place:
        assert "secret" not in place.as_uri()
        assert "url=http://127.0.0.1:8100/?token=secret" in place.read_text()
        assert place.stat().st_mode & 0o777 == 0o600
    assert not place.exists()


def test_pages_of_killed_desks_go_and_those_of_others_stay(tmp_path: Path) -> None:
    layout = Layout(tmp_path)
    layout.decisions.mkdir(parents=True)
    with socket.create_server(("127.0.0.1", 0)) as other, socket.socket() as dead:
        dead.bind(("127.0.0.1", 0))  # nobody listens there
        living, killed = (
            layout.decisions / f".desk-{one.getsockname()[1]}.html" for one in (other, dead)
        )
        for page in (living, killed):
            page.write_text("")
        with way_in(layout, "http://127.0.0.1:8100/?token=secret", 8100):
            assert living.exists()
            assert not killed.exists()


def test_who_leaves_before_events_begin_is_not_counted() -> None:
    async def ask() -> list[int]:
        events = Events()
        request = Request({"type": "http", "headers": []})
        left = [await events.listen(request) for _ in range(MOST + 1)]
        answers = [one.status_code for one in left]
        stays = await events.listen(request)
        body = cast("AsyncIterator[bytes]", cast("StreamingResponse", stays).body_iterator)
        await anext(body)
        events.end()
        return answers

    assert asyncio.run(ask()) == [200] * (MOST + 1)


def test_who_is_not_let_in_takes_no_requests_from_who_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(app, "REQUESTS", (0.0, 2.0))
    layout = write_desk_class(tmp_path, 1, decisions=False)
    desk = Desk(layout.root, GraderTold("huber", "R. Huber"))
    marking, upkeep = Marking(layout.root), Upkeep(lambda: "")
    door = app.application(desk, marking, upkeep, app.Way("secret", 8100), Events())
    asked: list[int] = []

    async def ask(path: str, query: bytes = b"", cookie: bytes = b"") -> bytes:
        head = [(b"host", b"127.0.0.1:8100"), (b"cookie", cookie)]
        scope = {"type": "http", "method": "GET", "path": path, "query_string": query}
        scope |= {"headers": head, "raw_path": path.encode(), "scheme": "http"}
        scope |= {"server": ("127.0.0.1", 8100), "client": ("127.0.0.1", 5), "http_version": "1.1"}
        set_cookie = b""

        async def receive() -> Message:
            return {"type": "http.request", "body": b"", "more_body": False}

        async def send(message: Message) -> None:
            nonlocal set_cookie
            if message["type"] == "http.response.start":
                asked.append(message["status"])
                set_cookie = dict(message["headers"]).get(b"set-cookie", b"")

        await door(scope, receive, send)
        return set_cookie.split(b";")[0]

    async def all_of_it() -> None:
        for _ in range(5):
            await ask("/api/class")
        cookie = await ask("/", b"token=secret")
        for _ in range(3):
            await ask("/api/class", cookie=cookie)

    asyncio.run(all_of_it())
    assert asked == [401, 401, 401, 401, 401, 200, 200, 200, 429]
