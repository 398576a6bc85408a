"""One WebSocket: who it is, the first message, then one message after another.

PANIC overtakes: messages are read while an earlier one is still being obeyed. Commands that came
before it and wait are not carried out after it. Only where the right to it may be among what waits,
such as a request for control, it waits as well.
"""

import asyncio
from typing import Any, Final, NamedTuple

import msgspec
from starlette.websockets import WebSocket

from vrts.live import limits
from vrts.live.door import Door, door_of, text_frame
from vrts.live.front.guard import refused
from vrts.live.lasting.clock import steady
from vrts.live.protocol.coding import decode, encode
from vrts.live.protocol.fields import VERSION
from vrts.live.protocol.from_anybody import AskProgram, AskReach, Command, GoOnFrom, Join, Panic
from vrts.live.protocol.from_clients import FromClient
from vrts.live.protocol.from_server import Closed, Refused
from vrts.live.protocol.from_supervisors import ExportLog
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.entering import drop, enter, make_way_for_one
from vrts.live.rooms.hub import DISK_HELP, NO_DISK, Hub
from vrts.live.rooms.member import Member
from vrts.live.rooms.obeying import may_panic, obey
from vrts.live.rooms.sessions import Sessions
from vrts.live.store.accounts import Account
from vrts.live.store.waiting.journal import NO_ROOM

JOIN_S: Final = 10.0  # until the first message must be there
MOST_BAD: Final = 20  # messages that cannot be read, after which a connection ends
MOST_WAITING: Final = 120  # messages of a connection behind one that takes long
LONGEST_WAITING: Final = 1_000_000  # characters of them
TOO_MANY: Final = "too many messages wait for one that takes long"
STOPPED: Final = "the arm was stopped before it was carried out"


async def serve_socket(
    hub: Hub,
    sessions: Sessions,
    websocket: WebSocket,
    account: Account | None,
    browsers: frozenset[bytes],
) -> None:
    """Serve a connection until it ends; `Host` and `Origin` were looked at before.

    Args:
        hub: Where it goes.
        sessions: Of the hub.
        websocket: The connection.
        account: Whose it is; None: nobody's, so it is refused.
        browsers: What the browser is known by.
    """
    if account is None:
        refusal = refused(401, "login", "nobody is logged in", "open the join link again")
        await websocket.send_denial_response(refusal)
        return
    address = websocket.client.host if websocket.client else ""
    full = not account.supervisor and not make_way_for_one(hub, address)
    if hub.stopping or full:
        refusal = refused(503, "limit", "the server takes no more connections", "come back later")
        await websocket.send_denial_response(refusal)
        return
    await websocket.accept()
    door = door_of(websocket.scope)
    hub.unjoined[door] = None
    if len(hub.unjoined) > limits.UNJOINED:
        next(iter(hub.unjoined)).abort()  # an honest page joins at once
    try:
        joining = _join(hub, websocket, account, door, address, browsers)
        member = await asyncio.wait_for(joining, JOIN_S)
    except TimeoutError:
        _end(door, Closed("join", "no `join` came"))
        return
    finally:
        hub.unjoined.pop(door, None)
    if member is None:
        return
    try:
        await _listen(hub, sessions, websocket, member, door)
    finally:
        drop(hub, member, door)


async def _join(
    hub: Hub,
    websocket: WebSocket,
    account: Account,
    door: Door,
    address: str,
    browsers: frozenset[bytes],
) -> Member | None:
    text = await _receive(websocket)
    if text is None:
        return None
    try:
        message = decode(text)
    except msgspec.DecodeError as problem:
        _end(door, Closed("message", str(problem)))
        return None
    if not isinstance(message, Join):
        _end(door, Closed("join", "the first message must be `join`"))
        return None
    if message.version != VERSION:
        _end(door, Closed("version", "the page is of another version: load it again"))
        return None
    try:
        return enter(hub, account, message, door, address=address, browsers=browsers)
    except NotObeyed as refusal:
        _end(door, Closed(refusal.code, refusal.text))
        return None


