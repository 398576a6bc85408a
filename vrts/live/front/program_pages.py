"""Programs that are kept, over HTTP: lists, versions, texts, saving, forgetting.

One's own shelf is for everybody who is logged in, also after their room was closed. On that of a
room who may command there saves, and who is in it reads.
"""

import asyncio
from collections import Counter, OrderedDict
from typing import Final, Literal, NamedTuple, TypeVar

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from vrts.live.front.bodies import as_json, read_body
from vrts.live.front.guard import refused
from vrts.live.lasting.clock import steady, wall
from vrts.live.limits import ALL_BODIES, BODIES, Bucket
from vrts.live.protocol.over_programs import (
    DropProgram,
    KeepProgram,
    Kept,
    KeptPrograms,
    KeptText,
    KeptVersion,
)
from vrts.live.rooms.hub import Hub
from vrts.live.store import programs
from vrts.live.store.accounts import Account, Who
from vrts.live.store.database import Connection
from vrts.live.store.programs import (
    GuestsTogether,
    Outcome,
    Version,
    own_shelf,
    room_shelf,
    room_takes,
)

LONGEST_BODY: Final = 1_300_000  # bytes: 200,000 characters, escaped
RATE: Final = (0.5, 20.0)  # requests of a person that write, a second and at once
PERSONS: Final = 2000  # whose requests are counted
LONGEST_WORD: Final = 128  # characters of what an address holds
NO_CONTROL: Final = (
    "only the person who has control saves programs for the room",
    "take control, or save it for yourself",
)
FULL: Final = (
    "your programs take all the space that one person has",
    "delete some, or download them first",
)
FULL_ROOM: Final = (
    "the programs of this room take all the space that a room has",
    "ask the supervisor to delete some",
)
FULL_GUESTS: Final = (
    "the programs of all guests take all the space that there is",
    "download yours, and ask the supervisor to delete some",
)
BUSY: Final = ("too many programs are sent at once", "try again")

Body = TypeVar("Body", KeepProgram, DropProgram)


class _Place(NamedTuple):
    """A shelf that somebody may use."""

    account: Account
    shelf: str


