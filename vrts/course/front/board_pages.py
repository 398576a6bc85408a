"""The board over HTTP, for those who teach the course: the page, its rows, changes as they come."""

import asyncio
from collections.abc import Sequence
from typing import Final, NamedTuple

import msgspec
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route

from vrts.check.task.late_rules import Keep
from vrts.course.board.board import Column, Presence, board, work_of
from vrts.course.board.changed import changed
from vrts.course.board.grade_book import LONGEST_FILE, Refusal, Wanted, grade_book
from vrts.course.board.table import marks_csv
from vrts.course.board.told import BoardTold, WaitTold
from vrts.course.facts import Facts, facts_of_all, unix
from vrts.course.front.own_page import OwnPage
from vrts.course.people.watching import WatchedPeople
from vrts.desk.front.events import Events
from vrts.live.front.bodies import JSON, as_json, read_body
from vrts.live.front.guard import refused
from vrts.live.front.http import Pages
from vrts.live.front.static_files import content
from vrts.live.lasting.clock import wall
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.own.hands import shown
from vrts.live.store.accounts import ALL_ROOMS, Account
from vrts.live.store.course.attempts import Attempt, all_attempts, attempts_of, state_of
from vrts.live.store.course.people import Person, people, person_of
from vrts.live.store.database import Connection

LONGEST_BODY: Final = 4 * LONGEST_FILE // 3 + 4096  # bytes of a request with a file in base64
NOT_MARKED: Final = "the course does not say where this assignment was marked"
MARKED_HELP: Final = 'name the folder in `course.toml`, such as `marked = "marked/cans"`'
REFUSED: Final = (403, "role", "only those who teach the course see its board")


class _Read(NamedTuple):
    """The board as it was last made, and by what."""

    state: tuple[object, ...]
    told: BoardTold


class BoardPages:
    """The handlers."""

    def __init__(self, people: WatchedPeople, hub: Hub, pages: Pages) -> None:
        """Tell of the course that `people` follows; `pages` knows whose cookies there are."""
        self._people = people
        self._hub = hub
        self._pages = pages
        self._page = OwnPage("course/board")
        self._events = Events()
        self._read: _Read | None = None
        self._making = asyncio.Lock()
        self._exporting = asyncio.Lock()  # one at a time

    def routes(self) -> Sequence[BaseRoute]:
        """Return its pages."""
        return (
            *self._page.routes("/course/board"),
            Route("/course/board/now", self.now),
            Route("/course/board/events", self.events),
            Route("/course/board/marks.csv", self.marks),
            Route("/course/board/grades", self.grades, methods=["POST"]),
            Route("/course/board/student/{account:int}", self.student),
        )

    async def open(self) -> None:
        """Begin."""

    async def beat(self) -> None:
        """Tell those who look what has changed."""
        before = self._read
        if before is None or not self._events.listened:
            return
        now = await self._made()
        difference = changed(before.told, now)
        if difference is not None:
            self._events.send("changed", difference)

    async def close(self) -> None:
        """End."""
        self._events.end()

    async def now(self, request: Request) -> Response:
        """Return the whole board."""
        if await self._teacher(request) is None:
            return refused(*REFUSED)
        told = await self._made()
        data = await asyncio.to_thread(lambda: content(msgspec.json.encode(told), JSON))
        return data.answer(request, cache="private, no-cache")

    async def events(self, request: Request) -> Response:
        """Answer with changes as they come, as server-sent events."""
        if await self._teacher(request) is None:
            return refused(*REFUSED)
        return await self._events.listen(request)

    async def student(self, request: Request) -> Response:
        """Return everything that a student has handed in."""
        if await self._teacher(request) is None:
            return refused(*REFUSED)
        account = int(request.path_params["account"])
        person = await self._hub.database.do(lambda c: person_of(c, account))
        if person is None or person.rank != "student":
            return refused(404, "student", "there is no such student in this course")
        found = await self._hub.database.do(lambda c: attempts_of(c, account))
        return as_json(work_of(person, found))

    async def marks(self, request: Request) -> Response:
        """Return the public marks as a table for spreadsheets."""
        if await self._teacher(request) is None:
            return refused(*REFUSED)
        wanted = request.query_params.get("assignment")
        columns = {one.id for one in self._people.course.assignments}
        if wanted is not None and wanted not in columns:
            return refused(404, "assignment", "there is no such assignment in this course")
        told = await self._made()
        known = await self._hub.database.do(people)
        data = await asyncio.to_thread(marks_csv, told, known, wanted)
        name = "public-marks" if wanted is None else f"public-marks-{wanted}"
        headers = {"content-disposition": f'attachment; filename="{name}.csv"'}
        return Response(data, headers=headers, media_type="text/csv")

    async def grades(self, request: Request) -> Response:
        """Return final marks as `vrts grade export` writes them, or what it says against it."""
        if await self._teacher(request) is None:
            return refused(*REFUSED)
        wanted = await read_body(request, Wanted, longest=LONGEST_BODY, what="file")
        if isinstance(wanted, Response):
            return wanted
        known = {one.id: one.marked for one in self._people.course.assignments}
        marked = known.get(wanted.assignment)
        if marked is None:
            return refused(404, "assignment", NOT_MARKED, MARKED_HELP)
        try:
            async with self._exporting:
                found = await grade_book(marked, wanted, self._hub.settings.folder)
        except OSError as problem:
            return refused(507, "export", f"nothing could be exported: {problem.strerror}")
        if isinstance(found, Refusal):
            return refused(409, found.code, found.text)
        return Response(found, media_type="text/csv")

    async def _made(self) -> BoardTold:
        """Return the board of now; it is made again where something has changed."""
        async with self._making:
            presence, hub = self._presence(), self._hub
            course = self._people.course
            state = (presence, course, await hub.database.do(state_of))
            if self._read is not None and self._read.state == state:
                return self._read.told
            known, attempts = await hub.database.do(_rows)
            now, title = wall(), course.title

            def make() -> BoardTold:
                columns = [_column(one) for one in facts_of_all(course)]
                return board(title, columns, known, attempts, presence, now)

            told = await asyncio.to_thread(make)
            self._read = _Read(state, told)
            return told

    def _presence(self) -> Presence:
        hub = self._hub
        here = [member for member in hub.everybody() if member.door is not None]
        rooms = {one.account.id: hub.rooms[one.room].kept.name for one in here}
        hands = [
            WaitTold(one.account.id, one.account.name, "hand", 0.0, one.room, "")
            for one in here
            if one.hand
        ]
        by = {room.id: room.own.hand_by or 0 for room in hub.rooms.values() if room.own}
        raised, _ = shown(hub)  # in robots of their own, the one that waits longest first
        hands += [
            WaitTold(by[one.room], one.name, "hand", one.since, one.room, one.text)
            for one in raised
        ]
        return Presence(rooms, hands)

    async def _teacher(self, request: Request) -> Account | None:
        """Return who asks, if they teach the whole course."""
        account = await self._pages.who(request.cookies)
        return account if account is not None and account.leads_in(ALL_ROOMS) else None


def _rows(connection: Connection) -> tuple[list[Person], list[Attempt]]:
    return people(connection), all_attempts(connection)


def _column(facts: Facts) -> Column:
    id_, opens, due = facts.assignment.id, unix(facts.opens), unix(facts.due)
    marked = facts.assignment.marked is not None
    return Column(id_, facts.title, opens, due, facts.keep is Keep.BEST, marked)
