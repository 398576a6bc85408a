"""The people of a course over HTTP: first entries by a personal link, and the list for teachers."""

import asyncio
from collections.abc import Sequence
from typing import Final

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route

from vrts.course.course import EMAIL
from vrts.course.front.own_page import OwnPage
from vrts.course.front.told_people import (
    AddStaff,
    AskLetter,
    ChoosePassword,
    LetterTold,
    NewLink,
    PeopleTold,
    PersonRow,
    Whose,
)
from vrts.course.people.following import add_by_hand, end_by_hand
from vrts.course.people.letters import keep_address
from vrts.course.people.listed import Listed
from vrts.course.people.watching import WatchedPeople
from vrts.live.front.bodies import as_json, read_body
from vrts.live.front.browsers import browser_token
from vrts.live.front.guard import refused
from vrts.live.front.http import Pages
from vrts.live.lasting.clock import wall
from vrts.live.passwords import hashed
from vrts.live.people.naming import person_name
from vrts.live.rooms.entering import send_away
from vrts.live.rooms.hub import Hub
from vrts.live.store.accounts import Account, account_of, log_in
from vrts.live.store.bars import use_browser
from vrts.live.store.course.letters import (
    choose_password,
    has_letter,
    has_password,
    new_letter,
    whose_letter,
)
from vrts.live.store.course.people import Person, keep_person, people, person_of
from vrts.live.store.database import Connection
from vrts.live.tokens import digest

NO_LETTER: Final = (403, "letter", "this link was used, or another was made", "ask your teacher")
NOT_ALLOWED: Final = (403, "role", "only a teacher may do this")
NOBODY: Final = (404, "person", "there is no such person")
SET: Final = "you have a new password: log in with it"
ENDED: Final = "a teacher has taken you off the list"


