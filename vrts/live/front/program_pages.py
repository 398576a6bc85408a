"""Programs that are kept, over HTTP: lists, versions, texts, saving, forgetting."""

import time
from collections import OrderedDict
from collections.abc import Awaitable, Callable
from typing import Final, Literal, NamedTuple, TypeVar

import msgspec
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from vrts.live.front.guard import refused
from vrts.live.lasting.clock import wall
from vrts.live.limits import Bucket
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
from vrts.live.store.accounts import Account
from vrts.live.store.programs import Version, own_shelf, room_shelf

LONGEST_BODY: Final = 1_300_000  # bytes: 200,000 characters, escaped
RATE: Final = (0.5, 20.0)  # requests of a person that write, a second and at once
PERSONS: Final = 2000  # whose requests are counted
JSON: Final = "application/json"
LONGEST_WORD: Final = 128  # characters of what an address holds

Body = TypeVar("Body")
Who = Callable[[dict[str, str]], Awaitable[Account | None]]


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
        return _json(KeptPrograms(_shown(own, account), _shown(room, account)))

    async def versions(self, request: Request) -> Response:
        """Return the versions of a program, the newest first."""
        place = await self._asked(request)
        if isinstance(place, Response):
            return place
        name = request.query_params.get("name", "")[:LONGEST_WORD]
        found = await self._hub.database.do(lambda c: programs.versions(c, place.shelf, name))
        return _json(_shown(found, place.account))

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
        return _json(KeptText(text))

    async def keep(self, request: Request) -> Response:
        """Keep a text as the next version of a program."""
        body = await _body(request, KeepProgram)
        if isinstance(body, Response):
            return body
        place = await self._place(request, body.room, body.shelf, writes=True)
        if isinstance(place, Response):
            return place
        account, shelf = place
        version = Version(body.name, 0, wall(), account.id, account.name, 0)
        done = await self._hub.database.do(
            lambda c: programs.save(c, shelf, version, body.text, body.seen)
        )
        if done.full:
            words = "your programs take all the place that one person has"
            return refused(409, "full", words, "delete some, or download them first")
        newest = None if done.version is None else _one(done.version, account)
        return _json(Kept(done.saved, newest))

    async def drop(self, request: Request) -> Response:
        """Forget a program of one's own; those of rooms are for supervisors to forget."""
        body = await _body(request, DropProgram)
        if isinstance(body, Response):
            return body
        place = await self._place(request, body.room, body.shelf, writes=True)
        if isinstance(place, Response):
            return place
        if body.shelf == "room" and not place.account.supervisor:
            words = "programs of the room are deleted by supervisors only"
            return refused(403, "role", words)
        await self._hub.database.do(lambda c: programs.remove(c, place.shelf, body.name))
        return Response(status_code=204)

    async def _asked(self, request: Request) -> _Place | Response:
        """Return the shelf that an address names."""
        asked = request.query_params
        shelf: Literal["own", "room"] = "room" if asked.get("shelf") == "room" else "own"
        return await self._place(request, asked.get("room", ""), shelf)

    async def _place(
        self, request: Request, room: str, shelf: Literal["own", "room"], *, writes: bool = False
    ) -> _Place | Response:
        """Return a shelf, or why it may not be used; one's own is for who is in a room, too."""
        account = await self._who(request.cookies)
        if account is None:
            return refused(401, "login", "nobody is logged in", "open the join link again")
        if not any(entry.id == room for entry in self._hub.entries(account)):
            return refused(404, "room", "there is no such room for you any more")
        if writes and not self._lets(account):
            return refused(429, "limit", "you save too often", "wait a few seconds")
        return _Place(account, own_shelf(account.id) if shelf == "own" else room_shelf(room))

    def _lets(self, account: Account) -> bool:
        bucket = self._buckets.setdefault(account.id, Bucket(*RATE))
        self._buckets.move_to_end(account.id)
        while len(self._buckets) > PERSONS:
            self._buckets.popitem(last=False)
        return bucket.take(time.monotonic())


async def _body(request: Request, kind: type[Body]) -> Body | Response:
    """Return the JSON body of a request, or why it is refused."""
    if request.headers.get("content-type", "").split(";")[0].strip() != JSON:
        return refused(415, "body", f"the body must be {JSON}")
    data = bytearray()
    async for part in request.stream():
        data += part
        if len(data) > LONGEST_BODY:
            return refused(413, "body", "the program is too long")
    try:
        return msgspec.json.decode(data, type=kind)
    except msgspec.DecodeError as problem:
        return refused(400, "body", str(problem))


def _shown(versions: list[Version], account: Account) -> tuple[KeptVersion, ...]:
    return tuple(_one(version, account) for version in versions)


def _one(version: Version, account: Account) -> KeptVersion:
    name, number, at, saver_id, saver, length = version
    return KeptVersion(name, number, at, saver, saver_id == account.id, length)


def _json(value: object) -> Response:
    return Response(msgspec.json.encode(value), media_type=JSON)
