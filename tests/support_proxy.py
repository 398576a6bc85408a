"""A reverse proxy that does TLS, as small as one can be: it passes `Host` and WebSockets on."""

import asyncio
import ssl
import subprocess
import threading
from collections.abc import Awaitable, Callable
from contextlib import suppress
from pathlib import Path
from types import TracebackType

Handler = Callable[[asyncio.StreamReader, asyncio.StreamWriter], Awaitable[None]]


def certificate(folder: Path, name: str) -> tuple[Path, Path]:
    """Make a certificate for a name; return its file and that of its key."""
    certificate, key = folder / "cert.pem", folder / "key.pem"
    words = f"req -x509 -newkey rsa:2048 -nodes -subj /CN={name} -days 2"
    words += f" -addext subjectAltName=DNS:{name} -keyout {key} -out {certificate}"
    subprocess.run(["openssl", *words.split()], check=True, capture_output=True)
    return certificate, key


class TlsProxy:
    """Takes TLS connections and passes them on to a port of this machine in the clear.

    It adds to the head of the first request of a connection from where that came, as proxies do.
    At `plain_port` it takes connections in the clear and does the client's TLS for them: one TLS
    connection must not be read and written by two threads, as WebSockets without asyncio do.
    """

    def __init__(self, folder: Path, name: str) -> None:
        self._name = name
        self.certificate, key = certificate(folder, name)
        self._as_server = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        self._as_server.load_cert_chain(self.certificate, key)
        self._as_client = ssl.create_default_context(cafile=str(self.certificate))
        self.port = self.plain_port = self.target = 0
        self.client = "192.0.2.1"  # from where connections seem to come
        self._loop = asyncio.new_event_loop()
        self._tasks: set[asyncio.Task[None]] = set()
        self._thread = threading.Thread(target=self._loop.run_forever, daemon=True)

    def __enter__(self) -> "TlsProxy":
        self._thread.start()
        asyncio.run_coroutine_threadsafe(self._listen(), self._loop).result()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        asyncio.run_coroutine_threadsafe(self._close(), self._loop).result()
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    async def _listen(self) -> None:
        self._servers = (
            await asyncio.start_server(self._kept(self._serve), "127.0.0.1", ssl=self._as_server),
            await asyncio.start_server(self._kept(self._tunnel), "127.0.0.1"),
        )
        self.port, self.plain_port = (
            server.sockets[0].getsockname()[1] for server in self._servers
        )

    async def _close(self) -> None:
        for server in self._servers:
            server.close()
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)

    def _kept(self, handler: Handler) -> Callable[..., None]:
        """Return what begins a task for a connection, which `_close` ends."""

        async def handle(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            with suppress(OSError):  # one end is gone
                await handler(reader, writer)
            writer.close()

        def begin(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            task = self._loop.create_task(handle(reader, writer))
            self._tasks.add(task)
            task.add_done_callback(self._tasks.discard)

        return begin

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        client = self.client
        try:
            head = await reader.readuntil(b"\r\n\r\n")
        except asyncio.IncompleteReadError:
            return
        inside_reader, inside = await asyncio.open_connection("127.0.0.1", self.target)
        inside.write(_told(head, client))
        await _join(reader, inside, inside_reader, writer)

    async def _tunnel(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        inside_reader, inside = await asyncio.open_connection(
            "127.0.0.1", self.port, ssl=self._as_client, server_hostname=self._name
        )
        await _join(reader, inside, inside_reader, writer)


def _told(head: bytes, client: str) -> bytes:
    """Return the head of a request with from where it came."""
    first, rest = head.split(b"\r\n", 1)
    added = f"X-Forwarded-For: {client}\r\nX-Forwarded-Proto: https\r\n".encode()
    lines = rest.split(b"\r\n")
    known = [n for n, line in enumerate(lines) if line.lower().startswith(b"x-forwarded-for:")]
    if known:  # what the client says itself comes first
        lines[known[0]] += b", " + client.encode()
        added = b"X-Forwarded-Proto: https\r\n"
    return first + b"\r\n" + added + b"\r\n".join(lines)


async def _join(
    reader: asyncio.StreamReader,
    inside: asyncio.StreamWriter,
    inside_reader: asyncio.StreamReader,
    writer: asyncio.StreamWriter,
) -> None:
    """Pass on in both directions until both have ended."""
    await asyncio.gather(_pass_on(reader, inside), _pass_on(inside_reader, writer))


async def _pass_on(source: asyncio.StreamReader, sink: asyncio.StreamWriter) -> None:
    try:
        with suppress(OSError):  # one end is gone
            while data := await source.read(1 << 16):
                sink.write(data)
                await sink.drain()
    finally:
        sink.close()
