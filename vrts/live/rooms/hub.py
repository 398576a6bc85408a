"""All rooms and everybody in them; what the sockets and sessions of the server meet in."""

import asyncio
import logging
import secrets
import time
from collections.abc import Coroutine
from typing import Any, Final

import msgspec

from vrts.live import limits
from vrts.live.door import Door, text_frame
from vrts.live.limits import FailedLogIns
from vrts.live.passwords import Passwords
from vrts.live.protocol.from_anybody import Join
from vrts.live.protocol.from_server import Chat, Closed, Message, Rooms, Snapshot, Wall, Welcome
from vrts.live.protocol.listed import RoomEntry, SceneEntry
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.control import ControlRight
from vrts.live.rooms.member import Member
from vrts.live.rooms.room import EVERYBODY, Audience, Room, encode
from vrts.live.settings import Settings
from vrts.live.store import log as store_log
from vrts.live.store.accounts import Account, existing
from vrts.live.store.bars import bars_of
from vrts.live.store.database import Database
from vrts.live.store.log import Entry
from vrts.live.store.progress import keep_reached
from vrts.live.store.rooms import (
    KeptRoom,
    Line,
    close_room,
    keep_line,
    keep_room,
    lines,
    open_rooms,
)
from vrts.live.tokens import new_id

AWAY_S: Final = 300.0  # how long the place of somebody whose connection dropped is kept
PULSE: Final = 0.1  # [s]
MOST_ROOMS: Final = 64
LOG_FULL: Final = "the log of this session is full, so nothing more can be done in it but panic"
LOG_HELP: Final = "a supervisor can begin another session: choose the scene again"

_log = logging.getLogger("vrts.live")


