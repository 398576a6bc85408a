"""How people come in over HTTP: by the class code, a link or a password; and who may change that.

A right code or link always lets in: nothing that others typed or did stands before it.
"""

import math
from typing import Final

from starlette.requests import Request
from starlette.responses import Response

from vrts.live.entrance.class_code import Guess
from vrts.live.entrance.entries import group
from vrts.live.front.bodies import as_json, read_body
from vrts.live.front.browsers import browser_token
from vrts.live.front.guard import refused
from vrts.live.front.http import LONGEST_TOKEN, Pages
from vrts.live.front.qr_code import qr_svg
from vrts.live.lasting.clock import steady, wall
from vrts.live.people.naming import person_name
from vrts.live.protocol.over_http import (
    ChangeWays,
    Enter,
    EntriesFrom,
    Link,
    LogIn,
    MakeLink,
    WayRow,
    Ways,
)
from vrts.live.rooms.hub import Hub
from vrts.live.store import accounts, guests
from vrts.live.store.accounts import Account
from vrts.live.store.bars import Inherited, inherit, use_browser
from vrts.live.store.course.people import name_of
from vrts.live.store.database import Connection
from vrts.live.tokens import digest, is_code

NO_GUESTS: Final = (403, "guests", "only people on the list come in here", "log in instead")
LEFT: Final = (403, "left", "you are not on the list of this course any more", "ask your teacher")
NOT_ALLOWED: Final = (403, "role", "only a supervisor may do this")


