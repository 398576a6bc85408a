"""What is asked over HTTP: the page and its files, entering, scenes, logs, the class code."""

import asyncio
import time
from collections.abc import Awaitable, Callable
from typing import Final, TypeVar

import msgspec
from starlette.requests import Request
from starlette.responses import Response

from vrts.live.front.browsers import browser_token, browsers_of, keep_browser
from vrts.live.front.guard import refused
from vrts.live.front.qr_code import qr_svg
from vrts.live.front.static_files import PAGE, Content, StaticFiles, content
from vrts.live.logs.replay_page import NoPage, Order, replay_page
from vrts.live.logs.voices import Said
from vrts.live.people.naming import person_name
from vrts.live.protocol.over_http import Enter, Link, LogIn, MakeLink, Me
from vrts.live.rooms.entering import log_out
from vrts.live.rooms.hub import Hub
from vrts.live.store import accounts
from vrts.live.store.accounts import LINK_S, LINK_USES, LOGIN_S, Account
from vrts.live.store.bars import Inherited, inherit, use_browser
from vrts.live.store.database import Connection
from vrts.live.store.log import export
from vrts.live.store.rooms import said_to_all
from vrts.live.tokens import digest, new_token

LONGEST_BODY: Final = 8 * 1024  # bytes
LONGEST_TOKEN: Final = 128  # characters
JSON: Final = "application/json"

Body = TypeVar("Body")
Handler = Callable[[Request], Awaitable[Response]]


