"""One WebSocket of an editor: questions about its text in, a language server's answers out."""

import asyncio
from collections.abc import Awaitable, Callable
from typing import Any, Final

import msgspec
from starlette.websockets import WebSocket, WebSocketDisconnect

from vrts.live.editing.asked import Asked, Change, Open, asked, initialize, request
from vrts.live.editing.first_ended import first_ended
from vrts.live.editing.helper import Helper, begun
from vrts.live.editing.seats import Seat, Seats
from vrts.live.editing.told import answered, as_json, diagnostics
from vrts.live.front.guard import refused
from vrts.live.lasting.clock import steady
from vrts.live.limits import Bucket
from vrts.live.store.accounts import Account

RATE: Final = (40.0, 120.0)  # messages a second, and at once
MOST_ASKED: Final = 16  # questions that wait for their answers
MOST_BAD: Final = 20  # messages that mean nothing, after which a connection ends
PATIENCE_S: Final = 20.0  # for an answer
IDLE_S: Final = 900.0  # without a message, after which the help ends; it comes back when asked
LOOK_S: Final = 0.5  # how often that is looked at, and whether the cookie still holds
SEND_S: Final = 20.0  # until a browser must have taken a message

ELSEWHERE: Final = ("elsewhere", "your editor is open in another tab, where the help is now")
IDLE: Final = ("idle", "nothing was written for a while: the help comes back when you write")
WANTED: Final = ("idle", "others needed the help meanwhile: it comes back when you write")
LOGGED_OUT: Final = ("login", "you are not logged in any more")
STUCK: Final = ("stuck", "the help took too long and was ended; it begins again")
GONE: Final = ("gone", "the help has ended; it begins again")
BAD: Final = ("message", "too many messages that make no sense")
TOO_MUCH: Final = ("limit", "too much was asked at once")


async def serve_help(
    seats: Seats[int],
    websocket: WebSocket,
    account: Account | None,
    still: Callable[[], Awaitable[bool]],
) -> None:
    """Serve an editor until it ends; `Host` and `Origin` were looked at before.

    Args:
        seats: Of the server.
        websocket: Of the editor.
        account: Whose it is; None: nobody is logged in.
        still: Tells whether the account is still there, and logged in.
    """
    if account is None:
        refusal = refused(401, "login", "nobody is logged in", "open the join link again")
        await websocket.send_denial_response(refusal)
        return
    seat = seats.take(account.id)
    if seat is None:
        refusal = refused(503, "limit", "there is no help left at the moment", "try again later")
        await websocket.send_denial_response(refusal)
        return
    helper: Helper | None = None
    try:
        await websocket.accept()
        helper = await begun(seats.folder)
        await _Talk(websocket, helper, seat, still).go_on()
    finally:
        seats.give_back(seat)
        if helper is not None:
            await helper.end()


class _Talk:
    """Between one browser and one language server."""

    def __init__(
        self,
        websocket: WebSocket,
        helper: Helper,
        seat: Seat[int],
        still: Callable[[], Awaitable[bool]],
    ) -> None:
        self._websocket = websocket
        self._helper = helper
        self._seat = seat
        self._still = still
        self._waiting: dict[int, tuple[Asked, float]] = {}  # and since when [s]
        self._opened = False
        self._ready = asyncio.Event()

    async def go_on(self) -> None:
        """Pass on what is allowed, until one of them ends or must be ended."""
        why = await first_ended(self._listen(), self._answer(), self._watch(), self._taken())
        if why is not None:
            try:
                await self._send(as_json({"method": "closed", "code": why[0], "text": why[1]}))
                await self._websocket.close(1000)
            except (WebSocketDisconnect, TimeoutError, RuntimeError):
                return  # it is gone already

    async def _listen(self) -> tuple[str, str] | None:
        """Take what the browser asks."""
        bucket, bad = Bucket(*RATE), 0
        self._helper.tell(initialize())
        await self._ready.wait()
        while True:
            event: dict[str, Any] = dict(await self._websocket.receive())
            if event["type"] == "websocket.disconnect":
                return None
            self._seat.heard_s = now = steady()
            if not bucket.take(now) or self._helper.behind:
                return TOO_MUCH
            message = self._read(event.get("text") or "")
            if message is not None:
                await self._pass_on(message, now)
                continue
            bad += 1
            if bad > MOST_BAD:
                return BAD
            await self._send(as_json({"method": "refused"}))

    def _read(self, text: str) -> Asked | None:
        """Return a message; None when it is none of ours, or comes when it means nothing.

        A text is opened once, and before all else.
        """
        try:
            message = asked(text)
        except msgspec.DecodeError:
            return None
        if isinstance(message, Open):
            opens, self._opened = not self._opened, True
            return message if opens else None
        known = getattr(message, "id", 0) in self._waiting
        return message if self._opened and not known else None

    async def _pass_on(self, message: Asked, now: float) -> None:
        if not isinstance(message, Open | Change):
            if len(self._waiting) >= MOST_ASKED:
                await self._send(as_json({"id": message.id, "result": None, "busy": True}))
                return
            self._waiting[message.id] = message, now
        self._helper.tell(request(message))

    async def _answer(self) -> tuple[str, str] | None:
        """Pass on what the language server answers."""
        try:
            async for answer in self._helper.heard():
                if answer.method == "textDocument/publishDiagnostics":
                    await self._send(diagnostics(answer.params))
                elif answer.method and answer.id is not None:
                    self._helper.tell(
                        {"id": answer.id, "result": None}
                    )  # it asks: there is nothing
                elif answer.id == 0:
                    self._helper.tell({"method": "initialized", "params": {}})
                    self._ready.set()
                    await self._send(as_json({"method": "ready"}))
                elif isinstance(answer.id, int) and answer.id in self._waiting:
                    question, _ = self._waiting.pop(answer.id)
                    await self._send(answered(question, answer.result))
        except (WebSocketDisconnect, RuntimeError):
            return None  # the browser is gone
        return GONE

    async def _watch(self) -> tuple[str, str]:
        """Return when nobody writes any more or is logged in, or no answer comes."""
        while True:
            await asyncio.sleep(LOOK_S)
            now = steady()
            if now - self._seat.heard_s > IDLE_S:
                return IDLE
            if not await self._still():
                return LOGGED_OUT
            if any(now - since > PATIENCE_S for _, since in self._waiting.values()):
                return STUCK

    async def _taken(self) -> tuple[str, str]:
        await self._seat.taken.wait()
        return WANTED if self._seat.wanted else ELSEWHERE

    async def _send(self, data: bytes) -> None:
        async with asyncio.timeout(SEND_S):
            await self._websocket.send_text(data.decode())