async def _listen(
    hub: Hub, sessions: Sessions, websocket: WebSocket, member: Member, door: Door
) -> None:
    """Read until the connection ends, and obey what was said until then."""
    waiting = _Waiting()
    async with asyncio.TaskGroup() as both:
        both.create_task(_obey_all(hub, sessions, member, door, waiting))
        while (text := await _receive(websocket)) is not None:
            if member.door is not door:
                break  # sent away, or back on another connection
            member.heard = steady()
            try:
                message = decode(text)
            except msgspec.DecodeError as problem:
                member.bad += 1
                member.tell(Refused(0, "message", str(problem)))
            else:
                came = _Came(message, len(text), member.heard)
                if isinstance(message, Panic) and not (waiting.any and _may_not(hub, member)):
                    await _obey(hub, sessions, member, message)  # at once: it waits for nothing
                elif not waiting.put(came):
                    member.excess += 1
                    member.tell(Refused(_number(message), "rate", TOO_MANY, "slow down"))
            if member.bad > MOST_BAD or member.excess > limits.EXCESS:
                _end(door, Closed("message", "too many messages that make no sense"))
                break
        waiting.end()


class _Came(NamedTuple):
    """A message that came."""

    message: FromClient
    length: int  # characters
    at: float  # of a clock that only goes on [s]


class _Waiting:
    """Messages of a connection that came while another was being obeyed, in order."""

    def __init__(self) -> None:
        self._queue: asyncio.Queue[_Came | None] = asyncio.Queue()
        self._length = 0

    @property
    def any(self) -> bool:
        """Whether one waits."""
        return not self._queue.empty()

    def put(self, came: _Came) -> bool:
        """Let a message wait; return whether there was room."""
        if self._queue.qsize() >= MOST_WAITING or self._length > LONGEST_WAITING:
            return False
        self._length += came.length
        self._queue.put_nowait(came)
        return True

    def end(self) -> None:
        """Say that no more come."""
        self._queue.put_nowait(None)

    async def next(self) -> _Came | None:
        """Return the first one, None when no more come."""
        came = await self._queue.get()
        if came is not None:
            self._length -= came.length
        return came


def _may_not(hub: Hub, member: Member) -> bool:
    """Return whether somebody may not stop the arm now; what waits may give the right to."""
    room = hub.rooms.get(member.room)
    return room is not None and not may_panic(room, member)


async def _obey_all(
    hub: Hub, sessions: Sessions, member: Member, door: Door, waiting: _Waiting
) -> None:
    """Obey one message after another."""
    while (came := await waiting.next()) is not None:
        if member.door is not door:
            return  # what they said last counts no more
        room = hub.rooms.get(member.room)
        if isinstance(came.message, Command) and room is not None and came.at < room.panicked:
            member.tell(Refused(came.message.number, "stopped", STOPPED))
        else:
            await _obey(hub, sessions, member, came.message)


async def _obey(hub: Hub, sessions: Sessions, member: Member, message: FromClient) -> None:
    """Do what a message asks for, or tell why not."""
    of = _number(message)
    try:
        await obey(hub, sessions, member, message)
    except NotObeyed as refusal:
        member.tell(Refused(of, refusal.code, refusal.text, refusal.help))
    except NO_ROOM:
        member.tell(Refused(of, "disk", NO_DISK, DISK_HELP))


async def _receive(websocket: WebSocket) -> str | None:
    """Return the next message, None when the connection has ended or is not ours."""
    event: dict[str, Any] = dict(await websocket.receive())
    if event["type"] == "websocket.disconnect":
        return None
    text = event.get("text")
    return text if isinstance(text, str) else ""  # bytes: read as a message of nothing


def _number(message: FromClient) -> int:
    match message:
        case Command():
            return message.number
        case AskReach() | AskProgram() | GoOnFrom() | ExportLog():
            return message.of
        case _:
            return 0


def _end(door: Door, closed: Closed) -> None:
    door.send(text_frame(encode(closed)))
    door.finish()
