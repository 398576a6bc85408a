"""One WebSocket of a rehearsal: questions of a browser in, answers of its process out."""

import asyncio
from collections import deque
from collections.abc import Awaitable, Callable
from typing import Any, Final, NamedTuple

import msgspec
from starlette.websockets import WebSocket, WebSocketDisconnect

from vrts.live.editing.first_ended import first_ended
from vrts.live.editing.seats import Seat
from vrts.live.lasting.clock import steady
from vrts.live.limits import Bucket
from vrts.live.refusal import NotObeyed
from vrts.live.rehearsing.asked import (
    AskBlock,
    Asked,
    At,
    Begin,
    Breakpoints,
    Go,
    Rehearse,
    Stop,
    as_json,
    asked,
)
from vrts.live.rehearsing.offering import Rehearsals, Whose
from vrts.live.rehearsing.process import RehearsalProcess
from vrts.live.rehearsing.told import Closed, Ended, Refused, Told

RATE: Final = (20.0, 60.0)  # messages a second, and at once
MOST_ASKED: Final = 16  # questions that wait for their answers
MOST_BAD: Final = 20  # messages that mean nothing, after which a connection ends
PATIENCE_S: Final = 120.0  # for an answer; the process has less of the processor than this
ENOUGH_S: Final = 1.0  # after which a run that nobody wants any more is ended, with its process
IDLE_S: Final = 900.0  # without a question, after which the process ends
LOOK_S: Final = 0.5  # how often that is looked at, and whether the cookie still holds
SEND_S: Final = 20.0  # until a browser must have taken a message

ELSEWHERE: Final = Closed("elsewhere", "you rehearse in another tab of this room now")
LOGGED_OUT: Final = Closed("login", "you are not logged in any more")
AWAY: Final = Closed("room", "you are not in this room any more")
BAD: Final = Closed("message", "too many messages that make no sense")
TOO_MUCH: Final = Closed("limit", "too much was asked at once")

NO_SEAT: Final = "too many people rehearse now, or you rehearse too often: wait a minute"
TOO_OFTEN: Final = "you rehearse very often: wait a moment"
NO_PROCESS: Final = "the server cannot begin a rehearsal now: try again in a minute"
NO_SCENE: Final = "the server does not offer the scene of this room any more"
NONE: Final = "nothing is rehearsed"
BUSY: Final = "too many questions wait already"
UNREAD: Final = "this message means nothing here"
IDLE: Final = "nothing was asked for a while, so the rehearsal has ended: rehearse again"
WANTED: Final = "others needed the rehearsal's place meanwhile: rehearse again"
STUCK: Final = "the rehearsal took too long, and was ended"
OVER: Final = "the rehearsal is over"


class Offered(NamedTuple):
    """What a rehearsal needs of its server and its room."""

    rehearsals: Rehearsals
    whose: Whose
    where: Callable[[Rehearse], Awaitable[Begin]]  # raises NotObeyed
    still: Callable[[], Awaitable[Closed | None]]  # why they may rehearse no more


async def serve_rehearsal(offered: Offered, websocket: WebSocket) -> None:
    """Serve a connection until it ends; who it is was looked at before."""
    await websocket.accept()
    elsewhere = offered.rehearsals.connected(offered.whose)
    talk = _Talk(offered, websocket, elsewhere)
    try:
        await talk.go_on()
    finally:
        offered.rehearsals.left(offered.whose, elsewhere)
        await talk.end()


def _one_refused(question: Breakpoints | Go | At | AskBlock) -> Refused:
    """Say that one question comes too early; what was asked before is answered."""
    of = str(type(question).__struct_config__.tag)
    number = question.number if isinstance(question, AskBlock) else msgspec.UNSET
    return Refused(question.id, BUSY, of=of, number=number)


