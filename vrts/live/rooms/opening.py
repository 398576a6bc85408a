"""Rooms that are opened, changed and closed, and forget who was purged."""

import asyncio
from typing import Final, get_args

import msgspec
from msgspec import structs

from vrts.live.door import text_frame
from vrts.live.notices.announcement import Announcement
from vrts.live.notices.kept import EVERYWHERE, SOMEBODY, end_notice, notice_of
from vrts.live.protocol.coding import encode
from vrts.live.protocol.fields import Role
from vrts.live.protocol.from_server import Chat, Rooms, Stopped
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.again.folders import remove_all_closed
from vrts.live.rooms.control import ControlRight
from vrts.live.rooms.entering import send_away
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.room import Room
from vrts.live.rooms.telling.audience import EVERYBODY, Audience
from vrts.live.settings import SESSIONS
from vrts.live.store.accounts import existing
from vrts.live.store.bars import all_muted, bars_of
from vrts.live.store.branches import branch_of
from vrts.live.store.course.own_rooms import members, own_room_of
from vrts.live.store.database import Connection
from vrts.live.store.programs import end_closed_shelves, end_shelf
from vrts.live.store.rooms import (
    PURGES,
    KeptRoom,
    Line,
    close_room,
    keep_room,
    lines,
    notes_of,
    open_rooms,
)
from vrts.live.tokens import new_id

MOST_ROOMS: Final = 64


async def open_kept(hub: Hub) -> None:
    """Open the rooms that were open when the server ended."""
    hub.muted = await hub.database.do(all_muted)
    told = await hub.database.do(lambda connection: notice_of(connection, EVERYWHERE))
    if told is not None:
        hub.announcement = Announcement(*told[1:3], told.name, told.text, told.account or 0)
    await hub.database.do(end_closed_shelves)
    for kept in await hub.database.do(open_rooms):
        await open_room(hub, kept)
    sessions = hub.settings.folder / SESSIONS
    await asyncio.to_thread(remove_all_closed, sessions, list(hub.rooms))


async def make_room(hub: Hub, name: str, scene: str) -> Room:
    """Make a room."""
    if sum(room.shared for room in hub.rooms.values()) >= MOST_ROOMS:
        raise NotObeyed("limit", f"there are {MOST_ROOMS} rooms already", "close some")
    settings = hub.settings
    place = max((room.kept.place for room in hub.rooms.values()), default=0) + 1
    kept = KeptRoom(new_id(), name, scene, place, True, settings.turn_s, settings.idle_s)
    await hub.database.do(lambda connection: keep_room(connection, kept))
    return await open_room(hub, kept)


async def open_room(hub: Hub, kept: KeptRoom) -> Room:
    """Open a room that is kept."""
    room = Room(kept, control=ControlRight(kept.turn_s, kept.idle_s))
    for line in await hub.database.do(lambda connection: lines(connection, kept.id)):
        room.number = line.number
        to = line.reader_name
        role = "supervisor" if line.supervisor else None
        said = Chat(line.number, line.at, "", line.name, line.text, line.private, to, role)
        room.chat.append((said, _readers(line) if line.private else EVERYBODY))
    room.barred = await hub.database.do(lambda connection: bars_of(connection, kept.id))
    room.branch = await hub.database.do(lambda connection: branch_of(connection, kept.id))
    room.own = own = await hub.database.do(lambda connection: own_room_of(connection, kept.id))
    if own is not None:
        room.owners = await hub.database.do(lambda connection: members(connection, own))
        room.rest = "asleep"
    room.stopped = await hub.database.do(lambda connection: _stopped(connection, kept.id))
    hub.rooms[kept.id] = room
    if room.shared:
        hub.projector = hub.projector or kept.id
    return room


async def close(hub: Hub, room: Room) -> None:
    """End a room for good."""
    await hub.database.do(lambda connection: _close(connection, room.id))
    hub.rooms.pop(room.id, None)
    if hub.projector == room.id:
        hub.projector = next((r.id for r in hub.rooms.values() if r.shared), "")
    for member in list(room.members.values()):
        left = Rooms(hub.entries(member.account), hub.projector)  # a projector goes on with it
        member.send(text_frame(encode(left)))
        send_away(hub, member, "room closed", "the room was closed")
    room.wake.set()  # it may wait for its supervisor, or for its turn to begin a session
    if room.process is not None:
        room.process.stop()
    hub.rooms_changed()


async def change(hub: Hub, room: Room, kept: KeptRoom) -> None:
    """Keep what was changed about a room."""
    room.kept = kept
    room.control.turn_s, room.control.idle_s = kept.turn_s, kept.idle_s
    await hub.database.do(lambda connection: keep_room(connection, kept))


def _close(connection: Connection, room: str) -> None:
    close_room(connection, room)
    end_shelf(connection, room)
    end_notice(connection, room)


def _stopped(connection: Connection, room: str) -> Stopped | None:
    """Return who had stopped the arm of a room, and it has not moved since."""
    kept = notice_of(connection, room)
    if kept is None:
        return None
    role = kept.text if kept.text in get_args(Role) else None
    return Stopped(kept.at, "", kept.name, msgspec.convert(role, Role | None))


def _readers(line: Line) -> Audience:
    """Return who may read a private line: its two ends and the supervisors."""
    ends = (line.account, line.reader)
    return Audience(accounts=frozenset(end for end in ends if end is not None), supervisors=True)


def _purges(connection: Connection) -> int:
    """Return how often somebody was purged."""
    row = connection.execute("SELECT value FROM counter WHERE name=?", (PURGES,)).fetchone()
    return int(row[0]) if row else 0


async def forget_purged(hub: Hub) -> None:
    """Give rooms the names and the chat that the database has, when somebody was purged."""
    count = await hub.database.do(_purges)
    if hub.purges in (-1, count):
        hub.purges = count
        return
    told = hub.announcement
    if told is not None:
        there = await hub.database.do(lambda connection: existing(connection, (told.account,)))
        row = await hub.database.do(lambda connection: notice_of(connection, EVERYWHERE))
        if not there and hub.announcement is told:
            hub.announcement = None
            hub.show_announcement()
        elif row is not None and row.number == told.id and row.text != told.text:
            told.text = row.text
            hub.show_announcement()
    names = {kept.id: kept.name for kept in await hub.database.do(open_rooms)}
    for room in list(hub.rooms.values()):
        noted = list(room.notes)
        said = await hub.database.do(lambda connection, room=room: lines(connection, room.id))
        kept = await hub.database.do(lambda connection, room=room: notes_of(connection, room.id))
        there = {(note.at_s, note.name) for note in kept}
        room.notes = [n for n in room.notes if n not in noted or (n.at_s, n.name) in there]
        room.have_said(_left(room, said))
        stop = await hub.database.do(lambda connection, room=room: notice_of(connection, room.id))
        by = None if room.stopped is None else room.stopped.name
        if stop is not None and stop.account is None and by is not None and by != SOMEBODY:
            room.forget(by)
        room.kept = room.kept._replace(name=names.get(room.id, room.kept.name))
    hub.purges = count  # not before all is forgotten: what fails is done again
    hub.rooms_changed()


def _left(room: Room, said: list[Line]) -> list[tuple[Chat, Audience]]:
    """Return the lines that are still there, as they are now, and those said meanwhile."""
    there = {line.number: line.text for line in said}
    last = max(there, default=0)
    return [
        (structs.replace(chat, text=there.get(chat.number, chat.text)), to)
        for chat, to in room.chat
        if chat.number in there or (said and chat.number > last)
    ]
