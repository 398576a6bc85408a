"""The application: routes, and what goes on beside them."""

import asyncio
from collections.abc import AsyncGenerator
from contextlib import asynccontextmanager
from typing import Final, NamedTuple

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import RedirectResponse, Response
from starlette.routing import Route
from starlette.types import ASGIApp, Receive, Scope, Send

from vrts.desk.again.marking import Marking
from vrts.desk.desk import Desk
from vrts.desk.front.answers import refusal
from vrts.desk.front.class_pages import ClassPages
from vrts.desk.front.deed_pages import DeedPages
from vrts.desk.front.door import Door
from vrts.desk.front.events import Events
from vrts.desk.front.file_pages import FilePages
from vrts.desk.front.policy import Policy
from vrts.desk.programs import Programs
from vrts.desk.upkeep import Upkeep
from vrts.live.front.guard import Guard
from vrts.live.front.origin import Names
from vrts.live.front.static_files import StaticFiles
from vrts.live.lasting.clock import steady
from vrts.live.limits import Bucket

PAGE: Final = "desk/index.html"
LOOK_S: Final = 0.4  # between looks whether another desk, or anybody, has changed the files
REQUESTS: Final = (200.0, 1000.0)  # a second, and at once


class Way(NamedTuple):
    """How browsers come in."""

    token: str  # that the address has
    port: int


def application(desk: Desk, marking: Marking, upkeep: Upkeep, door: Way, events: Events) -> ASGIApp:
    """Return the desk's application.

    Args:
        desk: Whose.
        marking: Marks again.
        upkeep: Brings files up to date.
        door: How browsers come in.
        events: Who listens to what happens.
    """
    files = StaticFiles(PAGE)
    pages = ClassPages(desk, Programs(), marking, upkeep)
    deeds = DeedPages(desk, marking, upkeep)
    reports = FilePages(desk)

    async def page(request: Request) -> Response:
        return _asset(files, request, PAGE)

    async def asset(request: Request) -> Response:
        return _asset(files, request, request.path_params["path"])

    async def overview(_: Request) -> Response:
        return RedirectResponse("/", 303)  # the desk is the overview of its class

    @asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncGenerator[None, None]:
        loop = asyncio.get_running_loop()

        def marks() -> None:
            told = marking.told(desk.now().book.opened)
            if not told.running:
                upkeep.wanted()  # what was decided while it went on
            loop.call_soon_threadsafe(events.send, "marking", told)

        marking.changed = marks
        upkeep.begin()
        watching = asyncio.create_task(_watch(desk, events))
        yield
        watching.cancel()
        marking.changed = lambda: None
        await asyncio.to_thread(marking.end)
        await asyncio.to_thread(upkeep.end)
        await asyncio.gather(watching, return_exceptions=True)

    app = Starlette(
        lifespan=lifespan,
        routes=[
            Route("/", page),
            Route("/web/{path:path}", asset),
            Route("/api/class", pages.whole),
            Route("/api/row/{student}", pages.row),
            Route("/api/statistics", pages.statistics),
            Route("/api/records", deeds.records, methods=["POST"]),
            Route("/api/mark", deeds.mark, methods=["POST"]),
            Route("/api/mark", deeds.cancel, methods=["DELETE"]),
            Route("/api/events", events.listen),
            Route("/files/staff/students/{student}/{name}", reports.staff_report),
            Route("/files/students/{student}/{name}", reports.sent_report),
            Route("/files/staff/index.html", overview),
            Route("/files/staff/similarity/{name}", reports.pair),
            Route("/files/staff/{name}", reports.alike),
        ],
        exception_handlers={404: _no_such, 405: _no_such},
    )
    entered = Door(Limited(app), door.token, door.port)  # who is not let in uses up nothing
    return Policy(Guard(entered, Names(()), secure=False))


class Limited:
    """Wraps the application; whoever asks far too often is told so."""

    def __init__(self, app: ASGIApp) -> None:
        """Wrap an application."""
        self._app = app
        self._bucket = Bucket(*REQUESTS)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request."""
        if scope["type"] == "http" and not self._bucket.take(steady()):
            await refusal(429, "too many requests: wait a moment")(scope, receive, send)
            return
        await self._app(scope, receive, send)


async def _watch(desk: Desk, events: Events) -> None:
    """Tell everybody when something that is shown has changed."""
    last = desk.now().revision
    while True:
        await asyncio.sleep(LOOK_S)
        try:
            revision = (await asyncio.to_thread(desk.now)).revision
        except OSError:  # such as too many open files: whoever asks is told; it goes on
            continue
        if revision != last:
            last = revision
            events.send("revision", {"revision": revision})


def _asset(files: StaticFiles, request: Request, path: str) -> Response:
    found = files.find(path)
    return refusal(404, "there is no such file") if found is None else found.answer(request)


def _no_such(_: Request, __: Exception) -> Response:
    return refusal(404, "there is nothing here")