class EntrancePages:
    """The handlers."""

    def __init__(self, hub: Hub, pages: Pages) -> None:
        """Serve a hub; `pages` knows whose cookies there are."""
        self._hub = hub
        self._pages = pages

    async def enter(self, request: Request) -> Response:
        """Let somebody in who has a join link or the class code."""
        hub, now = self._hub, wall()
        body = await read_body(request, Enter)
        if isinstance(body, Response):
            return body
        if is_code(body.code):
            guess = await hub.ways.guess(body.code)
            if guess is not Guess.RIGHT:
                return self._no_way(guess)
        if not hub.how_in.guests and not await self._supervisors(body.code, now):
            return refused(*NO_GUESTS)
        token = request.cookies.get(hub.settings.cookie, "")[:LONGEST_TOKEN]
        browser = browser_token(request.cookies, hub.settings)
        here = {member.account.id for member in hub.everybody()}
        inherited: list[Inherited] = []

        def let_in(connection: Connection) -> tuple[Account, str] | None:
            account = guests.come_in(connection, body.code, body.name, now, here=here)
            if account is None:
                return None
            old = accounts.who(connection, token, now)
            used = [account.id] if old is None else [account.id, old.id]
            use_browser(connection, used, digest(browser))
            if not account.supervisor:
                inherited.append(inherit(connection, account.id, person_name(body.name)))
            return account, accounts.log_in(connection, account.id, now)

        try:
            found = await hub.database.do(let_in)
        except ValueError as problem:
            return refused(422, "name", str(problem))
        if found is None:
            return self._no_way(Guess.FORMER if is_code(body.code) else Guess.WRONG)
        account, fresh = found
        for bars, muted in inherited:
            for room, name in bars:
                if room in hub.rooms:
                    hub.rooms[room].barred[account.id] = name
            if muted:
                hub.muted[account.id] = muted
        if not account.supervisor:
            self._entered(account, _address(request))
        return self._pages.logged_in(account, fresh, browser)

    async def door(self, request: Request) -> Response:
        """Tell anybody how people come in here."""
        del request
        return as_json(self._hub.how_in)

    async def login(self, request: Request) -> Response:
        """Let somebody in who has a local account."""
        hub, now = self._hub, wall()
        body = await read_body(request, LogIn)
        if isinstance(body, Response):
            return body
        browser = browser_token(request.cookies, hub.settings)
        own = digest(browser)

        def look(connection: Connection) -> tuple[tuple[Account, str] | None, bool]:
            found = accounts.password_of(connection, name_of(connection, body.user))
            return found, found is not None and accounts.knows(connection, found[0].id, own)

        found, known = await hub.database.do(look)
        whose = None if found is None else found[0].id
        source = f"browser {own.hex()}" if known else group(_address(request))
        tries, clock = hub.ways.log_ins, steady()
        wait_s = tries.wait_s(whose, body.user, source, clock)
        if wait_s > 0.0:
            return _wait(wait_s)
        tries.wrong(whose, body.user, source, clock)  # until it is known to be right
        kept = found[1] if found else None
        right = await hub.passwords.right(body.password, kept, source, known=known)
        if right is None:
            tries.take_back(whose, body.user, source)
            return refused(503, "busy", "too many log in at once", "try again in a few seconds")
        if found is None or not right:
            return refused(403, "login", "user or password is wrong")
        account = found[0]
        tries.right(account.id, source)

        def let_in(connection: Connection) -> str:
            if accounts.account_of(connection, account.id) is None:
                return ""
            use_browser(connection, (account.id,), own)
            return accounts.log_in(connection, account.id, now)

        token = await hub.database.do(let_in)
        return self._pages.logged_in(account, token, browser) if token else refused(*LEFT)

    async def link(self, request: Request) -> Response:
        """Make a join link for one room, for supervisors."""
        if not await self._supervises(request):
            return refused(*NOT_ALLOWED)
        body = await read_body(request, MakeLink)
        if isinstance(body, Response):
            return body
        if not self._hub.how_in.guests:
            return refused(*NO_GUESTS)
        if body.room not in self._hub.rooms:
            return refused(404, "room", "there is no such room any more")
        return _link(await self._hub.ways.make_link(body.room))

    async def code(self, request: Request) -> Response:
        """Return the class code and its link to supervisors."""
        if not await self._supervises(request):
            return refused(*NOT_ALLOWED)
        return as_json({"code": self._hub.ways.code.text, "url": self._hub.ways.url()})

    async def code_picture(self, request: Request) -> Response:
        """Return the QR code of the class code's link to supervisors."""
        url = self._hub.ways.url()
        if not url or not await self._supervises(request):
            return refused(*NOT_ALLOWED)
        return Response(qr_svg(url), media_type="image/svg+xml")

    async def ways(self, request: Request) -> Response:
        """Tell supervisors what lets people in, and how many came by it."""
        if not await self._supervises(request):
            return refused(*NOT_ALLOWED)
        return await self._shown()

    async def change(self, request: Request) -> Response:
        """Renew or end the class code or a link, for supervisors."""
        ways = self._hub.ways
        if not await self._supervises(request):
            return refused(*NOT_ALLOWED)
        if not self._hub.how_in.guests:
            return refused(*NO_GUESTS)
        body = await read_body(request, ChangeWays)
        if isinstance(body, Response):
            return body
        renew = body.do == "renew"
        if not body.id and renew:
            await ways.renew_code(away=body.away)
            return await self._shown()
        url = await ways.end(body.id, away=body.away, renew=renew)
        if url is None:
            return refused(404, "link", "there is no such link any more")
        return _link(url) if url and url != ways.url() else await self._shown()

    async def _shown(self) -> Response:
        shown = await self._hub.ways.shown()
        names = {room.id: room.kept.name for room in self._hub.rooms.values()}
        rows = tuple(
            WayRow(
                way.id,
                "code" if way.code else "supervisor" if way.supervisor else "link",
                names.get(way.room or "", ""),
                way.made,
                0.0 if way.code else way.expires,
                way.used,
                way.inside,
            )
            for way in shown.links
        )
        lately, crowd = shown.lately, shown.crowd
        places = tuple(EntriesFrom(*place) for place in lately.most)
        return as_json(
            Ways(
                shown.code,
                shown.url,
                shown.wrong,
                shown.left,
                rows,
                lately.hour,
                lately.day,
                places,
                crowd.guests,
                crowd.unused,
                crowd.idle,
            )
        )

    async def _supervisors(self, code: str, now: float) -> bool:
        """Return whether a link is a supervisor's."""
        return await self._hub.database.do(lambda c: accounts.lets_supervise(c, code, now))

    async def _supervises(self, request: Request) -> bool:
        account = await self._pages.who(request.cookies)
        return account is not None and account.supervisor

    def _entered(self, account: Account, address: str) -> None:
        hub = self._hub
        gone = hub.ways.entries.entered(account.id, address, steady())
        if gone:
            hub.spawn(hub.database.do(lambda c: guests.give_up_unused(c, gone)))

    def _no_way(self, guess: Guess) -> Response:
        if guess is Guess.FORMER:
            return refused(403, "renewed", "there is another class code now", "look at the wall")
        length = len(self._hub.ways.code.text)
        help_ = "ask for a new one"
        if guess is Guess.NO_CODE and length:
            help_ = f"a class code has {length} letters and digits, and no I, L, O, 0 or 1"
        return refused(403, "code", "there is no such code or link", help_)


def _link(url: str) -> Response:
    return as_json(Link(url, qr_svg(url).decode()))


def _wait(wait_s: float) -> Response:
    seconds = math.ceil(wait_s)
    answer = refused(429, "wait", "too many wrong passwords", f"wait {seconds} s")
    answer.headers["retry-after"] = str(seconds)
    return answer


def _address(request: Request) -> str:
    return request.client.host if request.client else ""
