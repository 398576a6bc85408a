"""What is asked over HTTP: the page and its files, who one is, scenes, logs."""

import asyncio
from collections.abc import Awaitable, Callable
from contextlib import suppress
from typing import Final

import msgspec
from starlette.requests import Request
from starlette.responses import Response

from vrts.live.front.bodies import JSON, as_json
from vrts.live.front.browsers import browsers_of, keep_browser
from vrts.live.front.guard import refused
from vrts.live.front.static_files import PAGE, Content, StaticFiles, content
from vrts.live.lasting.clock import wall
from vrts.live.logs.replay_page import NoPage, Order, replay_page
from vrts.live.logs.voices import Said
from vrts.live.protocol.over_http import Carried, Me, Still
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.entering import log_out, room_for
from vrts.live.rooms.hub import Hub, may_see
from vrts.live.rooms.keeping import announce
from vrts.live.rooms.resting.last_seen import drawn
from vrts.live.rooms.wall import still
from vrts.live.store import accounts
from vrts.live.store.accounts import LOGIN_S, Account
from vrts.live.store.log import export
from vrts.live.store.rooms import said_to_all
from vrts.live.store.waiting.journal import NO_ROOM

LONGEST_TOKEN: Final = 128  # characters

Handler = Callable[[Request], Awaitable[Response]]


class Pages:
    """The handlers."""

    def __init__(self, hub: Hub, files: StaticFiles) -> None:
        """Serve a hub."""
        self._hub = hub
        self._files = files
        self._scenes: dict[str, Content] = {}
        self._replaying = asyncio.Lock()

    async def page(self, request: Request) -> Response:
        """Return the page; it brings along who one is, and a room's first picture as numbers."""
        found = self._files.find(PAGE)
        carried = await self._carried(request)
        if carried is None or found is None:
            return self._file(request, PAGE)
        page = await asyncio.to_thread(_with, found, carried)  # others are served meanwhile
        return page.answer(request, cache="no-store")

    async def file(self, request: Request) -> Response:
        """Return a file of the page."""
        return self._file(request, request.path_params["path"])

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
        scene = b"" if room is None else drawn(room)
        if room is None or not scene or room.session != session:
            return refused(404, "scene", "there is no such scene any more")
        if not may_see(account, room):
            return refused(403, "room", "this link is for another room")
        key = f"{room.id}/{session}"
        if key not in self._scenes:
            for old in list(self._scenes):  # of sessions of before, and of rooms that are closed
                id_ = old.partition("/")[0]
                if id_ == room.id or id_ not in self._hub.rooms:
                    del self._scenes[old]
            self._scenes[key] = content(scene, JSON)
        return self._scenes[key].answer(request, cache="private, no-cache")

    async def log(self, request: Request) -> Response:
        """Return the log of a room, open or closed, to supervisors: JSON Lines."""
        account, room = await self.who(request.cookies), request.path_params["room"]
        if account is None or not account.leads_in(room):
            return refused(403, "role", "only a supervisor may do this")
        names = request.query_params.get("names", "1") != "0"
        text = await self._hub.database.do(lambda c: export(c, room, names=names))
        await self._tell_owner(account, room, "the log")
        headers = {"content-disposition": f'attachment; filename="log-{_file_name(room)}.jsonl"'}
        return Response(text, headers=headers, media_type="application/jsonl")

    async def replay(self, request: Request) -> Response:
        """Return the page of a room's last session with a replay, to supervisors, as a file.

        Its code is inside it, so it is none of the pages that this server may show.
        """
        account = await self.who(request.cookies)
        hub, room = self._hub, request.path_params["room"]
        if account is None or not account.leads_in(room):
            return refused(403, "role", "only a supervisor may do this")
        if room not in hub.rooms:
            return refused(404, "room", "there is no such room any more")
        if self._replaying.locked():
            return refused(503, "busy", "another replay is being made", "try again in a while")
        await self._tell_owner(account, room, "a replay")
        async with self._replaying:
            log = await hub.database.do(lambda c: export(c, room, names=True))
            said = await hub.database.do(lambda c: said_to_all(c, room))
            chat = tuple(Said(*line) for line in said)  # a page is handed on: no private lines
            shown = hub.rooms[room]
            own = hub.place(shown)
            places = tuple(
                own if own is not None and one.id == own.id else one for one in hub.settings.places
            )
            order = Order(shown.kept.name, log, places, chat)
            try:
                page = await replay_page(order)
            except NoPage as problem:
                return refused(409, "replay", str(problem), "`vrts replay` tells more of a log")
        headers = {"content-disposition": f'attachment; filename="{_file_name(room)}.html"'}
        return Response(page, headers=headers, media_type="text/html")

    async def _tell_owner(self, account: Account, id_: str, what: str) -> None:
        """Say in a room of somebody's own that another has looked at what was done there."""
        room = self._hub.rooms.get(id_)
        if room is not None and room.own is not None and not room.is_own(account):
            await announce(self._hub, room, f"{account.name} has fetched {what} of this room")

    async def _carried(self, request: Request) -> Carried | None:
        hub, query = self._hub, request.query_params
        if request.url.path != "/" or "wall" in query:
            return None
        with suppress(NO_ROOM):  # the page comes without it then
            account = await self.who(request.cookies)
            if account is None:
                return None
            picture: Still | None = None
            with suppress(NotObeyed):  # who joins the room is told why
                wanted = hub.projector if "projector" in query else query.get("room", "")
                room = room_for(hub, account, wanted)
                picture = still(room) if may_see(account, room) else None
            return Carried(wall(), self._who_is(account), picture)
        return None

    async def who(self, cookies: dict[str, str]) -> Account | None:
        """Return whose cookie this is."""
        token = cookies.get(self._hub.settings.cookie, "")
        if not token or len(token) > LONGEST_TOKEN:
            return None
        return await self._hub.database.do(lambda c: accounts.who(c, token, wall()))

    def _file(self, request: Request, path: str) -> Response:
        found = self._files.find(path)
        if found is None:
            return refused(404, "file", "there is no such page")
        return found.answer(request)

    def logged_in(self, account: Account, token: str, browser: str) -> Response:
        """Return the answer to who has come in, with the cookies."""
        answer = self._me(account)
        self.remember(answer, token, browser)
        return answer

    def remember(self, answer: Response, token: str, browser: str) -> None:
        """Give an answer the cookies of who has come in."""
        settings = self._hub.settings
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

    def _me(self, account: Account) -> Response:
        return as_json(self._who_is(account))

    def _who_is(self, account: Account) -> Me:
        settings = self._hub.settings
        rooms, may_reset = self._hub.entries(account), settings.students_reset
        alone, course = settings.alone, self._hub.course
        robots, leads = self._hub.robots, account.leads_any
        teaches = leads and bool(self._hub.how_in.title)
        who = (account.name, account.supervisor, rooms, alone, may_reset)
        return Me(*who, course, robots, leads, teaches)


def _with(page: Content, carried: Carried) -> Content:
    """Return a page that brings something along."""
    block = b'<script type="application/json" id="carried">%s</script>\n</body>'
    data = msgspec.json.encode(carried).replace(b"<", rb"\u003c")  # nothing ends the block
    return content(page.plain.replace(b"</body>", block % data, 1), page.type)


def _file_name(room: str) -> str:
    return "".join(c for c in room if c.isalnum())


def _nobody() -> Response:
    return refused(401, "login", "nobody is logged in", "open the join link again")
