"""The live server without sockets and without processes: its application, called as uvicorn does.

What its Python objects take can be counted so, to the byte.
"""

import asyncio
import json
from collections.abc import AsyncGenerator
from contextlib import asynccontextmanager
from typing import Any, Final

import msgspec
from starlette.types import ASGIApp, Message

from vrts.live.actions import Action
from vrts.live.door import EXTENSION
from vrts.live.rooms.process import Head, SessionProcess

HOST: Final = "127.0.0.1:8000"
SNAPSHOT: Final = b'{"type":"snapshot","bodies":[]}'
DONE: Final = b'{"type":"done","ref":0,"at_s":1.0,"accepted":true,"text":"ok"}'


class Pretended(SessionProcess):
    """A session that does at once whatever it is asked for, and nothing."""

    async def run(self) -> None:
        """Run until it is stopped."""
        self.ready, self.scene = True, b"{}"
        self._on_message(Head("ready", task=msgspec.Raw(b'""')), b"{}")
        while not self._stopped:
            await asyncio.sleep(0.01)
        self.ready = False

    def act(self, owner: str, action: Action) -> int:
        """Take an action, and answer."""
        self._ref += 1
        self._answer(Head("done", self._ref), DONE)
        return self._ref

    def halt(self) -> int:
        """Take a panic, and answer."""
        self._ref += 1
        self._answer(Head("done", self._ref), DONE)
        return self._ref

    def ask_snapshot(self) -> int:
        """Answer with a snapshot of nothing."""
        self._ref += 1
        self._answer(Head("snapshot", self._ref), SNAPSHOT)
        return self._ref

    def _answer(self, head: Head, message: bytes) -> None:
        asyncio.get_running_loop().call_soon(self._on_message, head, message)


class Heard:
    """A door, and who it leads to: all frames are read."""

    open, slow = True, False

    def __init__(self) -> None:
        self.said: list[dict[str, Any]] = []
        self.came = asyncio.Event()

    def send(self, frame: bytes) -> None:
        """Take a frame."""
        begin = frame.find(b'{"type"')
        self.said.append(json.loads(frame[begin:]))
        self.came.set()

    def latest(self, kind: str, frame: bytes) -> None:
        """Take the wall; poses and states are of no use to who only counts."""
        if kind == "wall":
            self.send(frame)

    def flush(self) -> None:
        """Nothing waits."""

    def finish(self) -> None:
        """The server has no more."""

    def abort(self) -> None:
        """The server has no more."""


class Page:
    """A page of somebody, joined by a WebSocket."""

    def __init__(self, app: ASGIApp, cookie: str) -> None:
        """Open it; `opened` waits until it has joined."""
        self.door = Heard()
        self._put: asyncio.Queue[Message] = asyncio.Queue()
        self._put.put_nowait({"type": "websocket.connect"})
        scope = {**_scope("/ws", cookie), "type": "websocket"}
        scope["extensions"] = {EXTENSION: lambda: self.door, "websocket.http.response": {}}
        self._task = asyncio.ensure_future(app(scope, self._put.get, _nowhere))

    def send(self, type_: str, **fields: Any) -> None:
        """Say something."""
        text = json.dumps({"type": type_, **fields})
        self._put.put_nowait({"type": "websocket.receive", "text": text})

    async def wait(self, type_: str, **fields: Any) -> dict[str, Any]:
        """Return the first message of a type with these fields, and forget all before it."""
        async with asyncio.timeout(60.0):
            while True:
                while self.door.said:
                    message = self.door.said.pop(0)
                    if message["type"] == type_ and fields.items() <= message.items():
                        return message
                self.door.came.clear()
                await self.door.came.wait()

    async def close(self) -> None:
        """Drop the connection."""
        self._put.put_nowait({"type": "websocket.disconnect", "code": 1001})
        await self._task


async def asked(
    app: ASGIApp, method: str, path: str, body: Any = None, cookie: str = ""
) -> tuple[int, str, bytes]:
    """Ask by HTTP; return status, cookies and body."""
    data = b"" if body is None else json.dumps(body).encode()
    came: list[Message] = []

    async def receive() -> Message:
        return {"type": "http.request", "body": data, "more_body": False}

    async def send(message: Message) -> None:
        came.append(message)

    path, _, query = path.partition("?")
    scope: dict[str, Any] = {**_scope(path, cookie), "type": "http", "method": method}
    scope["query_string"] = query.encode()
    scope["headers"] = [*scope["headers"], (b"content-type", b"application/json")]
    scope["headers"] += [(b"content-length", str(len(data)).encode())]
    await app(scope, receive, send)
    cookies = "; ".join(
        value.decode().split(";")[0] for name, value in came[0]["headers"] if name == b"set-cookie"
    )
    return int(came[0]["status"]), cookies, b"".join(part.get("body", b"") for part in came[1:])


@asynccontextmanager
async def running(app: ASGIApp) -> AsyncGenerator[None]:
    """Start an application, and end it."""
    told: asyncio.Queue[Message] = asyncio.Queue()
    done: asyncio.Queue[Message] = asyncio.Queue()
    task = asyncio.ensure_future(app({"type": "lifespan", "state": {}}, told.get, done.put))
    told.put_nowait({"type": "lifespan.startup"})
    assert (await done.get())["type"] == "lifespan.startup.complete"
    try:
        yield
    finally:
        told.put_nowait({"type": "lifespan.shutdown"})
        await task


def _scope(path: str, cookie: str) -> dict[str, Any]:
    host = HOST.encode()
    headers = [(b"host", host), (b"origin", b"http://" + host), (b"cookie", cookie.encode())]
    return {
        "path": path,
        "raw_path": path.encode(),
        "root_path": "",
        "scheme": "http",
        "http_version": "1.1",
        "query_string": b"",
        "headers": headers,
        "client": ("192.0.2.7", 1),
        "server": ("127.0.0.1", 8000),
        "subprotocols": [],
    }


async def _nowhere(_: Message) -> None:
    """Say it to nobody: frames go by the door."""
