"""Connections that say nothing, say it without end, or far too fast: they end, others go on."""

import asyncio
import logging
import socket
import subprocess
import sys
from collections.abc import AsyncGenerator, Iterator
from contextlib import asynccontextmanager

import msgspec
import pytest
import uvicorn
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from tests.support_live import LiveServer
from vrts.live.callers import patient
from vrts.live.callers.frames import FRAMES
from vrts.live.callers.patient import PatientProtocol
from vrts.live.callers.pieces import InPieces
from vrts.live.front import bodies

HEAD = b"Host: x\r\nContent-Type: application/json\r\n"
LONG = bytes(range(256)) * 120_000  # more than the buffers of a network hold
GET_LONG = b"GET /long HTTP/1.1\r\n" + HEAD + b"\r\n"
GET = b"GET / HTTP/1.1\r\n" + HEAD + b"\r\n"
POST = b"POST / HTTP/1.1\r\n" + HEAD + b"Content-Length: 100\r\n\r\n{"
PATIENCE = 20.0  # [s]
OPEN: list[asyncio.StreamWriter] = []


class Asked(msgspec.Struct):
    """What the page of the test takes."""


async def page(request: Request) -> Response:
    if request.method == "GET":
        return Response("here")
    body = await bodies.read_body(request, Asked)
    return body if isinstance(body, Response) else Response("taken")


async def long(_: Request) -> Response:
    return Response(LONG)


@asynccontextmanager
async def served(*, pieces: bool = False) -> AsyncGenerator[int]:
    """Serve a page; give the port."""
    listener = socket.create_server(("127.0.0.1", 0))
    routes = [Route("/", page, methods=["GET", "POST"]), Route("/long", long)]
    app = Starlette(routes=routes)
    config = uvicorn.Config(
        InPieces(app) if pieces else app, http=PatientProtocol, lifespan="off", log_config=None
    )
    server = uvicorn.Server(config)
    server.install_signal_handlers = lambda: None  # type: ignore[attr-defined]
    task = asyncio.create_task(server.serve(sockets=[listener]))
    yield int(listener.getsockname()[1])
    while OPEN:
        OPEN.pop().close()
    server.should_exit = True
    await task


async def said(port: int, words: bytes) -> tuple[asyncio.StreamReader, asyncio.StreamWriter]:
    """Open a connection, and say something."""
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    OPEN.append(writer)
    writer.write(words)
    await writer.drain()
    return reader, writer


async def left(reader: asyncio.StreamReader) -> bytes:
    """Return what comes until the connection ends."""
    found = b""
    async with asyncio.timeout(PATIENCE):
        try:
            while data := await reader.read(4096):
                found += data
        except ConnectionResetError:
            pass
    return found