class _Talk:
    """Between one browser and one process."""

    def __init__(self, offered: Offered, websocket: WebSocket, elsewhere: asyncio.Event) -> None:
        self._offered = offered
        self._websocket = websocket
        self._elsewhere = elsewhere
        self._process: RehearsalProcess | None = None
        self._seat: Seat[Whose] | None = None
        self._answers: asyncio.Task[None] | None = None
        self._waiting: deque[float] = deque()  # questions that are not answered: since when [s]
        self._of = 0  # number of the rehearsal
        self._heard_s = steady()
        self._one_at_a_time = asyncio.Lock()  # who begins or ends the process

    async def go_on(self) -> None:
        """Pass on what is allowed, until one of them ends or must be ended."""
        why = await first_ended(self._listen(), self._watch())
        await self._end_process()
        if why is not None and await self._send(as_json(why)):
            try:
                await self._websocket.close(1000)
            except (WebSocketDisconnect, RuntimeError):
                return  # it is gone already

    async def end(self) -> None:
        """End what is left."""
        try:
            await self._end_process()
        finally:
            if self._seat is not None:
                self._offered.rehearsals.seats.give_back(self._seat)
                self._seat = None

    # --- in -----------------------------------------------------------------------------------

    async def _listen(self) -> Closed | None:
        """Take what the browser asks."""
        bucket, bad = Bucket(*RATE), 0
        while True:
            event: dict[str, Any] = dict(await self._websocket.receive())
            if event["type"] == "websocket.disconnect":
                return None
            self._heard_s = now = steady()
            if self._seat is not None:
                self._seat.heard_s = now
            if not bucket.take(now):
                return TOO_MUCH
            try:
                message = asked(event.get("text") or "")
            except (msgspec.DecodeError, UnicodeError):
                bad += 1
                if bad > MOST_BAD:
                    return BAD
                await self._tell(Refused(0, UNREAD))
                continue
            async with self._one_at_a_time:
                await self._take(message)

    async def _take(self, message: Asked) -> None:
        match message:
            case Rehearse():
                await self._rehearse(message)
            case Stop():
                await self.end()
                await self._tell(Ended(message.id, OVER))
            case _:
                process = self._process
                if process is None:
                    await self._tell(Refused(message.id, NONE))
                elif len(self._waiting) >= MOST_ASKED or process.behind:
                    await self._tell(_one_refused(message))
                else:
                    self._waiting.append(steady())
                    process.ask(message)

    async def _rehearse(self, order: Rehearse) -> None:
        """Have a text run, in the process that there is or in a new one."""
        if self._waiting and steady() - self._waiting[0] > ENOUGH_S:
            await self.end()  # what it still works at is of no use to anybody
        elif len(self._waiting) >= MOST_ASKED:
            await self._tell(Refused(order.id, BUSY))
            return
        if not self._offered.rehearsals.often.take(self._offered.whose.account, steady()):
            await self._tell(Refused(order.id, TOO_OFTEN))
            return
        try:
            begin = await self._offered.where(order)
        except NotObeyed as why:
            await self._tell(Refused(order.id, str(why)))
            return
        if self._seat is None:
            self._seat = self._offered.rehearsals.seats.take(self._offered.whose)
        if self._seat is None:
            await self._tell(Refused(order.id, NO_SEAT))
            return
        if self._process is None:
            try:
                self._process = await self._offered.rehearsals.process()
            except OSError:
                await self._tell(Refused(order.id, NO_PROCESS))
                return
            hearing = self._hear(self._process)
            self._answers = asyncio.get_running_loop().create_task(hearing)
        self._of = order.id  # only now: of the one before somebody may have to be told until here
        self._waiting.append(steady())
        self._process.ask(begin)

    # --- out ----------------------------------------------------------------------------------

    async def _hear(self, process: RehearsalProcess) -> None:
        """Pass on what the process answers, until it ends."""
        while (answer := await process.answer()) is not None:
            if self._waiting:
                self._waiting.popleft()
            await self._send(answer)
        self._waiting.clear()
        self._process = self._answers = None
        of = self._of
        await self._tell(Ended(of, await process.why()))

    async def _watch(self) -> Closed:
        """Return when they may rehearse no more; end a process that nobody needs or that hangs."""
        while not self._elsewhere.is_set():
            try:
                await asyncio.wait_for(self._elsewhere.wait(), LOOK_S)
            except TimeoutError:
                pass
            else:
                break
            if (why := await self._offered.still()) is not None:
                return why
            if self._unneeded():
                await self._put_away()
        return ELSEWHERE

    def _unneeded(self) -> str:
        """Return why a rehearsal is to be ended; empty: it is not."""
        now = steady()
        if self._seat is None:
            return ""
        if self._seat.taken.is_set():
            return WANTED
        if self._waiting and now - self._waiting[0] > PATIENCE_S:
            return STUCK
        return IDLE if now - self._heard_s > IDLE_S else ""

    async def _put_away(self) -> None:
        """End the rehearsal, if there is still a reason when it is its turn."""
        async with self._one_at_a_time:
            why, of = self._unneeded(), self._of
            if not why:
                return
            await self.end()
        await self._tell(Ended(of, why))

    async def _end_process(self) -> None:
        process, answers = self._process, self._answers
        self._process = self._answers = None
        self._waiting.clear()
        if answers is not None:
            answers.cancel()
        if process is not None:
            await process.end()  # killed before anything is awaited, which may be cancelled
        if answers is not None:
            await asyncio.gather(answers, return_exceptions=True)

    async def _tell(self, message: Told) -> None:
        await self._send(as_json(message))

    async def _send(self, data: bytes) -> bool:
        """Send a message; return whether somebody takes it."""
        try:
            async with asyncio.timeout(SEND_S):
                await self._websocket.send_text(data.decode())
        except (WebSocketDisconnect, TimeoutError, RuntimeError):
            return False  # it is gone: `_listen` ends
        return True
