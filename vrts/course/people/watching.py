"""People of a running server follow the files of its course, without a restart.

Files are looked at once a second. They count when they have stayed as they are from one look to the
next, so that none is read half written; a faulty one changes nothing, and teachers are told.
"""

import asyncio
import logging
from collections.abc import Callable
from importlib.util import find_spec
from typing import Final

from vrts.course.course import Course
from vrts.course.people.following import Followed, follow
from vrts.course.people.sources import Read, Stamp, people_of, read_people, stamp_of
from vrts.live.lasting.clock import wall
from vrts.live.protocol.from_server import Chat
from vrts.live.protocol.over_http import HowIn
from vrts.live.rooms.entering import send_away
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.telling.audience import Audience
from vrts.live.store.accounts import account_of
from vrts.live.store.database import Connection
from vrts.live.store.guests import log_guests_out

GONE: Final = "you are not on the list of this course any more: ask your teacher"
NO_GUESTS: Final = "this course lets in only who is on its list"
AT_ONCE: Final = 25  # accounts that are made in one job of the database
_log = logging.getLogger("vrts.live")


class WatchedPeople:
    """Keeps the people of a server as the files say."""

    def __init__(self, course: Course, hub: Hub) -> None:
        """Begin with a course as it was read when the server began."""
        self.course = course  # as it is now
        self.fault = ""  # what keeps people as they were; empty: nothing
        self.changed: list[Callable[[Course], None]] = []  # are told of another course
        self._hub = hub
        self._stamp: Stamp = ()  # of what was read last
        self._seen: Stamp = ()  # at the last look
        self._rooms: dict[str, tuple[str, ...]] = {}
        self._read = Read(course)

    async def open(self) -> None:
        """Give everybody an account; a list that is faulty is told, and nobody is changed."""
        self._stamp = self._seen = stamp_of(self.course)
        await self._take(await asyncio.to_thread(people_of, self.course))

    async def beat(self) -> None:
        """Follow what has changed."""
        seen = stamp_of(self.course)
        if seen != self._stamp and seen == self._seen:
            self._stamp = seen
            await self._take(await asyncio.to_thread(read_people, self.course.folder))
        elif self._rooms != self.rooms():  # a room with a name that assistants lead was made
            await self.again()
        self._seen = seen

    def rooms(self) -> dict[str, tuple[str, ...]]:
        """Return the ids of the shared rooms, by name."""
        found: dict[str, tuple[str, ...]] = {}
        for room in self._hub.rooms.values():
            if room.branch is None:
                found[room.kept.name] = (*found.get(room.kept.name, ()), room.id)
        return found

    async def again(self) -> None:
        """Follow what was read last once more: rooms have changed, or people of the page."""
        if self._read.good:
            await self._follow(self._read)

    def log(self, text: str) -> None:
        """Write something into the server's log, which the admin page shows."""
        _log.warning("%s", text)

    async def _take(self, read: Read) -> None:
        if not read.good or read.course is None:
            if read.words != self.fault:
                self.fault = read.words
                _log.warning(
                    "the course's files are faulty, people stay as they were: %s", read.words
                )
                self._tell(f"the course's files are faulty, people stay as they were: {read.words}")
            return
        if self.fault:
            self._tell("the course's files are in order again")
        self.fault = ""
        self._read, self.course = read, read.course
        await self._let_guests(on=read.course.guests)
        await self._follow(read)
        for told in self.changed:
            told(read.course)

    async def _let_guests(self, *, on: bool) -> None:
        """Let guests in, or do not any more; what lets them in begins or ends with that."""
        hub = self._hub
        began = hub.how_in.guests
        login = self.course.login
        if login is not None and find_spec("authlib") is None:
            _log.warning("nobody logs in by the provider: `pip install 'vrts[login]'` is missing")
            login = None
        button = "" if login is None else login.button
        hub.how_in = HowIn(guests=on, title=self.course.title, provider=button)
        if hub.ways.code.text and not on:
            await hub.ways.renew_code(none=True)
        elif on and not began and not hub.ways.code.text:
            await hub.ways.renew_code()

    async def _follow(self, read: Read) -> None:
        """Follow the files, a few new people at a time: what others do is written in between."""
        while await self._some(read) == AT_ONCE:
            pass

    async def _some(self, read: Read) -> int:
        """Follow the files, and return how many accounts were made: at most `AT_ONCE`."""
        rooms, now, guests = self.rooms(), wall(), self._hub.how_in.guests

        def work(connection: Connection) -> tuple[Followed, list[int]]:
            out = [] if guests else log_guests_out(connection)
            return follow(connection, read.people, rooms, now, AT_ONCE), out

        done, out = await self._hub.database.do(work)
        self._rooms = rooms
        if done.added or done.gone or done.changed:
            counts = (len(done.added), len(done.gone), len(done.changed))
            _log.info("people of the course: %d new, %d gone, %d changed", *counts)
        self._send_away(out, NO_GUESTS)
        await self.refresh((*done.gone, *done.changed))
        return len(done.added)

    async def refresh(self, accounts: tuple[int, ...]) -> None:
        """Have those who are here be who they are now; who may not stay goes."""
        hub = self._hub
        for member in [one for one in hub.everybody() if one.account.id in set(accounts)]:
            id_ = member.account.id
            account = await hub.database.do(lambda connection, id_=id_: account_of(connection, id_))
            if account is None:
                send_away(hub, member, "kicked", GONE)
                continue
            if account == member.account:
                continue
            member.account = account
            if member.door is not None:
                member.door.finish()  # the page comes back at once, and learns what it may do
            room = hub.rooms.get(member.room)
            if room is not None:
                room.tell_people_soon()

    def _send_away(self, accounts: list[int], why: str) -> None:
        gone = set(accounts)
        for member in [one for one in self._hub.everybody() if one.account.id in gone]:
            send_away(self._hub, member, "kicked", why)

    def _tell(self, text: str) -> None:
        """Tell teachers who are here, in the chat, where nobody else sees it."""
        for member in self._hub.everybody():
            room = self._hub.rooms.get(member.room)
            if member.account.supervisor and room is not None:
                number = room.next_number()
                line = Chat(number, wall(), "", "", text, True, member.account.name)
                room.tell(line, number, Audience(persons=frozenset((member.id,))))