def test_who_never_ends_a_head_is_closed_and_who_asks_is_answered(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(patient, "HEAD_S", 2.0)
    monkeypatch.setattr(patient, "LOOK_S", 0.05)

    async def work() -> None:
        async with served() as port:
            silent, _ = await said(port, b"")
            slow, _ = await said(port, b"GET / HTTP/1.1\r\nHo")
            asks, writer = await said(port, GET)
            assert (await asks.readuntil(b"here")).startswith(b"HTTP/1.1 200")
            writer.write(b"GET / HT")  # and then the next one, without an end
            assert await left(silent) == await left(slow) == await left(asks) == b""

    asyncio.run(work())


@pytest.mark.parametrize("pieces", [False, True])
def test_an_answer_may_take_long_as_long_as_it_is_taken(
    monkeypatch: pytest.MonkeyPatch, *, pieces: bool
) -> None:
    monkeypatch.setattr(patient, "HEAD_S", 0.2)
    monkeypatch.setattr(patient, "LOOK_S", 0.05)
    monkeypatch.setattr(patient, "STALL_S", PATIENCE)
    monkeypatch.setattr(patient, "MOST", 2)

    async def work() -> None:
        async with served(pieces=pieces) as port:
            reader, _ = await said(port, GET_LONG)
            head = await reader.readuntil(b"\r\n\r\n")
            assert head.startswith(b"HTTP/1.1 200")
            await asyncio.sleep(1.0)  # it is on its way meanwhile, and others come
            for _ in range(3):
                await said(port, b"")
            await asyncio.sleep(0.2)
            async with asyncio.timeout(PATIENCE):
                assert await reader.readexactly(len(LONG)) == LONG

    asyncio.run(work())


@pytest.mark.parametrize("pieces", [False, True])
def test_who_takes_nothing_of_an_answer_is_closed(
    monkeypatch: pytest.MonkeyPatch, *, pieces: bool
) -> None:
    monkeypatch.setattr(patient, "STALL_S", 0.5)
    monkeypatch.setattr(patient, "LOOK_S", 0.05)

    async def work() -> None:
        async with served(pieces=pieces) as port:
            reader, _ = await said(port, GET_LONG)
            await reader.readuntil(b"\r\n\r\n")
            await asyncio.sleep(2.0)
            assert len(await left(reader)) < len(LONG)

    asyncio.run(work())


def test_a_head_without_end_is_closed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(patient, "HEAD_S", 1000.0)  # it is the length

    async def work() -> None:
        async with served() as port:
            reader, writer = await said(port, b"GET / HTTP/1.1\r\n")
            for _ in range(patient.LONGEST_HEAD // 1000 + 2):
                writer.write(b"x: " + b"a" * 1000 + b"\r\n")
            assert b"200" not in await left(reader)

    asyncio.run(work())


def test_where_there_are_too_many_who_has_been_silent_for_longest_goes(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(patient, "MOST", 3)

    async def work() -> None:
        async with served() as port:
            first, _ = await said(port, b"GET ")
            others = [await said(port, b"GET ") for _ in range(2)]
            asks, _ = await said(port, GET)
            assert b"here" in await asks.readuntil(b"here")
            assert await left(first) == b""
            others[1][1].write(b"/ HTTP/1.1\r\n" + HEAD + b"\r\n")
            assert b"here" in await others[1][0].readuntil(b"here")

    asyncio.run(work())


def test_a_body_that_does_not_come_is_waited_for_only_so_long(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(bodies, "BODY_S", 0.2)

    async def work() -> bytes:
        async with served() as port:
            gone, writer = await said(port, POST)
            writer.close()
            reader, _ = await said(port, POST)
            answer = await reader.readuntil(b"\r\n\r\n")
            await left(gone)
        return answer

    with caplog.at_level(logging.ERROR):
        assert asyncio.run(work()).startswith(b"HTTP/1.1 408")
    assert not caplog.records, "who goes away in the middle is no fault of the server"


@pytest.mark.thorough
@pytest.mark.parametrize("flood", [b"\x89\x80", b"\x00\x80", b"\x81\x90"])
def test_who_sends_far_too_many_frames_is_ended_and_holds_up_nobody(
    server: LiveServer, flood: bytes
) -> None:
    eve, anna = (server.join(server.enter(name)) for name in ("Eve", "Anna"))
    eve.wait("snapshot")
    anna.wait("snapshot")
    frame = flood + bytes(4) + (b'{"type":"panic"}' if flood == b"\x81\x90" else b"")
    begun = b"\x01\x80" + bytes(4) if flood[0] == 0 else b""  # a message in empty parts
    eve.socket.socket.sendall(begun + frame * (2 * int(FRAMES[1])))
    eve.closed()
    anna.send("raise_hand", up=True)
    anna.wait(
        "people",
        lambda m: (
            {"hand", "away"} <= {key for one in m["people"] for key in one if one[key] is True}
        ),
    )
    server.join(server.enter("Ben")).wait("snapshot")


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("floods") / "live") as started:
        yield started


def test_as_many_files_may_be_open_as_the_system_allows() -> None:
    words = (
        "import resource as r; from vrts.live.callers.open_files import raise_limit;"
        "r.setrlimit(r.RLIMIT_NOFILE, ({soft}, {hard}));"
        "print(raise_limit(), *r.getrlimit(r.RLIMIT_NOFILE))"
    )
    for soft, hard in ((256, 700), (700, 700)):
        command = [sys.executable, "-c", words.format(soft=soft, hard=hard)]
        said = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        assert said.split() == ["700", "700", "700"]
