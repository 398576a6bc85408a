"""What is kept of a room while it happens: its log, and what is said in it."""

import asyncio
import contextlib
from collections.abc import Callable
from typing import Final

from vrts.live import limits
from vrts.live.lasting.clock import wall
from vrts.live.notices.kept import EVERYWHERE, KeptNotice, keep_wanted
from vrts.live.protocol.coding import encode
from vrts.live.protocol.from_server import Chat, Stopped
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.member import Member
from vrts.live.rooms.room import Asked, Room
from vrts.live.rooms.telling.audience import EVERYBODY, Audience
from vrts.live.store import log as store_log
from vrts.live.store.accounts import Account
from vrts.live.store.database import Connection
from vrts.live.store.log import Entry
from vrts.live.store.rooms import Line, keep_line
from vrts.live.store.waiting.journal import NO_ROOM

LOG_FULL: Final = "the log of this session is full, so nothing more can be done in it but panic"
LOG_HELP: Final = "a supervisor can begin another session: choose the scene again"
OFTEN: Final = {  # records that everybody can cause, and what is said when there are too many
    "control": f"control has changed {limits.RECORDS} times in this session: from now on the log"
    " does not tell who has it, but still whose each command is",
    "join": f"{limits.RECORDS} people have come into this session: from now on the log does not"
    " tell who comes, but still whose each command is",
}


def record(
    hub: Hub, room: Room, kind: str, account: Account | None, what: dict[str, object]
) -> None:
    """Put something that is no command into the log; what comes very often only so often."""
    if kind in OFTEN:
        room.recorded[kind] += 1
        if room.recorded[kind] > limits.RECORDS:
            if room.recorded[kind] == limits.RECORDS + 1:
                hub.spawn(announce(hub, room, OFTEN[kind]))
            return
    text = encode(what).decode()
    known = None if kind == "begin" else room.reached
    at_s = 0.0 if known is None else known.time_s
    entry = stamped(room, kind, account, text, at_s=at_s, accepted=True)
    log_soon(hub, entry, needed=kind not in OFTEN)


def control_changed(hub: Hub, room: Room) -> None:
    """Tell and record who has the control right."""
    room.show_control()
    room.tell_people_soon()
    holder = room.members.get(room.control.holder)
    record(hub, room, "control", None if holder is None else holder.account, {})


def log_soon(hub: Hub, entry: Entry, *, needed: bool = True) -> "asyncio.Future[None]":
    """Put an entry into the log after all that were put before; return when it is written.

    It is written after a while if there is no room for it now, as long as not too many wait.
    """
    room = hub.rooms.get(entry.room)
    if room is not None:
        room.logged += store_log.RECORD + len(entry.text)
        if room.logged > hub.settings.log_quota and not room.log_full:
            room.log_full = True
            hub.spawn(announce(hub, room, f"{LOG_FULL}; {LOG_HELP}"))
    return hub.journal.put(entry, needed=needed)


def stamped(
    room: Room,
    kind: str,
    account: Account | None,
    text: str,
    *,
    at_s: float,
    accepted: bool,
) -> Entry:
    """Return a record of the log, stamped now."""
    id_, name = (None, "") if account is None else (account.id, account.name)
    return Entry(room.id, room.session, at_s, wall(), kind, accepted, id_, name, text)


def show_stopped(hub: Hub, room: Room, by: Asked) -> None:
    """Tell everybody who has stopped the arm, also after a restart, until it moves again."""
    at, role = wall(), room.role_of(by.person)
    room.stopped = Stopped(at, by.person, by.name, role)
    room.show(room.stopped)
    notice = KeptNotice(room.id, 0, at, by.account, by.name, role or "")
    keep_notice_soon(hub, room.id, notice)


def end_stopped(hub: Hub, room: Room) -> None:
    """Tell everybody that this is over, if there was anything."""
    if room.stopped is not None:
        room.stopped = None
        room.show(Stopped(0.0))
        keep_notice_soon(hub, room.id, None)


def keep_notice_soon(hub: Hub, room: str, notice: KeptNotice | None) -> None:
    """Keep what everybody has to see after a restart too, once the disk has room; None: nothing."""
    hub.unkept[room] = (notice,)
    hub.spawn(keep_notices(hub))


async def keep_notices(hub: Hub) -> None:
    """Keep the notices that are not kept yet; where there is no room now, they stay wanted."""
    for room, wanted in list(hub.unkept.items()):
        if room not in hub.rooms and room != EVERYWHERE:
            hub.unkept.pop(room, None)
            continue
        try:
            await hub.database.do(lambda c, r=room, w=wanted: keep_wanted(c, r, *w))
        except NO_ROOM:
            return
        if hub.unkept.get(room) is wanted:
            del hub.unkept[room]


async def announce(hub: Hub, room: Room, text: str) -> None:
    """Say something as the server; where it cannot be kept it is told all the same."""
    try:
        await say(hub, room, None, text, EVERYBODY, None)
    except NO_ROOM:
        number = room.next_number()
        room.tell(Chat(number, wall(), "", "", text), number)


async def keep_soon(hub: Hub, job: Callable[[Connection], None]) -> None:
    """Write what is written again before long, or is of no use then."""
    with contextlib.suppress(NO_ROOM):
        await hub.database.do(job)


async def say(
    hub: Hub, room: Room, speaker: Member | None, text: str, to: Audience, reader: Account | None
) -> None:
    """Keep a line of chat, then tell it; it is acknowledged by being told."""
    number, at = room.next_number(), wall()
    account = None if speaker is None else speaker.account
    name = "" if account is None else account.name
    private = not to.everybody
    id_, read_by = (one.id if one else None for one in (account, reader))
    line = Line(room.id, number, at, id_, name, text, private, read_by)
    await hub.database.do(lambda connection: keep_line(connection, line))
    shown_to = reader.name if reader else ""
    role = room.role(speaker) if speaker else None
    said = Chat(number, at, speaker.id if speaker else "", name, text, private, shown_to, role)
    room.chat.append((said, to))
    room.tell(said, number, to)
