"""One WebSocket: who it is, the first message, then one message after another."""

import asyncio
import time
from typing import Any, Final

import msgspec
from starlette.websockets import WebSocket

from vrts.live import limits
from vrts.live.door import Door, door_of, text_frame
from vrts.live.front.guard import refused
from vrts.live.protocol.coding import decode, encode
from vrts.live.protocol.fields import VERSION
from vrts.live.protocol.from_anybody import AskProgram, AskReach, Command, GoOnFrom, Join
from vrts.live.protocol.from_clients import FromClient
from vrts.live.protocol.from_server import Closed, Refused
from vrts.live.protocol.from_supervisors import ExportLog
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.entering import drop, enter, make_way_for_one
from vrts.live.rooms.hub import DISK_HELP, NO_DISK, Hub
from vrts.live.rooms.member import Member
from vrts.live.rooms.obeying import obey
from vrts.live.rooms.sessions import Sessions
from vrts.live.store.accounts import Account
from vrts.live.store.waiting.journal import NO_ROOM

JOIN_S: Final = 10.0  # until the first message must be there
MOST_BAD: Final = 20  # messages that cannot be read, after which a connection ends


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
    if hub.stopping or not make_way_for_one(hub):
        refusal = refused(503, "limit", "the server takes no more connections", "come back later")
        await websocket.send_denial_response(refusal)
        return
    await websocket.accept()
    door = door_of(websocket.scope)
    try:
        member = await asyncio.wait_for(_join(hub, websocket, account, door), JOIN_S)
    except TimeoutError:
        _end(door, Closed("join", "no `join` came"))
        return
    if member is None:
        return
    member.browsers = browsers
    member.address = websocket.client.host if websocket.client else ""
    try:
        await _listen(hub, sessions, websocket, member, door)
    finally:
        drop(hub, member, door)


async def _join(hub: Hub, websocket: WebSocket, account: Account, door: Door) -> Member | None:
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
        return enter(hub, account, message, door)
    except NotObeyed as refusal:
        _end(door, Closed(refusal.code, refusal.text))
        return None


async def _listen(
    hub: Hub, sessions: Sessions, websocket: WebSocket, member: Member, door: Door
) -> None:
    while (text := await _receive(websocket)) is not None:
        if member.door is not door:
            return  # sent away, or back on another connection
        member.heard = time.monotonic()
        of = 0
        try:
            message = decode(text)
            of = _number(message)
            await obey(hub, sessions, member, message)
        except msgspec.DecodeError as problem:
            member.bad += 1
            member.tell(Refused(0, "message", str(problem)))
        except NotObeyed as refusal:
            answer = Refused(of, refusal.code, refusal.text, refusal.help)
            member.tell(answer)
        except NO_ROOM:
            member.tell(Refused(of, "disk", NO_DISK, DISK_HELP))
        if member.bad > MOST_BAD or member.excess > limits.EXCESS:
            _end(door, Closed("message", "too many messages that count for nothing"))
            return


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
