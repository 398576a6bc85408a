"""The way to a rehearsal: who may have one, and in which scene or task it takes place."""

import asyncio
import hashlib
from collections.abc import Awaitable, Callable
from typing import Final

from starlette.websockets import WebSocket

from vrts.live.front.guard import refused
from vrts.live.lasting.clock import steady
from vrts.live.refusal import NotObeyed
from vrts.live.rehearsing.asked import Begin, Rehearse
from vrts.live.rehearsing.offering import Rehearsals, Whose
from vrts.live.rehearsing.talk import AWAY, LOGGED_OUT, NO_SCENE, Offered, serve_rehearsal
from vrts.live.rehearsing.told import Closed
from vrts.live.rooms.hub import DISK_HELP, NO_DISK, Hub
from vrts.live.rooms.room import Room
from vrts.live.session.channel.messages import Start
from vrts.live.store.accounts import Account
from vrts.live.store.waiting.journal import NO_ROOM

STATE_S: Final = 30.0  # until the session must have told its state


async def rehearsal_socket(
    hub: Hub,
    rehearsals: Rehearsals,
    websocket: WebSocket,
    who: Callable[[], Awaitable[Account | None]],
) -> None:
    """Serve a rehearsal to somebody who is in a room; `Host` and `Origin` were looked at before.

    Args:
        hub: Where the rooms are.
        rehearsals: Of the server.
        websocket: Of the page; it names the room.
        who: Tells whose cookie it has, now and later; it may raise `NO_ROOM`.
    """
    try:
        account = await who()
    except NO_ROOM:
        await websocket.send_denial_response(refused(503, "disk", NO_DISK, DISK_HELP))
        return
    if account is None:
        refusal = refused(401, "login", "nobody is logged in", "open the join link again")
        await websocket.send_denial_response(refusal)
        return
    room = hub.rooms.get(websocket.query_params.get("room", ""))
    if room is None or not _is_in(room, account):
        refusal = refused(403, "room", "only people in a room may rehearse there")
        await websocket.send_denial_response(refusal)
        return

    async def still() -> Closed | None:
        try:
            now = await who()
        except NO_ROOM:  # nobody logs out or is purged then
            now = account
        if now is None or now.id != account.id:
            return LOGGED_OUT
        return None if hub.rooms.get(room.id) is room and _is_in(room, account) else AWAY

    async def where(order: Rehearse) -> Begin:
        place = hub.place(room)
        if place is None:
            raise NotObeyed("scene", NO_SCENE)
        drawn = b"" if room.process is None else room.process.scene
        sha256 = hashlib.sha256(drawn).hexdigest() if drawn else ""
        where = Start(room.session, "", place.scene, place.task, place.lab, scene_sha256=sha256)
        if order.begins == "start":
            return Begin(where, order)
        if not rehearsals.nows.take(account.id, steady()):
            raise NotObeyed("rate", "you rehearse from now very often: wait a moment")
        return Begin(where, order, await _state(room))

    whose = Whose(account.id, room.id)
    await serve_rehearsal(Offered(rehearsals, whose, where, still), websocket)


async def _state(room: Room) -> str:
    """Return the state of a room's session, as it is now.

    Raises:
        NotObeyed: It cannot be had.
    """
    process = room.process
    if process is None or not process.ready or process.behind:
        raise NotObeyed("session", "the room's session is not ready yet: wait a moment")
    try:
        answer = await asyncio.wait_for(process.state(), STATE_S)
    except TimeoutError:
        raise NotObeyed("busy", "the room's session did not answer in time") from None
    if answer.why:
        raise NotObeyed("session", answer.why)
    return answer.data


def _is_in(room: Room, account: Account) -> bool:
    return any(member.account.id == account.id for member in room.members.values())
