"""Time slots over HTTP: what can be booked, whose it is, and changes."""

from collections.abc import Sequence
from typing import Annotated, Literal

import msgspec
from msgspec import Meta
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route

from vrts.course.people.watching import WatchedPeople
from vrts.course.robots.slots import Slots
from vrts.live.front.bodies import as_json, read_body
from vrts.live.front.guard import refused
from vrts.live.front.http import Pages
from vrts.live.lasting.clock import steady, wall
from vrts.live.limits import Buckets
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import Hub
from vrts.live.store.accounts import Account
from vrts.live.store.course.people import people, person_of

STATUSES = {"role": 403, "slots": 404, "slot": 404, "taken": 409, "limit": 409, "rate": 429}
CHANGES = (0.5, 20.0)  # of an account: a second, and at once
DAY_S = 86_400.0
Instant = Annotated[float, Meta(ge=0.0, le=1e11)]  # Unix time [s]


class SlotTold(msgspec.Struct, frozen=True):
    """A slot."""

    starts: float  # Unix time [s]
    ends: float
    taken: bool
    mine: bool
    name: str  # whose it is; told to who leads, and of one's own


class SlotsTold(msgspec.Struct, frozen=True):
    """`GET /course/slots`."""

    room: str  # name; empty: there are no slots
    zone: str
    ahead: int  # slots that one may have before one
    leads: bool  # may change those of all
    slots: tuple[SlotTold, ...]


class ChangeSlot(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /course/slots`: book, move or free a time."""

    do: Literal["book", "move", "cancel"]
    starts: Instant
    to: Instant = 0.0  # where it is moved to
    name: Annotated[str, Meta(max_length=160)] = ""  # who leads books for somebody


class SlotPages:
    """The handlers."""

    def __init__(self, watched: WatchedPeople, hub: Hub, pages: Pages) -> None:
        """Serve the slots of the course that `watched` follows; `pages` knows whose cookies are."""
        self._hub = hub
        self._pages = pages
        self._slots = Slots(watched.course, hub)
        watched.changed.append(self._slots.follow)
        self._changes = Buckets(*CHANGES)
        self._forgot = 0.0

    def routes(self) -> Sequence[BaseRoute]:
        """Return its pages."""
        return (
            Route("/course/slots", self.told),
            Route("/course/slots", self.change, methods=["POST"]),
        )

    async def open(self) -> None:
        """Begin."""

    async def beat(self) -> None:
        """Let who has booked this time have control."""
        if self._slots.rules is None:
            return
        now = wall()
        await self._slots.beat(now, steady())
        if now - self._forgot > DAY_S:
            self._forgot = now
            await self._slots.forget_past(now)

    async def close(self) -> None:
        """End."""

    async def told(self, request: Request) -> Response:
        """Tell which times there are, and whose they are."""
        account = await self._pages.who(request.cookies)
        if account is None:
            return _nobody()
        if self._slots.rules is None or self._slots.room is None:
            return as_json(SlotsTold("", "", 0, leads=False, slots=()))
        try:
            return await self._answer(account)
        except NotObeyed as why:
            return _refused(why)

    async def change(self, request: Request) -> Response:
        """Book, move or free a time; answered by what there is then."""
        account = await self._pages.who(request.cookies)
        if account is None:
            return _nobody()
        body = await read_body(request, ChangeSlot)
        if isinstance(body, Response):
            return body
        try:
            await self._change(account, body)
            return await self._answer(account)
        except NotObeyed as why:
            return _refused(why)

    async def _change(self, account: Account, body: ChangeSlot) -> None:
        if not self._changes.take(account.id, steady()):
            raise NotObeyed("rate", "too many changes at once", "wait a few seconds")
        room, now = self._slots.room, wall()
        leads = room is not None and account.leads_in(room.id)
        if body.name and not leads:
            raise NotObeyed("role", "only those who lead the course book for others")
        person = await self._hub.database.do(lambda c: person_of(c, account.id))
        if not leads and (person is None or not person.listed):
            raise NotObeyed("role", "times are for those on a list of the course")
        match body.do:
            case "cancel":
                await self._slots.cancel(account, body.starts, now)
            case "move":
                await self._slots.move(account, body.starts, body.to, now)
            case "book":
                whose = await self._named(body.name) if body.name else account.id
                await self._slots.book(whose, body.starts, now, free=leads)

    async def _named(self, name: str) -> int:
        listed = await self._hub.database.do(people)
        found = [one.account for one in listed if one.listed and name in (one.name, one.email)]
        if len(found) != 1:
            raise NotObeyed("slot", f"nobody of this course is called `{name}`")
        return found[0]

    async def _answer(self, account: Account) -> Response:
        rules, room = self._slots.rules, self._slots.room
        rows = await self._slots.table(wall())
        assert rules is not None
        assert room is not None
        leads = account.leads_in(room.id)
        told: list[SlotTold] = []
        for slot, whose in rows:
            mine = whose is not None and whose.account == account.id
            name = whose.name if whose is not None and (mine or leads) else ""
            told.append(SlotTold(slot.starts, slot.ends, whose is not None, mine, name))
        return as_json(SlotsTold(rules.room, rules.zone, rules.ahead, leads, tuple(told)))


def _nobody() -> Response:
    return refused(401, "login", "nobody is logged in", "open the join link again")


def _refused(why: NotObeyed) -> Response:
    return refused(STATUSES.get(why.code, 409), why.code, why.text, why.help)
