"""Log-in by the provider of a course: the way there, and back.

The cookie of who is logged in goes with no request that another site began, so the page that a
browser comes back to leads on by itself; and the cookie of the way there may come along.
"""

import html
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from starlette.requests import Request
from starlette.responses import RedirectResponse, Response
from starlette.routing import BaseRoute, Route

from vrts.course.people.watching import GONE, WatchedPeople
from vrts.live.front.browsers import browser_token
from vrts.live.front.http import Pages
from vrts.live.lasting.clock import wall
from vrts.live.rooms.hub import Hub
from vrts.live.store.accounts import Account, account_of, log_in
from vrts.live.store.bars import use_browser
from vrts.live.store.course.people import by_claim, by_subject, keep_person
from vrts.live.store.database import Connection
from vrts.live.tokens import digest

if TYPE_CHECKING:
    from vrts.live.entrance.provider.provider import Identity, Provider

START: Final = "/course/login"
BACK: Final = "/course/login/back"
LASTS_S: Final = 600
LONGEST: Final = 4096  # characters of an address with which a browser comes back
NO_LOGIN: Final = "This course has no log-in elsewhere."
DOWN: Final = (
    "The log-in of your organisation does not answer now. Log in with a password instead, or try"
    " again later."
)
STRANGER: Final = "You are not on the list of this course: ask your teacher."
UNVERIFIED: Final = (
    "Your organisation has not made sure of your e-mail address, so it does not count here: ask"
    " your teacher for a link."
)
NOT_TOLD: Final = "Your organisation does not tell who you are: ask your teacher for a link."
OTHER: Final = (
    "Somebody else of your organisation has come in under your name before: ask your teacher for a"
    " new link."
)
_PAGE: Final = """<!doctype html>
<html lang="en">
<head>
  <meta charset="utf-8">
  <meta name="viewport" content="width=device-width, initial-scale=1">
  <meta name="color-scheme" content="light dark">
  <title>Log in · vrts</title>{on}
  <link rel="icon" href="/web/live/icon.svg" type="image/svg+xml">
  <link rel="stylesheet" href="/web/report/base.css">
  <link rel="stylesheet" href="/web/live/pages.css">
</head>
<body><main class="enter"><div class="door">
<h1>Log in</h1>
<p role="status">{text}</p>
<p><a href="/">{link}</a></p>
</div></main></body>
</html>
"""


class LoginPages:
    """The handlers."""

    def __init__(self, people: WatchedPeople, hub: Hub, pages: Pages) -> None:
        """Let in who is on the list; `pages` makes the cookies."""
        self._people = people
        self._hub = hub
        self._pages = pages
        self._provider: Provider | None = None

    def routes(self) -> Sequence[BaseRoute]:
        """Return its pages."""
        return (Route(START, self.start), Route(BACK, self.back))

    async def open(self) -> None:
        """Begin: nobody is asked anything before somebody logs in."""

    async def beat(self) -> None:
        """Do what time brings about: nothing."""

    async def close(self) -> None:
        """End: nothing goes on."""

    async def start(self, request: Request) -> Response:
        """Lead a browser to the provider."""
        provider = self._now()
        if provider is None:
            return _told(NO_LOGIN, 404)
        address = self._hub.ways.address
        if request.headers.get("host", "") != address.partition("://")[2]:
            return RedirectResponse(f"{address}{START}", 303)  # where the cookie will be found
        from vrts.live.entrance.provider.provider import ProviderDown  # loaded by who logs in

        try:
            url, memory = await provider.begin()
        except ProviderDown as problem:
            self._people.log(f"the log-in provider: {problem}")
            return _told(DOWN, 503)
        answer = RedirectResponse(url, 303)
        answer.set_cookie(
            self._cookie,
            memory,
            max_age=LASTS_S,
            path=START,
            secure=self._hub.settings.secure,
            httponly=True,
            samesite="lax",  # it has to come along when the provider leads back
        )
        return answer

    async def back(self, request: Request) -> Response:
        """Let in who comes back from the provider and is on the list."""
        provider = self._now()
        if provider is None:
            return _told(NO_LOGIN, 404)
        from vrts.live.entrance.provider.checking import NotTrusted  # loaded by who logs in
        from vrts.live.entrance.provider.provider import ProviderDown  # as this one is

        if len(request.url.query) > LONGEST:
            return _told("This address is too long.", 414)
        asked = dict(request.query_params)
        try:
            identity = await provider.finish(asked, request.cookies.get(self._cookie, ""))
        except NotTrusted as problem:
            return _told(f"You are not logged in: {problem}.", 403)
        except ProviderDown as problem:
            self._people.log(f"the log-in provider: {problem}")
            return _told(DOWN, 503)
        now, hub = wall(), self._hub
        browser = browser_token(request.cookies, hub.settings)

        def let_in(connection: Connection) -> tuple[Account, str] | str:
            found = admitted(connection, identity)
            if isinstance(found, str):
                return found
            use_browser(connection, (found.id,), digest(browser))
            return found, log_in(connection, found.id, now)

        done = await hub.database.do(let_in)
        if isinstance(done, str):
            return _told(done, 403)
        answer = _told(f"You are {done[0].name}.", 200, on=True)
        self._pages.remember(answer, done[1], browser)
        answer.delete_cookie(self._cookie, path=START)
        return answer

    @property
    def _cookie(self) -> str:
        return f"{self._hub.settings.cookie}_login"

    def _now(self) -> "Provider | None":
        """Return the provider that the course has now."""
        settings = self._people.course.login
        if settings is None or not self._hub.how_in.provider:
            return None
        if self._provider is None or self._provider.settings != settings:
            from vrts.live.entrance.provider.provider import Provider  # without it never loaded

            self._provider = Provider(settings, f"{self._hub.ways.address}{BACK}")
        return self._provider


def admitted(connection: Connection, identity: "Identity") -> Account | str:
    """Return the account of who came back, or why they do not come in."""
    person = by_subject(connection, identity.subject)
    if person is None:
        if not identity.known_by:
            return NOT_TOLD
        if not identity.verified:
            return UNVERIFIED
        person = by_claim(connection, identity.known_by)
        if person is None or not person.listed:
            return STRANGER
        if person.subject is not None:
            return OTHER
        keep_person(connection, person._replace(subject=identity.subject))
    account = account_of(connection, person.account)
    return f"{GONE[0].upper()}{GONE[1:]}." if account is None else account


def _told(text: str, status: int, *, on: bool = False) -> Response:
    """Return a page that says something, and leads on."""
    refresh = '<meta http-equiv="refresh" content="0;url=/">' if on else ""
    link = "Go on" if on else "To the entrance"
    page = _PAGE.format(on=refresh, text=html.escape(text), link=link)
    return Response(page, status, media_type="text/html")
