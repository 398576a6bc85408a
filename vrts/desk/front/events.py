"""What happens, as server-sent events: that something changed, and how far marking again is."""

import asyncio
from collections.abc import AsyncGenerator
from typing import Final

import msgspec
from starlette.requests import Request
from starlette.responses import Response, StreamingResponse

from vrts.desk.front.answers import refusal
from vrts.desk.front.shapes import with_shapes

MOST: Final = 24  # browsers and tabs that listen
WAITING: Final = 64  # events for one of them; who takes none loses the oldest
BREATH_S: Final = 10.0  # between signs of life


class Events:
    """Who listens."""

    def __init__(self) -> None:
        """Begin with nobody."""
        self._listeners: set[asyncio.Queue[bytes | None]] = set()
        self._ended = False

    @property
    def listened(self) -> bool:
        """Whether anybody listens."""
        return bool(self._listeners)

    def send(self, name: str, value: object) -> None:
        """Tell everybody."""
        data = with_shapes(msgspec.json.encode(value))
        event = b"event: %s\ndata: %s\n\n" % (name.encode(), data)
        for queue in self._listeners:
            if queue.full():
                queue.get_nowait()
            queue.put_nowait(event)

    def end(self) -> None:
        """Send everybody away; nobody can come any more."""
        self._ended = True
        for queue in self._listeners:
            if queue.full():
                queue.get_nowait()
            queue.put_nowait(None)

    async def listen(self, request: Request) -> Response:
        """Answer with events as they come."""
        if self._ended or len(self._listeners) >= MOST:
            return refusal(429, "too many pages are open that follow this")
        queue: asyncio.Queue[bytes | None] = asyncio.Queue(WAITING)
        headers = {"cache-control": "no-store", "x-accel-buffering": "no"}
        return StreamingResponse(
            self._events(queue), headers=headers, media_type="text/event-stream"
        )

    async def _events(self, queue: "asyncio.Queue[bytes | None]") -> AsyncGenerator[bytes, None]:
        self._listeners.add(queue)  # here: who left before this began is never counted
        try:
            yield b"retry: 1000\n: hello\n\n"
            while True:
                try:
                    event = await asyncio.wait_for(queue.get(), BREATH_S)
                except TimeoutError:
                    event = b": still here\n\n"
                if event is None:
                    return
                yield event
        finally:
            self._listeners.discard(queue)
