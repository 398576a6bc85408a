"""What everybody of a course asks first: what it is, and who one is in it."""

import asyncio
from collections.abc import Sequence

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route

from vrts.course.facts import facts_of_all, unix
from vrts.course.front.told import AssignmentTold, CourseTold
from vrts.course.handing.standing import opened
from vrts.course.people.watching import WatchedPeople
from vrts.live.front.bodies import as_json
from vrts.live.front.guard import refused
from vrts.live.front.http import Pages
from vrts.live.lasting.clock import wall
from vrts.live.rooms.hub import Hub
from vrts.live.store.course.people import person_of


class CoursePages:
    """The handlers."""

    def __init__(self, people: WatchedPeople, hub: Hub, pages: Pages) -> None:
        """Tell of the course that `people` follows; `pages` knows whose cookies there are."""
        self._people = people
        self._hub = hub
        self._pages = pages

    def routes(self) -> Sequence[BaseRoute]:
        """Return its pages."""
        return (Route("/course/me", self.me),)

    async def open(self) -> None:
        """Begin."""

    async def beat(self) -> None:
        """Do what time brings about: nothing."""

    async def close(self) -> None:
        """End."""

    async def me(self, request: Request) -> Response:
        """Tell what the course is, and who asks."""
        account = await self._pages.who(request.cookies)
        if account is None:
            return refused(401, "login", "nobody is logged in", "open the join link again")
        person = await self._hub.database.do(lambda c: person_of(c, account.id))
        teaches = account.supervisor or (person is not None and person.rank != "student")
        now, course = wall(), self._people.course
        every = await asyncio.to_thread(facts_of_all, course)
        told = tuple(
            AssignmentTold(one.assignment.id, one.title, unix(one.opens), unix(one.due))
            for one in every
            if teaches or opened(one, now)
        )
        rank, team = ("", "") if person is None else (person.rank, person.team)
        return as_json(CourseTold(course.title, rank, team, told))