class Pages:
    """The handlers."""

    def __init__(self, hub: Hub, files: StaticFiles, code: str, address: str) -> None:
        """Serve a hub; `code` is the class code (empty: none), `address` where browsers find us."""
        self._hub = hub
        self._files = files
        self._code = code
        self._address = address
        self._scenes: dict[str, Content] = {}
        self._replaying = asyncio.Lock()

    async def page(self, request: Request) -> Response:
        """Return the page."""
        return self._file(request, PAGE)

    async def file(self, request: Request) -> Response:
        """Return a file of the page."""
        return self._file(request, request.path_params["path"])

    async def enter(self, request: Request) -> Response:
        """Let somebody in who has a join link or the class code."""
        hub, now = self._hub, time.time()
        body = await _body(request, Enter)
        if isinstance(body, Response):
            return body
        address = _address(request)
        if hub.failures.blocked(address, time.monotonic()):
            return _wait()

        token = request.cookies.get(hub.settings.cookie, "")
        browser = browser_token(request.cookies, hub.settings)
        inherited: list[Inherited] = []

        def let_in(connection: Connection) -> tuple[Account, str] | None:
            account = accounts.enter(connection, body.code, body.name, now)
            if account is None:
                return None
            old = accounts.who(connection, token[:LONGEST_TOKEN], now)
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
            hub.failures.failed(address, time.monotonic())
            return refused(403, "code", "there is no such code or link", "ask for a new one")
        for bars, muted in inherited:
            for room, name in bars:
                if room in hub.rooms:
                    hub.rooms[room].barred[found[0].id] = name
            if muted:
                hub.muted[found[0].id] = muted
        return self._logged_in(*found, browser)

    async def login(self, request: Request) -> Response:
        """Let somebody in who has a local account."""
        hub, now = self._hub, time.time()
        body = await _body(request, LogIn)
        if isinstance(body, Response):
            return body
        address = _address(request)
        if hub.failures.blocked(address, time.monotonic()):
            return _wait()
        found = await hub.database.do(lambda c: accounts.password_of(c, body.user))
        right = await hub.passwords.right(body.password, found[1] if found else None)
        if right is None:
            return refused(503, "busy", "too many log in at once", "try again in a few seconds")
        if found is None or not right:
            hub.failures.failed(address, time.monotonic())
            return refused(403, "login", "user or password is wrong")
        account = found[0]
        browser = browser_token(request.cookies, hub.settings)

        def let_in(connection: Connection) -> str:
            use_browser(connection, (account.id,), digest(browser))
            return accounts.log_in(connection, account.id, now)

        return self._logged_in(account, await hub.database.do(let_in), browser)

    async def logout(self, request: Request) -> Response:
        """End the cookie, and the connections of the browser, at once."""
        hub = self._hub
        answer = Response(status_code=204)
        answer.delete_cookie(hub.settings.cookie)
        token = request.cookies.get(hub.settings.cookie, "")
        await hub.database.do(lambda c: accounts.log_out(c, token))
        if token:
            log_out(hub, browsers_of(request.cookies, hub.settings))
        return answer

    async def me(self, request: Request) -> Response:
        """Tell who is logged in."""
        account = await self.who(request.cookies)
        return _nobody() if account is None else self._me(account)

    async def scene(self, request: Request) -> Response:
        """Return what is to be drawn of a session."""
        account = await self.who(request.cookies)
        if account is None:
            return _nobody()
        room = self._hub.rooms.get(request.path_params["room"])
        session = request.path_params["session"]
        process = None if room is None else room.process
        if room is None or process is None or not process.ready or room.session != session:
            return refused(404, "scene", "there is no such scene any more")
        if room.entry not in self._hub.entries(account):
            return refused(403, "room", "this link is for another room")
        key = f"{room.id}/{session}"
        if key not in self._scenes:
            old = [k for k in self._scenes if k.startswith(f"{room.id}/")]
            for k in old:
                del self._scenes[k]
            self._scenes[key] = content(process.scene, JSON)
        return self._scenes[key].answer(request, cache="private, no-cache")

    async def log(self, request: Request) -> Response:
        """Return the log of a room, open or closed, to supervisors: JSON Lines."""
        account = await self.who(request.cookies)
        if account is None or not account.supervisor:
            return refused(403, "role", "only a supervisor may do this")
        room = request.path_params["room"]
        names = request.query_params.get("names", "1") != "0"
        text = await self._hub.database.do(lambda c: export(c, room, names=names))
        headers = {"content-disposition": f'attachment; filename="log-{_file_name(room)}.jsonl"'}
        return Response(text, headers=headers, media_type="application/jsonl")

    async def replay(self, request: Request) -> Response:
        """Return the page of a room's last session with a replay, to supervisors, as a file.

        Its code is inside it, so it is none of the pages that this server may show.
        """
        account = await self.who(request.cookies)
        if account is None or not account.supervisor:
            return refused(403, "role", "only a supervisor may do this")
        hub, room = self._hub, request.path_params["room"]
        if room not in hub.rooms:
            return refused(404, "room", "there is no such room any more")
        if self._replaying.locked():
            return refused(503, "busy", "another replay is being made", "try again in a while")
        async with self._replaying:
            log = await hub.database.do(lambda c: export(c, room, names=True))
            said = await hub.database.do(lambda c: said_to_all(c, room))
            chat = tuple(Said(*line) for line in said)  # a page is handed on: no private lines
            order = Order(hub.rooms[room].kept.name, log, hub.settings.places, chat)
            try:
                page = await replay_page(order)
            except NoPage as problem:
                return refused(409, "replay", str(problem), "`vrts replay` tells more of a log")
        headers = {"content-disposition": f'attachment; filename="{_file_name(room)}.html"'}
        return Response(page, headers=headers, media_type="text/html")

    async def link(self, request: Request) -> Response:
        """Make a join link for one room, for supervisors."""
        account = await self.who(request.cookies)
        if account is None or not account.supervisor:
            return refused(403, "role", "only a supervisor may do this")
        body = await _body(request, MakeLink)
        if isinstance(body, Response):
            return body
        if body.room not in self._hub.rooms:
            return refused(404, "room", "there is no such room any more")
        token, until = new_token(), time.time() + LINK_S
        await self._hub.database.do(
            lambda c: accounts.add_link(c, token, until, room=body.room, uses=LINK_USES)
        )
        url = f"{self._address}/#enter={token}"
        return _json(Link(url, qr_svg(url).decode()))

    async def code(self, request: Request) -> Response:
        """Return the class code and its link to supervisors."""
        account = await self.who(request.cookies)
        if account is None or not account.supervisor:
            return refused(403, "role", "only a supervisor may do this")
        return _json({"code": self._code, "url": self._link()})

    async def code_picture(self, request: Request) -> Response:
        """Return the QR code of the class code's link to supervisors."""
        account = await self.who(request.cookies)
        if account is None or not account.supervisor or not self._code:
            return refused(403, "role", "only a supervisor may do this")
        return Response(qr_svg(self._link()), media_type="image/svg+xml")

    async def who(self, cookies: dict[str, str]) -> Account | None:
        """Return whose cookie this is."""
        token = cookies.get(self._hub.settings.cookie, "")
        if not token or len(token) > LONGEST_TOKEN:
            return None
        return await self._hub.database.do(lambda c: accounts.who(c, token, time.time()))

    def _link(self) -> str:
        return f"{self._address}/#enter={self._code}" if self._code else ""

    def _file(self, request: Request, path: str) -> Response:
        found = self._files.find(path)
        if found is None:
            return refused(404, "file", "there is no such page")
        return found.answer(request)

    def _logged_in(self, account: Account, token: str, browser: str) -> Response:
        settings = self._hub.settings
        answer = self._me(account)
        answer.set_cookie(
            settings.cookie,
            token,
            max_age=int(LOGIN_S),
            path="/",
            secure=settings.secure,
            httponly=True,
            samesite="strict",
        )
        keep_browser(answer, browser, settings)
        return answer

    def _me(self, account: Account) -> Response:
        alone = self._hub.settings.alone
        return _json(Me(account.name, account.supervisor, self._hub.entries(account), alone))


async def _body(request: Request, kind: type[Body]) -> Body | Response:
    """Return the JSON body of a request, or why it is refused."""
    if request.headers.get("content-type", "").split(";")[0].strip() != JSON:
        return refused(415, "body", f"the body must be {JSON}")
    data = b""
    async for part in request.stream():
        data += part
        if len(data) > LONGEST_BODY:
            return refused(413, "body", "the body is too long")
    try:
        return msgspec.json.decode(data, type=kind)
    except msgspec.DecodeError as problem:
        return refused(400, "body", str(problem))


def _json(value: object) -> Response:
    return Response(msgspec.json.encode(value), media_type=JSON)


def _file_name(room: str) -> str:
    return "".join(c for c in room if c.isalnum())


def _nobody() -> Response:
    return refused(401, "login", "nobody is logged in", "open the join link again")


def _wait() -> Response:
    return refused(429, "failures", "too many failed log-ins", "wait five minutes")


def _address(request: Request) -> str:
    return request.client.host if request.client else ""
