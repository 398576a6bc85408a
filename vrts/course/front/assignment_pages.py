"""Assignments over HTTP: what there is to do, its words, handing in, marks with their reasons."""

import asyncio
from collections import Counter
from collections.abc import Sequence
from contextlib import suppress
from fractions import Fraction
from pathlib import Path
from typing import Final

from starlette.requests import Request
from starlette.responses import FileResponse, Response
from starlette.routing import BaseRoute, Route

from vrts.check.task.late_rules import Keep
from vrts.course.beside import Beside
from vrts.course.course import HANDING, Assignment, Course
from vrts.course.facts import Facts, facts_of, unix
from vrts.course.front.own_page import OwnPage
from vrts.course.front.told import (
    AllWorkTold,
    AttemptTold,
    HandInAsked,
    HandInTold,
    LossTold,
    TextTold,
    WorkTold,
)
from vrts.course.handing.marking import Marking
from vrts.course.handing.names import folder_of
from vrts.course.handing.published import final_of, report_of
from vrts.course.handing.queue import Job, in_order
from vrts.course.handing.standing import Refusal, opened
from vrts.course.handing.taking import Taking
from vrts.course.handing.telling import Telling
from vrts.course.people.watching import WatchedPeople
from vrts.course.variants.own_variants import OwnVariants
from vrts.live.front.bodies import as_json, read_body
from vrts.live.front.guard import refused
from vrts.live.front.http import Pages
from vrts.live.lasting.clock import steady, wall
from vrts.live.limits import Buckets
from vrts.live.rooms.hub import Hub
from vrts.live.store.accounts import Account
from vrts.live.store.course.attempts import Attempt, attempts_of, waiting
from vrts.live.store.course.people import Person, people, person_of
from vrts.live.store.database import Connection
from vrts.pipeline.files import CannotRead
from vrts.report.quantities import points

LONGEST_BODY: Final = 1_300_000  # bytes: 200,000 characters, escaped
HAND_INS: Final = (1 / 20, 5.0)  # of an account, a second and at once
AT_ONCE: Final = 20  # bodies that are read at the same time, of all
OF_ONE: Final = 2  # of one account
IN_SANDBOX: Final = (
    "sandbox allow-scripts; default-src 'none'; script-src 'unsafe-inline' data:;"
    " style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none';"
    " frame-ancestors 'none'"
)
NO_ASSIGNMENT: Final = (404, "assignment", "there is no such assignment for you")
NOT_WRITTEN: Final = (
    "disk",
    "the program could not be written: nothing was handed in",
    "keep it, and tell your teacher",
)


