"""Robots of their own over HTTP: which one may open, and the search of those who lead."""

from collections.abc import Sequence
from typing import Annotated

import msgspec
from msgspec import Meta
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route

from vrts.course.course import Course
from vrts.course.people.watching import WatchedPeople
from vrts.course.robots.own_robots import OwnRobots
from vrts.course.variants.own_variants import OwnVariants
from vrts.live.front.bodies import as_json, read_body
from vrts.live.front.guard import refused
from vrts.live.front.http import Pages
from vrts.live.lasting.clock import steady, wall
from vrts.live.protocol.fields import Id
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.own.sleeping import Sleeper
from vrts.live.store.course.people import person_of

STATUSES = {"role": 403, "own": 403, "scene": 404, "limit": 409, "rate": 429, "disk": 503}
LONGEST_WORDS = 100  # characters


class OpenRobot(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /course/robots`: open one's own robot in a scene, or for an assignment."""

    scene: Annotated[Id, Meta(min_length=1)]


class Opened(msgspec.Struct, frozen=True):
    """The answer: the room to enter."""

    room: str


class ChoiceTold(msgspec.Struct, frozen=True):
    """A robot that somebody may open."""

    scene: str
    title: str
    assignment: bool
    team: str  # who shares it; empty: it is for one alone
    room: str  # empty: it was never opened
    asleep: bool


class ChoicesTold(msgspec.Struct, frozen=True):
    """`GET /course/robots`."""

    robots: tuple[ChoiceTold, ...]


class FoundTold(msgspec.Struct, frozen=True):
    """Somebody's robot."""

    room: str
    name: str
    whose: str
    title: str
    asleep: bool
    people: int
    hand: bool


class AllTold(msgspec.Struct, frozen=True):
    """`GET /course/robots/all?find=WORDS&from=N`, for those who lead."""

    robots: tuple[FoundTold, ...]
    count: int  # that fit, listed or not


class RobotPages:
    """The handlers."""

    def __init__(
        self, people: WatchedPeople, hub: Hub, pages: Pages, variants: OwnVariants
    ) -> None:
        """Serve the robots of the course that `people` follows; `pages` knows whose cookies are."""
        self._hub = hub
        self._pages = pages
        self._robots = OwnRobots(people.course, hub, variants)
        self._follow(people.course)
        people.changed.append(self._follow)

    def routes(self) -> Sequence[BaseRoute]:
        """Return its pages."""
        return (
            Route("/course/robots", self.choices),
            Route("/course/robots", self.open_robot, methods=["POST"]),
            Route("/course/robots/all", self.all),
        )

    def _follow(self, course: Course) -> None:
        self._robots.follow(course)
        self._hub.robots = course.own_robots or course.slots is not None
        if isinstance(self._hub.sleeping, Sleeper):
            self._hub.sleeping.limits = course.limits

    async def open(self) -> None:
        """Begin."""

    async def beat(self) -> None:
        """See who belongs to which room."""
        await self._robots.look(steady())

    async def close(self) -> None:
        """End."""

    async def choices(self, request: Request) -> Response:
        """Tell which robots somebody has and may open."""
        account = await self._pages.who(request.cookies)
        if account is None:
            return _nobody()
        person = await self._hub.database.do(lambda c: person_of(c, account.id))
        found = self._robots.choices(account, person, wall())
        return as_json(ChoicesTold(tuple(ChoiceTold(*one) for one in found)))

    async def open_robot(self, request: Request) -> Response:
        """Open a robot; who asks enters its room then."""
        account = await self._pages.who(request.cookies)
        if account is None:
            return _nobody()
        body = await read_body(request, OpenRobot)
        if isinstance(body, Response):
            return body
        person = await self._hub.database.do(lambda c: person_of(c, account.id))
        try:
            room = await self._robots.open(account, person, body.scene, wall())
        except NotObeyed as why:
            return refused(STATUSES.get(why.code, 409), why.code, why.text, why.help)
        return as_json(Opened(room.id))

    async def all(self, request: Request) -> Response:
        """Tell those who lead which robots there are, some at a time."""
        account = await self._pages.who(request.cookies)
        if account is None:
            return _nobody()
        if not account.leads_any:
            return refused(403, "role", "only those who lead the course see the robots of others")
        words = request.query_params.get("find", "")[:LONGEST_WORDS]
        begin = request.query_params.get("from", "0")
        number = int(begin) if begin.isascii() and begin.isdigit() and len(begin) < 6 else 0
        found, count = self._robots.found(account, words, number)
        return as_json(AllTold(tuple(FoundTold(*one) for one in found), count))


def _nobody() -> Response:
    return refused(401, "login", "nobody is logged in", "open the join link again")