class ProgramPages:
    """The handlers."""

    def __init__(self, hub: Hub, who: Who) -> None:
        """Serve a hub; `who` returns whose cookies these are."""
        self._hub = hub
        self._who = who
        self._buckets: OrderedDict[int, Bucket] = OrderedDict()
        self._together = GuestsTogether()
        self._reading: dict[asyncio.Timeout, int] = {}  # programs that accounts send, by their end

    def routes(self) -> list[Route]:
        """Return where they are asked."""
        return [
            Route("/programs", self.all),
            Route("/programs/versions", self.versions),
            Route("/programs/text", self.text),
            Route("/programs/keep", self.keep, methods=["POST"]),
            Route("/programs/drop", self.drop, methods=["POST"]),
        ]

    async def all(self, request: Request) -> Response:
        """Return what there is on one's own shelf and on that of a room."""
        place = await self._place(request, request.query_params.get("room", ""), "room")
        if isinstance(place, Response):
            return place
        account, shelf = place
        own = await self._hub.database.do(lambda c: programs.programs(c, own_shelf(account.id)))
        room = await self._hub.database.do(lambda c: programs.programs(c, shelf))
        return as_json(KeptPrograms(_shown(own, account), _shown(room, account)))

    async def versions(self, request: Request) -> Response:
        """Return the versions of a program, the newest first."""
        place = await self._asked(request)
        if isinstance(place, Response):
            return place
        name = request.query_params.get("name", "")[:LONGEST_WORD]
        found = await self._hub.database.do(lambda c: programs.versions(c, place.shelf, name))
        return as_json(_shown(found, place.account))

    async def text(self, request: Request) -> Response:
        """Return the text of a version."""
        place = await self._asked(request)
        if isinstance(place, Response):
            return place
        name = request.query_params.get("name", "")[:LONGEST_WORD]
        digits = request.query_params.get("number", "")
        number = int(digits) if digits.isascii() and digits.isdigit() and len(digits) < 10 else 0
        text = await self._hub.database.do(lambda c: programs.text_of(c, place.shelf, name, number))
        if text is None:
            return refused(404, "version", "this version is not kept any more")
        return as_json(KeptText(text))

    async def keep(self, request: Request) -> Response:
        """Keep a text as the next version of a program."""
        given = await self._given(request, KeepProgram)
        if isinstance(given, Response):
            return given
        body, (account, shelf) = given
        if body.shelf == "room" and not self._hub.rooms[body.room].lets_save(account):
            return refused(403, "role", *NO_CONTROL)
        version = Version(body.name, 0, wall(), account.id, account.name, 0)
        length, clock = len(body.text), steady()

        def save(connection: Connection) -> Outcome | tuple[str, str]:
            if body.shelf == "room" and not room_takes(connection, body.room, body.name, length):
                return FULL_ROOM
            if not self._together.take(connection, account.id, length, clock):
                return FULL_GUESTS
            return programs.save(connection, shelf, version, body.text, body.seen)

        done = await self._hub.database.do(save)
        if not isinstance(done, Outcome):
            return refused(409, "full", *done)
        if done.full:
            return refused(409, "full", *FULL)
        newest = None if done.version is None else _one(done.version, account)
        return as_json(Kept(done.saved, newest))

    async def drop(self, request: Request) -> Response:
        """Forget a program of one's own; those of rooms are for supervisors to forget."""
        given = await self._given(request, DropProgram)
        if isinstance(given, Response):
            return given
        body, place = given
        if body.shelf == "room" and not place.account.leads_in(body.room):
            words = "programs of the room are deleted by supervisors only"
            return refused(403, "role", words)
        await self._hub.database.do(lambda c: programs.remove(c, place.shelf, body.name))
        return Response(status_code=204)

    async def _given(self, request: Request, kind: type[Body]) -> tuple[Body, _Place] | Response:
        """Return what somebody wants written, and the shelf that is to be written to."""
        body = await self._read(request, kind)
        if isinstance(body, Response):
            return body
        place = await self._place(request, body.room, body.shelf)
        return place if isinstance(place, Response) else (body, place)

    async def _asked(self, request: Request) -> _Place | Response:
        """Return the shelf that an address names."""
        asked = request.query_params
        shelf: Literal["own", "room"] = "room" if asked.get("shelf") == "room" else "own"
        return await self._place(request, asked.get("room", ""), shelf)

    async def _read(self, request: Request, kind: type[Body]) -> Body | Response:
        """Return what somebody sends who may write now, and not too much at the same time."""
        account = await self._who(request.cookies)
        if account is None:
            return _nobody()
        if not self._lets(account):
            return refused(429, "limit", "you save too often", "wait a few seconds")
        own = Counter(self._reading.values())
        if own[account.id] >= BODIES:
            return refused(503, "busy", *BUSY)
        if len(self._reading) >= ALL_BODIES and not account.supervisor:
            # of those who send most the one that began first: it is slow, or never ends
            slow = max(self._reading, key=lambda one: own[self._reading[one]])
            del self._reading[slow]
            slow.reschedule(0.0)
        ends = asyncio.timeout(None)
        try:
            async with ends:
                if not account.supervisor:  # who leads always gets through
                    self._reading[ends] = account.id
                return await read_body(request, kind, longest=LONGEST_BODY, what="program")
        except TimeoutError:
            return refused(503, "busy", *BUSY)
        finally:
            self._reading.pop(ends, None)

    async def _place(
        self, request: Request, room: str, shelf: Literal["own", "room"]
    ) -> _Place | Response:
        """Return a shelf, or why it may not be used."""
        account = await self._who(request.cookies)
        if account is None:
            return _nobody()
        may = shelf == "own" or any(entry.id == room for entry in self._hub.entries(account))
        if not may:
            return refused(404, "room", "there is no such room for you any more")
        return _Place(account, own_shelf(account.id) if shelf == "own" else room_shelf(room))

    def _lets(self, account: Account) -> bool:
        bucket = self._buckets.setdefault(account.id, Bucket(*RATE))
        self._buckets.move_to_end(account.id)
        while len(self._buckets) > PERSONS:
            self._buckets.popitem(last=False)
        return bucket.take(steady())


def _nobody() -> Response:
    return refused(401, "login", "nobody is logged in", "open the join link again")


def _shown(versions: list[Version], account: Account) -> tuple[KeptVersion, ...]:
    return tuple(_one(version, account) for version in versions)


def _one(version: Version, account: Account) -> KeptVersion:
    name, number, at, saver_id, saver, length = version
    return KeptVersion(name, number, at, saver, saver_id == account.id, length)