class PeoplePages:
    """The handlers."""

    def __init__(self, people: WatchedPeople, hub: Hub, pages: Pages) -> None:
        """Tell of people; `pages` knows whose cookies there are."""
        self._people = people
        self._hub = hub
        self._pages = pages

    def routes(self) -> Sequence[BaseRoute]:
        """Return its pages."""
        return (
            *OwnPage("course/first").routes("/course/first"),
            *OwnPage("course/people").routes("/course/people"),
            Route("/course/letter", self.letter, methods=["POST"]),
            Route("/course/password", self.password, methods=["POST"]),
            Route("/course/people/list", self.list),
            Route("/course/people/add", self.add, methods=["POST"]),
            Route("/course/people/link", self.link, methods=["POST"]),
            Route("/course/people/end", self.end, methods=["POST"]),
        )

    async def open(self) -> None:
        """Give everybody an account."""
        await self._people.open()
        folder, address = self._hub.settings.folder, self._hub.ways.address
        await asyncio.to_thread(keep_address, folder, address)

    async def beat(self) -> None:
        """Follow the files."""
        await self._people.beat()

    async def close(self) -> None:
        """End: nothing goes on."""

    # --- first entry -----------------------------------------------------------------------------

    async def letter(self, request: Request) -> Response:
        """Tell whose link somebody has."""
        body = await read_body(request, AskLetter)
        if isinstance(body, Response):
            return body
        now = wall()
        person = await self._hub.database.do(lambda c: whose_letter(c, body.code, now))
        if person is None:
            return refused(*NO_LETTER)
        return as_json(LetterTold(self._people.course.title, person.name, person.email))

    async def password(self, request: Request) -> Response:
        """Give somebody who has a link the password that they choose, and log them in."""
        hub, now = self._hub, wall()
        body = await read_body(request, ChoosePassword)
        if isinstance(body, Response):
            return body
        if await hub.database.do(lambda c: whose_letter(c, body.code, now)) is None:
            return refused(*NO_LETTER)
        kept = await asyncio.to_thread(hashed, body.password)
        browser = browser_token(request.cookies, hub.settings)

        def choose(connection: Connection) -> tuple[Account, str] | None:
            person = choose_password(connection, body.code, kept, now)
            account = None if person is None else account_of(connection, person.account)
            if account is None:
                return None
            use_browser(connection, (account.id,), digest(browser))
            return account, log_in(connection, account.id, now)

        found = await hub.database.do(choose)
        if found is None:
            return refused(*NO_LETTER)
        for member in [one for one in hub.everybody() if one.account.id == found[0].id]:
            send_away(hub, member, "left", SET)  # whoever that was
        return self._pages.logged_in(*found, browser)

    # --- for teachers ----------------------------------------------------------------------------

    async def list(self, request: Request) -> Response:
        """Tell teachers who is in the course."""
        if not await self._teaches(request):
            return refused(*NOT_ALLOWED)
        now, hub = wall(), self._hub
        here = {member.account.id for member in hub.everybody() if member.door is not None}

        def look(connection: Connection) -> tuple[PersonRow, ...]:
            seen = dict(connection.execute("SELECT id, seen FROM account").fetchall())
            return tuple(
                _row(connection, person, seen.get(person.account, 0.0), here, now)
                for person in people(connection)
            )

        rows = await hub.database.do(look)
        told = PeopleTold(
            self._people.course.title, self._people.fault, tuple(self._people.rooms()), rows
        )
        return as_json(told)

    async def add(self, request: Request) -> Response:
        """Add a teacher or an assistant, and return their link."""
        if not await self._teaches(request):
            return refused(*NOT_ALLOWED)
        body = await read_body(request, AddStaff)
        if isinstance(body, Response):
            return body
        email, rooms, now = body.email.strip().casefold(), self._people.rooms(), wall()
        if not EMAIL.match(email):
            return refused(422, "email", f"`{email}` is no e-mail address")
        if not person_name(body.name):
            return refused(422, "name", "a name needs a letter or a digit")
        unknown = [name for name in body.rooms if name not in rooms]
        if unknown:
            return refused(404, "room", f"there is no room `{unknown[0]}`")
        named = body.rooms if body.rank == "assistant" else ()
        one = Listed(email, body.name.strip(), email, {}, body.rank, rooms=named)

        def work(connection: Connection) -> tuple[int, str, str]:
            account = add_by_hand(connection, one, rooms, now)
            person = person_of(connection, account)
            assert person is not None, "was just added"
            return account, person.name, new_letter(connection, account, now)

        try:
            account, name, token = await self._hub.database.do(work)
        except ValueError as problem:
            return refused(409, "person", str(problem))
        await self._people.refresh((account,))
        return self._new_link(name, token)

    async def link(self, request: Request) -> Response:
        """Make a new link for somebody, which lets them choose another password."""
        if not await self._teaches(request):
            return refused(*NOT_ALLOWED)
        body = await read_body(request, Whose)
        if isinstance(body, Response):
            return body
        now = wall()

        def work(connection: Connection) -> tuple[str, str] | None:
            person = person_of(connection, body.account)
            if person is None or not person.listed:
                return None
            if person.subject is not None:  # who comes by the provider next is known anew
                keep_person(connection, person._replace(subject=None))
            return person.name, new_letter(connection, person.account, now)

        found = await self._hub.database.do(work)
        return refused(*NOBODY) if found is None else self._new_link(*found)

    async def end(self, request: Request) -> Response:
        """Let nobody in any more who was added in the page."""
        if not await self._teaches(request):
            return refused(*NOT_ALLOWED)
        body = await read_body(request, Whose)
        if isinstance(body, Response):
            return body
        if not await self._hub.database.do(lambda c: end_by_hand(c, body.account)):
            help_ = "take others off the list of the class, or out of `course.toml`"
            return refused(
                409, "person", "only people who were added in this page are removed here", help_
            )
        await self._people.refresh((body.account,))
        return Response(status_code=204)

    async def _teaches(self, request: Request) -> bool:
        account = await self._pages.who(request.cookies)
        return account is not None and account.supervisor

    def _new_link(self, name: str, token: str) -> Response:
        return as_json(NewLink(name, f"{self._hub.ways.address}/course/first#{token}"))


def _row(
    connection: Connection, person: Person, seen: float, here: set[int], now: float
) -> PersonRow:
    """Return somebody as teachers see them."""
    way = "none"
    if has_password(connection, person.account):
        way = "password"
    elif person.subject is not None:
        way = "provider"
    elif has_letter(connection, person.account, now):
        way = "link"
    return PersonRow(
        person.account,
        person.name,
        person.email,
        person.rank,
        person.rooms,
        person.team,
        seen,
        person.account in here,
        way,
        person.listed,
        person.origin,
    )
