"""The application: routes, and what starts and ends with it."""

import gc
from collections.abc import AsyncGenerator
from contextlib import asynccontextmanager, suppress
from functools import partial

from starlette.applications import Starlette
from starlette.requests import HTTPConnection
from starlette.responses import Response
from starlette.routing import Route, WebSocketRoute
from starlette.types import ASGIApp
from starlette.websockets import WebSocket

from vrts.live.editing.seats import Seats
from vrts.live.front.added import Adding
from vrts.live.front.browsers import browsers_of
from vrts.live.front.entrances import EntrancePages
from vrts.live.front.guard import Guard, refused
from vrts.live.front.hop import Hop
from vrts.live.front.http import Pages
from vrts.live.front.origin import Names
from vrts.live.front.past import PastPages
from vrts.live.front.program_pages import ProgramPages
from vrts.live.front.sockets.help_socket import serve_help
from vrts.live.front.sockets.rehearsal_socket import rehearsal_socket
from vrts.live.front.sockets.socket import serve_socket
from vrts.live.front.static_files import StaticFiles
from vrts.live.rehearsing.offering import Rehearsals
from vrts.live.rooms.hub import DISK_HELP, NO_DISK, Hub
from vrts.live.rooms.opening import make_room, open_kept
from vrts.live.rooms.own.hands import show_hands_to
from vrts.live.rooms.own.sleeping import Sleeper
from vrts.live.rooms.pulse import pulse
from vrts.live.rooms.sessions import Sessions
from vrts.live.settings import DATABASE, EDITING, REHEARSING, Settings
from vrts.live.store.accounts import Account
from vrts.live.store.database import Database
from vrts.live.store.waiting.journal import NO_ROOM
from vrts.live.watching.admin import AdminPage
from vrts.live.watching.health import HealthPage


def application(
    settings: Settings,
    address: str,
    rooms: tuple[str, ...],
    *,
    with_code: bool,
    hop: Hop | None = None,
    adding: Adding | None = None,
) -> ASGIApp:
    """Return the server's application.

    Args:
        settings: What it is told.
        address: Where browsers find the server, without a slash at the end.
        rooms: Names of the rooms to begin with, in the first scene, where the database has none.
        with_code: Whether there is a class code.
        hop: A proxy on this machine passes requests on.
        adding: Makes what another part of vrts adds, such as a course.
    """
    signs = not settings.alone  # nothing is left behind of who teaches alone
    database = Database(settings.folder / DATABASE, settings.log_key, signs=signs)
    hub = Hub(settings, database, address, with_code=with_code)
    sessions = Sessions(hub)
    seats: Seats[int] = Seats(settings.folder / EDITING)
    rehearsals = Rehearsals(settings.folder / REHEARSING)
    pages = Pages(hub, StaticFiles())
    entrances = EntrancePages(hub, pages)
    past = PastPages(hub, pages.who)
    health = HealthPage(hub)
    admin = AdminPage(hub, pages.who, health)
    sleeper = Sleeper(hub, sessions)
    hub.sleeping = sleeper
    hub.settled = partial(show_hands_to, hub)
    added = None if adding is None else adding(hub, sessions, pages)

    @asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncGenerator[None, None]:
        await hub.ways.open()
        await open_kept(hub)
        for room in hub.rooms.values():
            sessions.begin(room)
        if not hub.rooms:
            for name in rooms:
                sessions.begin(await make_room(hub, name, settings.places[0].id))
        if added is not None:
            await added.open()
        hub.spawn(sessions.prepare())
        hub.spawn(pulse(hub, *((sleeper,) if added is None else (sleeper, added))))
        gc.collect()
        gc.freeze()  # what is loaded is needed for good: no collection has to look at it again
        yield
        if added is not None:
            await added.close()
        seats.stop()
        await rehearsals.stop()
        sessions.stop()
        await hub.stop()

    async def socket(websocket: WebSocket) -> None:
        try:
            account = await pages.who(websocket.cookies)
        except NO_ROOM as problem:
            await websocket.send_denial_response(no_disk(websocket, problem))
            return
        browsers = browsers_of(websocket.cookies, settings)
        await serve_socket(hub, sessions, websocket, account, browsers)

    async def help_(websocket: WebSocket) -> None:
        async def still() -> bool:
            with suppress(NO_ROOM):  # nobody logs out or is purged then
                return await pages.who(websocket.cookies) is not None
            return True

        account = await pages.who(websocket.cookies)
        await serve_help(seats, websocket, account, still)

    async def rehearse(websocket: WebSocket) -> None:
        async def who() -> Account | None:
            return await pages.who(websocket.cookies)

        await rehearsal_socket(hub, rehearsals, websocket, who)

    def no_disk(_: HTTPConnection, __: Exception) -> Response:
        return refused(503, "disk", NO_DISK, DISK_HELP)

    app = Starlette(
        lifespan=lifespan,
        exception_handlers={NO_ROOM: no_disk},
        routes=[
            *(() if added is None else added.routes()),  # first: they have files of their own
            Route("/", pages.page),
            Route("/web/{path:path}", pages.file),
            Route("/door", entrances.door),
            Route("/enter", entrances.enter, methods=["POST"]),
            Route("/login", entrances.login, methods=["POST"]),
            Route("/logout", pages.logout, methods=["POST"]),
            Route("/me", pages.me),
            Route("/scene/{room}/{session:int}", pages.scene),
            Route("/past/{room}/{session:int}/{number:int}", past.block),
            Route("/log/{room}", pages.log),
            Route("/replay/{room}", pages.replay),
            Route("/link", entrances.link, methods=["POST"]),
            Route("/code", entrances.code),
            Route("/health", health.answer),
            Route("/admin", pages.page),
            Route("/admin/now", admin.now),
            Route("/code.svg", entrances.code_picture),
            Route("/ways", entrances.ways),
            Route("/ways", entrances.change, methods=["POST"]),
            WebSocketRoute("/ws", socket),
            WebSocketRoute("/lsp", help_),
            WebSocketRoute("/rehearse", rehearse),
            *ProgramPages(hub, pages.who).routes(),
        ],
    )
    return Guard(app, Names(settings.names), secure=settings.secure, hop=hop)