class AssignmentPages:
    """The handlers."""

    def __init__(
        self, watched: WatchedPeople, hub: Hub, pages: Pages, variants: OwnVariants, beside: Beside
    ) -> None:
        """Tell of the course that `watched` follows.

        Args:
            watched: The course.
            hub: Of the server.
            pages: Know whose cookies there are.
            variants: Who has which.
            beside: The process that reads tasks; it ends with these pages.
        """
        folder = hub.settings.folder / HANDING
        self._hub = hub
        self._pages = pages
        self._variants = variants
        self._taking = Taking(watched.course, hub.database, variants)
        self._marking = Marking(self._taking, hub.database, folder)
        self._telling = Telling(beside)
        self._page = OwnPage("course/work")
        self._rate = Buckets(*HAND_INS)
        self._reading: Counter[int] = Counter()
        self._follow(watched.course)
        watched.changed.append(self._follow)

    def routes(self) -> Sequence[BaseRoute]:
        """Return its pages."""
        return (
            *self._page.routes("/course/work"),
            Route("/course/work/now", self.now),
            Route("/course/work/text/{assignment}", self.text),
            Route("/course/work/hand-in", self.hand_in, methods=["POST"]),
            Route("/course/work/page/{assignment}/{number:int}", self.page),
            Route("/course/work/final/{assignment}", self.final),
            Route("/course/work/program/{assignment}/{number:int}", self.program),
        )

    async def open(self) -> None:
        """Begin: what a crash has left undone is done first."""
        await self._taking.mend()
        self._marking.begin()

    async def beat(self) -> None:
        """End processes that nobody needs."""
        await self._marking.beat()
        await self._telling.beat()

    async def close(self) -> None:
        """End: what waits is marked after the next start."""
        await self._marking.end()
        await self._telling.end()

    async def now(self, request: Request) -> Response:
        """Tell what there is to do, and how it stands for who asks."""
        account = await self._pages.who(request.cookies)
        if account is None:
            return _nobody()
        at = wall()

        def look(connection: Connection) -> tuple[Person | None, list[Attempt], list[Attempt]]:
            person = person_of(connection, account.id)
            return person, attempts_of(connection, account.id), waiting(connection)

        person, own, waits = await self._hub.database.do(look)
        others = {one.by for one in own if one.by not in (None, account.id)}
        names: dict[int, str] = {}
        if others:
            every = await self._hub.database.do(people)
            names = {one.account: one.name for one in every if one.account in others}
        told: list[WorkTold] = []
        places = {job: k for k, job in enumerate(in_order(waits))}
        course = self._taking.course
        for assignment in course.assignments:
            with suppress(CannotRead):
                facts = await asyncio.to_thread(facts_of, assignment)
                if _sees(account, person, facts, at):
                    mine = [one for one in own if one.assignment == assignment.id]
                    told.append(
                        await asyncio.to_thread(self._work, facts, mine, at, places, names, person)
                    )
        rank, team = ("", "") if person is None else (person.rank, person.team)
        hands_in = person is not None and person.rank == "student" and person.listed
        return as_json(AllWorkTold(course.title, account.name, rank, team, hands_in, tuple(told)))

    async def text(self, request: Request) -> Response:
        """Tell what students get of a task."""
        found = await self._asked(request)
        if isinstance(found, Response):
            return found
        account, facts = found
        own = await self._variants.of(facts.assignment, account.id)
        if own.problem:
            return as_json(TextTold((), "", own.problem))
        text = await self._telling.text(own.task)
        return as_json(TextTold(text.blocks, text.start, text.problem))

    async def hand_in(self, request: Request) -> Response:
        """Take a program; it is written before this is answered."""
        account = await self._pages.who(request.cookies)
        if account is None:
            return _nobody()
        if not self._rate.take(account.id, steady()):
            return refused(429, "limit", "you hand in too often", "wait a minute")
        if self._reading[account.id] >= OF_ONE or self._reading.total() >= AT_ONCE:
            return refused(503, "busy", "too many programs are sent at once", "try again")
        self._reading[account.id] += 1
        try:
            body = await read_body(request, HandInAsked, longest=LONGEST_BODY, what="program")
        finally:
            self._reading[account.id] -= 1
            self._reading += Counter()  # forgets those at 0
        if isinstance(body, Response):
            return body
        at = wall()
        facts = await self._facts(account, body.assignment, at)
        if facts is None:
            return refused(*NO_ASSIGNMENT)
        if not body.text.strip():
            return refused(422, "empty", "the program is empty: nothing was handed in")
        try:
            program = body.text.encode()
        except UnicodeEncodeError:
            return refused(422, "text", "the program is no text: nothing was handed in")
        try:
            taken = await self._taking.take(
                account.id, facts.assignment, program, at, (body.attempt, body.late)
            )
        except OSError:
            return refused(503, *NOT_WRITTEN)
        if isinstance(taken, Refusal):
            return refused(409, *taken)
        self._marking.wake()
        return as_json(HandInTold(taken.number, float(taken.at), taken.late, taken.again))

    async def page(self, request: Request) -> Response:
        """Return the page about an attempt of one's own, in a sandbox: its code is inside it."""
        found = await self._attempt(request)
        if isinstance(found, Response):
            return found
        _, attempt = found
        path = self._marking.page(attempt)
        if not await asyncio.to_thread(path.is_file):
            return refused(404, "page", "there is no page about this attempt")
        return _in_sandbox(path)

    async def final(self, request: Request) -> Response:
        """Return the report that goes with one's own final mark, in a sandbox."""
        found = await self._asked(request)
        if isinstance(found, Response):
            return found
        account, facts = found
        person = await self._hub.database.do(lambda c: person_of(c, account.id))
        if person is None:
            return refused(404, "page", "nothing is published for you")
        folder, course = folder_of(person.key, person.email), self._taking.course
        path = await asyncio.to_thread(report_of, course, facts.assignment.id, folder)
        if path is None:
            return refused(404, "page", "nothing is published for you")
        return _in_sandbox(path)

    async def program(self, request: Request) -> Response:
        """Return a program as one has handed it in."""
        found = await self._attempt(request)
        if isinstance(found, Response):
            return found
        facts, attempt = found
        data = await self._taking.program(facts, attempt)
        if data is None:
            return refused(404, "program", "the program is not there any more")
        name = f"{attempt.assignment}-attempt-{attempt.number}.v2"
        headers = {"content-disposition": f'attachment; filename="{_ascii(name)}"'}
        return Response(data, headers=headers, media_type="text/plain; charset=utf-8")

    def _follow(self, course: Course) -> None:
        """Take the course as its file is now."""
        self._taking.course = self._variants.course = course
        self._hub.course = bool(course.assignments)

    async def _asked(self, request: Request) -> tuple[Account, Facts] | Response:
        """Return who asks and of which assignment, or why it is refused."""
        account = await self._pages.who(request.cookies)
        if account is None:
            return _nobody()
        facts = await self._facts(account, request.path_params["assignment"], wall())
        return refused(*NO_ASSIGNMENT) if facts is None else (account, facts)

    async def _attempt(self, request: Request) -> tuple[Facts, Attempt] | Response:
        """Return an attempt of who asks; nobody else's has an address."""
        found = await self._asked(request)
        if isinstance(found, Response):
            return found
        account, facts = found
        id_, number = facts.assignment.id, int(request.path_params["number"])
        own = await self._hub.database.do(lambda c: attempts_of(c, account.id, id_))
        attempt = next((one for one in own if one.number == number), None)
        if attempt is None:
            return refused(404, "attempt", "you have no such attempt")
        return facts, attempt

    async def _facts(self, account: Account, id_: str, at: float) -> Facts | None:
        """Return what is known of an assignment that somebody sees; None: there is none."""
        assignment = self._taking.assignment(id_)
        if assignment is None:
            return None
        person = await self._hub.database.do(lambda c: person_of(c, account.id))
        with suppress(CannotRead):
            facts = await asyncio.to_thread(facts_of, assignment)
            return facts if _sees(account, person, facts, at) else None
        return None

    def _work(
        self,
        facts: Facts,
        attempts: Sequence[Attempt],
        at: float,
        places: dict[Job, int],
        names: dict[int, str],
        person: Person | None,
    ) -> WorkTold:
        assignment: Assignment = facts.assignment
        used = max((one.number for one in attempts), default=0)
        folder = "" if person is None else folder_of(person.key, person.email)
        granted = self._taking.granted(assignment, folder)
        stands = self._taking.standing(facts, used, at, folder)
        why, final = stands.refusal, None
        later = granted.due is not None and facts.due is not None and granted.due > facts.due
        if person is not None:
            final = final_of(self._taking.course, assignment.id, folder)
        return WorkTold(
            assignment.id,
            facts.title,
            unix(facts.opens),
            unix(granted.due if later else facts.due),
            unix(stands.closes),
            facts.keep is Keep.BEST,
            facts.rules is not None and facts.rules.is_exam,
            assignment.team,
            stands.late,
            stands.attempts,
            stands.left,
            "" if why is None else why.text,
            "" if why is None else why.help,
            tuple(self._told(one, places, names) for one in reversed(attempts)),
            final,
            later,
            granted.excused,
        )

    def _told(self, one: Attempt, places: dict[Job, int], names: dict[int, str]) -> AttemptTold:
        page: Path = self._marking.page(one)
        return AttemptTold(
            one.number,
            one.at,
            one.state,
            _shown(one.mark),
            _shown(one.total),
            one.late,
            one.said,
            names.get(one.by or 0, ""),
            places.get(Job(one.assignment, one.digest, one.variant))
            if one.state == "waiting"
            else None,
            one.state == "marked" and page.is_file(),
            tuple(
                LossTold(points(abs(Fraction(x.points))), x.cause, x.line, x.time_s, x.hint, x.why)
                for x in one.causes
            ),
        )


def _in_sandbox(path: Path) -> Response:
    headers = {"content-security-policy": IN_SANDBOX, "cache-control": "no-store"}
    return FileResponse(path, headers=headers, media_type="text/html; charset=utf-8")


def _sees(account: Account, person: Person | None, facts: Facts, at: float) -> bool:
    """Return whether somebody sees an assignment: who teaches does, also before it opens."""
    teaches = account.supervisor or (person is not None and person.rank != "student")
    return teaches or opened(facts, at)


def _shown(fraction: str | None) -> str:
    return "" if fraction is None else points(Fraction(fraction))


def _ascii(name: str) -> str:
    return "".join(c for c in name if c.isascii() and (c.isalnum() or c in "._-"))


def _nobody() -> Response:
    return refused(401, "login", "nobody is logged in", "open the join link again")
