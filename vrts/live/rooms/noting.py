"""Notes that people put at a moment of a session: logged, and told to everybody in the room."""

import asyncio
from typing import Final

import msgspec

from vrts.live.actions import Rewind
from vrts.live.names import readable
from vrts.live.protocol.coding import encode
from vrts.live.protocol.from_server import Noted
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import DISK_HELP, NO_DISK, Hub
from vrts.live.rooms.keeping import LOG_FULL, LOG_HELP, log_soon, stamped
from vrts.live.rooms.member import Member
from vrts.live.rooms.room import Asked, Room
from vrts.live.store.rooms import KeptNote, notes_of

MOST_NOTES: Final = 200  # of a session that a page is told of, the last ones


class _Text(msgspec.Struct, frozen=True):
    text: str = ""


def put_note(hub: Hub, room: Room, member: Member, text: str, now: float) -> None:
    """Keep a note at this moment, then tell it.

    Raises:
        NotObeyed: Who asks may not, or there is no moment to put it at.
    """
    if member.id != room.control.holder and not member.supervisor:
        raise NotObeyed("role", "notes are for the operator and the supervisor")
    if member.account.id in hub.muted:
        raise NotObeyed("muted", "the supervisor has muted you")
    if not member.chat.take(now):
        raise NotObeyed("rate", "too many notes at once", "wait a few seconds")
    if hub.journal.problem:
        raise NotObeyed("disk", NO_DISK, DISK_HELP)
    if room.logged > hub.settings.log_quota:
        raise NotObeyed("log", LOG_FULL, LOG_HELP)
    words, reached = readable(text), room.reached
    if reached is None:
        raise NotObeyed("session", "the session is not ready yet", "wait a moment")
    if not words:
        raise NotObeyed("note", "a note needs a word")
    account, at_s = member.account, round(reached.time_s, 3)
    what = encode(_Text(words)).decode()
    entry = stamped(room, "note", account, what, at_s=at_s, accepted=True)
    hub.spawn(_tell(room, log_soon(hub, entry), at_s, account.name, words))


async def remember_notes(hub: Hub, room: Room) -> None:
    """Take up the notes of a session that goes on after the server was started again."""
    kept: list[KeptNote] = await hub.database.do(lambda connection: notes_of(connection, room.id))
    for note in kept[-MOST_NOTES:]:
        words = msgspec.json.decode(note.text, type=_Text).text
        room.notes.append(Noted(0, note.at_s, note.name, words))


def forget_notes(room: Room, asked: Asked) -> None:
    """Forget the notes that lie later than where a session went back to."""
    to_s = 0.0
    if asked.kind == "rewind":
        to_s = msgspec.json.decode(asked.action, type=Rewind).time_s
    room.notes = [note for note in room.notes if note.at_s <= to_s] if to_s else []


async def _tell(
    room: Room, written: "asyncio.Future[None]", at_s: float, name: str, text: str
) -> None:
    """Tell a note once it is written."""
    await written
    number = room.next_number()
    noted = Noted(number, at_s, name, text)
    room.notes = [*room.notes, noted][-MOST_NOTES:]
    room.tell(noted, number)
