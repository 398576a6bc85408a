"""All rooms and everybody in them; what the sockets and sessions of the server meet in."""

import asyncio
import logging
from collections.abc import Callable, Coroutine
from typing import Any, Final, Protocol

from vrts.live.door import Door, text_frame
from vrts.live.entrance.ways_in import WaysIn
from vrts.live.lasting.clock import wall
from vrts.live.limits import BRANCHES, TURNS, Buckets
from vrts.live.notices.announcement import Announcement
from vrts.live.notices.kept import KeptNotice
from vrts.live.passwords import Passwords
from vrts.live.protocol.coding import encode
from vrts.live.protocol.from_server import Announced, Chat, ClassCode, Rooms
from vrts.live.protocol.listed import RoomEntry
from vrts.live.protocol.over_http import HowIn
from vrts.live.rooms.member import Member
from vrts.live.rooms.room import Room
from vrts.live.settings import Place, Settings, own_place
from vrts.live.store.accounts import Account
from vrts.live.store.bars import Bars
from vrts.live.store.database import Database
from vrts.live.store.waiting.journal import Journal
from vrts.live.tokens import grouped

NO_DISK: Final = "the server's disk takes nothing more, so nothing can be done now but panic"
DISK_HELP: Final = "tell who runs the server to make room; it goes on by itself then"
DISK_LOST: Final = (
    "the server's disk has room again; {} records are lost, of who came, had control or pressed"
    " stop again: too many had to wait; all else that was done is recorded"
)
DISK_AGAIN: Final = "the server's disk has room again: all that was done is recorded"
_log = logging.getLogger("vrts.live")


class Sleeping(Protocol):
    """Wakes rooms of their own."""

    def entered(self, room: Room, account: Account) -> None:
        """Wake a room into which somebody has come, if it sleeps."""
        ...

    def wake(self, room: Room, account: Account) -> None:
        """Have a robot go on now, or as soon as there is room for it."""
        ...


class Hub:
    """Owns the rooms. Everything in it happens in the event loop's thread."""

    def __init__(
        self, settings: Settings, database: Database, address: str = "", *, with_code: bool = False
    ) -> None:
        """Begin without rooms; `address` is where browsers find the server."""
        self.settings = settings
        self.database = database
        self.journal = Journal(database, self.spawn, self._disk_changed)
        self.rooms: dict[str, Room] = {}
        self.how_in = HowIn()
        self.muted: Bars = {}  # accounts that are not heard, with the names they had then
        self.ways = WaysIn(settings.folder, database, address, has_code=with_code)
        self.ways.changed = self.code_changed
        self.announcement: Announcement | None = None
        self.unkept: dict[str, tuple[KeptNotice | None]] = {}  # notices to be kept, by room
        self.passwords = Passwords()
        self.projector = ""
        self.robots = False  # whether there are robots of one's own, or time slots
        self.course = False  # whether a course is served: it has assignments
        self.branching: set[int] = set()  # accounts whose private rooms are being made
        self.branches = Buckets(*BRANCHES)  # how many each account begins
        self.turns = Buckets(*TURNS)  # how often each account asks for control
        self.purges = -1  # how often somebody was purged; -1: not known yet
        self.unjoined: dict[Door, None] = {}  # connections whose first message has not come
        self.sleeping: Sleeping | None = None
        self.settled: Callable[[Member], None] = lambda _: None  # somebody has their snapshot
        self.stopping = False
        self._tasks: set[asyncio.Task[Any]] = set()

    def spawn(self, work: Coroutine[Any, Any, None]) -> None:
        """Have something done meanwhile; a fault of ours in it is logged."""
        task = asyncio.get_running_loop().create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._done)

    def _done(self, task: asyncio.Task[Any]) -> None:
        self._tasks.discard(task)
        if not task.cancelled() and (fault := task.exception()) is not None:
            _log.error("a fault in vrts", exc_info=fault)

    def _disk_changed(self, problem: str) -> None:
        """Tell everybody that nothing can be recorded, or that it can again; it is not kept."""
        for room in self.rooms.values():
            number = room.next_number()
            lost = self.journal.lost
            again = DISK_LOST.format(lost) if lost else DISK_AGAIN
            text = f"{NO_DISK}; {DISK_HELP}" if problem else again
            room.tell(Chat(number, wall(), "", "", text), number)

    def place(self, room: Room) -> Place | None:
        """Return what a room is about, which in a robot of one's own may be one's own variant."""
        place = self.settings.place(room.kept.scene)
        return place and own_place(self.settings.folder, place, room.variant)

    def entries(self, account: Account) -> tuple[RoomEntry, ...]:
        """Return the rooms that somebody may enter; of others' own rooms there are too many."""
        return tuple(
            room.entry
            for room in self.rooms.values()
            if may_enter(account, room) and (room.own is None or room.is_own(account))
        )

    def rooms_changed(self, only: Room | None = None) -> None:
        """Tell everybody which rooms there are; `only` this has changed."""
        own = None if only is None or only.own is None else only
        for member in self.everybody():
            if own is not None and not own.is_own(member.account) and member.room != own.id:
                continue
            message = Rooms(self.entries(member.account), self.projector)
            member.send(text_frame(encode(message)))

    def class_code(self) -> ClassCode:
        """Return what supervisors are told of the class code."""
        return ClassCode(grouped(self.ways.code.text), self.ways.url())

    def code_changed(self) -> None:
        """Show supervisors the class code that works now, on every wall at once."""
        frame = text_frame(encode(self.class_code()))
        for member in self.everybody():
            if member.account.supervisor:
                member.send(frame)

    def show_announcement(self, *, only: Callable[[Member], bool] = lambda _: True) -> None:
        """Tell everybody, or some, what is announced; supervisors how many have seen it too."""
        for member in self.everybody():
            if only(member):
                member.send(text_frame(encode(self.announced(member))))

    def announced(self, member: Member) -> Announced:
        """Return what is announced, as somebody may know it."""
        if self.announcement is None:
            return Announced(0)
        present = (m for m in self.everybody() if m.door is not None and not m.supervisor)
        here = {m.account.id for m in present} if member.account.supervisor else None
        return self.announcement.message(here)

    def everybody(self) -> list[Member]:
        """Return all members of all rooms."""
        return [member for room in self.rooms.values() for member in room.members.values()]

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


def may_enter(account: Account, room: Room) -> bool:
    """Return whether somebody may enter a room."""
    if account.id in room.barred:
        return False
    if account.leads_in(room.id) or room.is_own(account):
        return True
    return room.shared and account.room in (None, room.id)


def may_see(account: Account, room: Room) -> bool:
    """Return whether somebody may see a room: others' own rooms only who is shown to be in it."""
    if room.own is None or room.is_own(account):
        return may_enter(account, room)
    return any(member.account.id == account.id for member in room.members.values())