class Hub:
    """Owns the rooms. Everything in it happens in the event loop's thread."""

    def __init__(self, settings: Settings, database: Database) -> None:
        """Begin without rooms."""
        self.settings = settings
        self.database = database
        self.rooms: dict[str, Room] = {}
        self.muted: set[int] = set()  # accounts
        self.failures = FailedLogIns()
        self.passwords = Passwords()
        self.projector = ""
        self.stopping = False
        self._tasks: set[asyncio.Task[Any]] = set()

    # --- work in the background -------------------------------------------------------------------

    def spawn(self, work: Coroutine[Any, Any, None]) -> None:
        """Have something done meanwhile; a fault of ours in it is logged."""
        task = asyncio.get_running_loop().create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._done)

    def _done(self, task: asyncio.Task[Any]) -> None:
        self._tasks.discard(task)
        if not task.cancelled() and (fault := task.exception()) is not None:
            _log.error("a fault in vrts", exc_info=fault)

    async def pulse(self) -> None:
        """Do what time alone brings about: flush slots, end turns, forget who is gone."""
        wall_due = 0.0
        while not self.stopping:
            await asyncio.sleep(PULSE)
            now = time.time()
            for room in list(self.rooms.values()):
                self._pulse_room(room, now)
            if now >= wall_due:
                wall_due = now + 1.0
                self._show_wall()
                self._keep_reached()
                await self._send_purged_away()

    def _pulse_room(self, room: Room, now: float) -> None:
        for member in list(room.members.values()):
            if member.door is not None:
                member.door.flush()
            elif now - member.away_since > AWAY_S:
                self.remove(room, member)
        if room.control.pass_time(now):
            self.control_changed(room)
        room.set_pace()
        # a crowd is told less often: everybody is told about everybody
        if room.crowd_changed and now - room.crowd_changed > 0.004 * len(room.members):
            room.show_people(frozenset(self.muted))

    async def _send_purged_away(self) -> None:
        """End the places of accounts that were purged meanwhile, from the command line."""
        present = {member.account.id for member in self.everybody()}
        if not present:
            return
        there = await self.database.do(lambda connection: existing(connection, present))
        for account in present - there:
            for member in [m for m in self.everybody() if m.account.id == account]:
                for room in self.rooms.values():
                    room.forget(member.account.name)
                self.send_away(member, "kicked", "your account was removed")

    def _keep_reached(self) -> None:
        """Keep how far sessions have come: after a restart they go on from there."""
        known = [room.reached for room in self.rooms.values()]
        found = [reached for reached in known if reached is not None]
        if found:
            self.spawn(self.database.do(lambda connection: keep_reached(connection, found)))

    def _show_wall(self) -> None:
        watching = [m for m in self.everybody() if m.wall]
        if watching:
            wall = Wall(tuple(room.wall_row() for room in self.rooms.values()), self.projector)
            frame = text_frame(encode(wall))
            for member in watching:
                if member.door is not None:
                    member.door.latest("wall", frame)

    # --- rooms ------------------------------------------------------------------------------------

    async def open_kept(self) -> None:
        """Open the rooms that were open when the server ended."""
        for kept in await self.database.do(open_rooms):
            if self.settings.place(kept.scene) is None:
                kept = kept._replace(scene=self.settings.places[0].id)
            await self._open(kept)

    async def make_room(self, name: str, scene: str) -> Room:
        """Make a room."""
        if len(self.rooms) >= MOST_ROOMS:
            raise NotObeyed("limit", f"there are {MOST_ROOMS} rooms already", "close some")
        settings = self.settings
        place = max((room.kept.place for room in self.rooms.values()), default=0) + 1
        kept = KeptRoom(new_id(), name, scene, place, True, settings.turn_s, settings.idle_s)
        await self.database.do(lambda connection: keep_room(connection, kept))
        return await self._open(kept)

    async def _open(self, kept: KeptRoom) -> Room:
        room = Room(kept, control=ControlRight(kept.turn_s, kept.idle_s))
        for line in await self.database.do(lambda connection: lines(connection, kept.id)):
            room.number = line.number
            to = line.reader_name
            said = Chat(line.number, line.at, "", line.name, line.text, line.private, to)
            room.chat.append((said, _readers(line) if line.private else EVERYBODY))
        room.barred = await self.database.do(lambda connection: bars_of(connection, kept.id))
        self.rooms[kept.id] = room
        self.projector = self.projector or kept.id
        return room

    async def close(self, room: Room) -> None:
        """End a room for good."""
        await self.database.do(lambda connection: close_room(connection, room.id))
        self.rooms.pop(room.id, None)
        if self.projector == room.id:
            self.projector = next(iter(self.rooms), "")
        for member in list(room.members.values()):
            self.send_away(member, "room closed", "the room was closed")
        if room.process is not None:
            room.process.stop()
        self.rooms_changed()

    async def change(self, room: Room, kept: KeptRoom) -> None:
        """Keep what was changed about a room."""
        room.kept = kept
        room.control.turn_s, room.control.idle_s = kept.turn_s, kept.idle_s
        await self.database.do(lambda connection: keep_room(connection, kept))

    def entries(self, account: Account) -> tuple[RoomEntry, ...]:
        """Return the rooms that somebody may enter."""
        only = None if account.supervisor else account.room
        return tuple(
            room.entry
            for room in self.rooms.values()
            if only in (None, room.id) and account.id not in room.barred
        )

    def rooms_changed(self) -> None:
        """Tell everybody which rooms there are."""
        for member in self.everybody():
            message = Rooms(self.entries(member.account), self.projector)
            member.send(text_frame(encode(message)))

    # --- people -----------------------------------------------------------------------------------

    def everybody(self) -> list[Member]:
        """Return all members of all rooms."""
        return [member for room in self.rooms.values() for member in room.members.values()]

    def enter(self, account: Account, join: Join, door: Door) -> Member:
        """Give somebody a place in a room, or the one they had."""
        room = self._room_for(account, join.room)
        member = self._returning(room, account, join)
        if member is None:
            connected = sum(
                m.account.id == account.id and m.door is not None for m in self.everybody()
            )
            if connected >= limits.CONNECTIONS:
                raise NotObeyed("limit", f"there are {connected} connections of this account")
            member = Member(account, room.id)
            room.members[member.id] = member
        resumed = join.resume == member.resume and room.remembers(join.seen)
        member.seen = join.seen if resumed else None
        member.door, member.rate, member.settled = door, join.rate, False
        room.control.back(member.id)
        welcome = Welcome(
            member.id,
            account.name,
            account.supervisor,
            room.id,
            member.resume,
            resumed,
            join.rate,
        )
        door.send(text_frame(encode(welcome)))
        if self.settings.alone and room.control.request(member.id, time.time()):
            self.control_changed(room)
        self.crowd_changed(room)
        room.joining.append(member)
        if room.process is None or not room.process.ready:
            self.settle(room, b"null")
        elif len(room.joining) == 1:
            room.process.ask_snapshot()
        return member

    def settle(self, room: Room, state: bytes) -> None:
        """Send those who wait the state of the room."""
        joining, room.joining = room.joining, []
        if joining:
            self.crowd_changed(room)  # who waits for a snapshot is told nothing else
        for member in joining:
            if member.door is None:
                continue
            member.settled = True
            if member.seen is not None:
                for frame in room.missed(member, member.seen):
                    member.send(frame)
            snapshot = Snapshot(
                room=room.entry,
                rooms=self.entries(member.account),
                scenes=self._scenes() if member.supervisor else (),
                number=room.number,
                session=room.session,
                scene_url=room.scene_url,
                state=msgspec.Raw(state),
                chat=() if member.seen is not None else room.chat_for(member),
            )
            member.send(text_frame(encode(snapshot)))
            member.send(text_frame(encode(room.control_for(member))))
            all_rooms = Rooms(self.entries(member.account), self.projector)
            member.send(text_frame(encode(all_rooms)))

    def drop(self, member: Member, door: Door) -> None:
        """Take note that a connection is gone; the place is kept for a while."""
        if member.door is not door:
            return  # they are back already, on another connection
        member.door, member.settled, member.wall = None, False, False
        member.away_since = time.time()
        room = self.rooms.get(member.room)
        if room is not None:
            room.control.away(member.id, member.away_since)
            self.crowd_changed(room)

    def remove(self, room: Room, member: Member) -> None:
        """Give up somebody's place."""
        room.members.pop(member.id, None)
        if room.control.hand_back(member.id, time.time()):
            self.control_changed(room)
        self.crowd_changed(room)

    def send_away(self, member: Member, code: str, text: str) -> None:
        """End somebody's connection and place."""
        door = member.door
        if door is not None:
            door.send(text_frame(encode(Closed(code, text))))
            door.finish()
        member.door = None
        room = self.rooms.get(member.room)
        if room is not None:
            self.remove(room, member)

    def crowd_changed(self, room: Room) -> None:
        """Have people told soon who is here."""
        room.crowd_changed = room.crowd_changed or time.time()

    def control_changed(self, room: Room) -> None:
        """Tell and record who has the control right."""
        room.show_control()
        self.crowd_changed(room)
        holder = room.members.get(room.control.holder)
        self.record(room, "control", None if holder is None else holder.account, {})

    # --- what is kept -----------------------------------------------------------------------------

    def record(
        self, room: Room, kind: str, account: Account | None, what: dict[str, object]
    ) -> None:
        """Put something that is no command into the log."""
        text = encode(what).decode()
        self.record_entry(self.entry(room, kind, account, text, at_s=0.0, accepted=True))

    def record_entry(self, entry: Entry) -> None:
        """Put an entry into the log."""
        self.spawn(self._record(entry))

    async def _record(self, entry: Entry) -> None:
        await self.log(entry)

    async def log(self, entry: Entry) -> None:
        """Put an entry into the log, and say so when that has become full."""
        await self.database.do(lambda connection: store_log.append_now(connection, entry))
        room = self.rooms.get(entry.room)
        if room is None:
            return
        room.logged += store_log.RECORD + len(entry.text)
        if room.logged > self.settings.log_quota and not room.log_full:
            room.log_full = True
            await self.say(room, None, f"{LOG_FULL}; {LOG_HELP}", EVERYBODY, None)

    def entry(
        self,
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
        return Entry(room.id, room.session, at_s, time.time(), kind, accepted, id_, name, text)

    async def say(
        self, room: Room, speaker: Member | None, text: str, to: Audience, reader: Account | None
    ) -> None:
        """Keep a line of chat, then tell it; it is acknowledged by being told."""
        number, at = room.next_number(), time.time()
        account = None if speaker is None else speaker.account
        name = "" if account is None else account.name
        private = not to.everybody
        id_, read_by = (one.id if one else None for one in (account, reader))
        line = Line(room.id, number, at, id_, name, text, private, read_by)
        await self.database.do(lambda connection: keep_line(connection, line))
        shown_to = reader.name if reader else ""
        said = Chat(number, at, speaker.id if speaker else "", name, text, private, shown_to)
        room.chat.append((said, to))
        room.tell(said, number, to)

    # --- ending -----------------------------------------------------------------------------------

    async def stop(self) -> None:
        """End the sessions, and finish what is being written."""
        self.stopping = True
        for room in self.rooms.values():
            if room.process is not None:
                room.process.stop()
        if self._tasks:
            _, unfinished = await asyncio.wait(self._tasks, timeout=5.0)
            for task in unfinished:
                task.cancel()
            if unfinished:
                await asyncio.wait(unfinished)
        self.database.close()

    def tell_only(self, member: Member, message: Message) -> None:
        """Send something to one connection."""
        if member.door is not None:
            member.door.send(text_frame(encode(message)))

    def _scenes(self) -> tuple[SceneEntry, ...]:
        return tuple(SceneEntry(place.id, bool(place.task)) for place in self.settings.places)

    def _room_for(self, account: Account, wanted: str) -> Room:
        only = None if account.supervisor else account.room
        if only is not None and wanted not in ("", only):
            raise NotObeyed("room", "this link is for another room")
        free = (room.id for room in self.rooms.values() if account.id not in room.barred)
        id_ = wanted or only or next(free, next(iter(self.rooms), ""))
        room = self.rooms.get(id_)
        if room is None:
            raise NotObeyed("room", "there is no such room any more")
        if account.id in room.barred:
            raise NotObeyed("kicked", "the supervisor has sent you away from this room")
        return room

    def _returning(self, room: Room, account: Account, join: Join) -> Member | None:
        if not join.resume:
            return None
        for member in room.members.values():
            same = secrets.compare_digest(member.resume.encode(), join.resume.encode())
            if same and member.account.id == account.id:
                if member.door is not None:
                    self.tell_only(member, Closed("replaced", "you came back elsewhere"))
                    member.door.finish()
                return member
        return None


def _readers(line: Line) -> Audience:
    """Return who may read a private line: its two ends and the supervisors."""
    ends = (line.account, line.reader)
    return Audience(accounts=frozenset(end for end in ends if end is not None), supervisors=True)
