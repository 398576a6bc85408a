"""A live server in a process of its own, and browsers reduced to their messages."""

import http.client
import json
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from types import TracebackType
from typing import Any

import psutil
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin

from tests.support_commands import Begun

PATIENCE = 25.0  # [s]; the machine may be busy
Json = dict[str, Any]


class Answer:
    """An HTTP response."""

    def __init__(self, response: http.client.HTTPResponse) -> None:
        self.status = response.status
        self.headers = response.headers
        self.body = response.read()

    @property
    def json(self) -> Json:
        return json.loads(self.body)

    @property
    def cookie(self) -> str:
        """What a browser sends from then on: who is logged in, and which browser it is."""
        return "; ".join(c.split(";")[0] for c in self.headers.get_all("set-cookie") or ())


class Browser:
    """A WebSocket, and what came by it."""

    patience = PATIENCE  # [s]

    def __init__(self, socket: ClientConnection) -> None:
        self.socket = socket
        self.came: list[Json] = []
        self.frames: list[bytes] = []
        self.number = 0

    def send(self, type_: str, **fields: Any) -> None:
        self.socket.send(json.dumps({"type": type_, **fields}))

    def wait(
        self,
        type_: str,
        fits: Callable[[Json], bool] = lambda _: True,
        patience: float | None = None,
    ) -> Json:
        """Return the next message of a type; what comes before it is kept in `came`."""
        until = time.monotonic() + (self.patience if patience is None else patience)
        while (left := until - time.monotonic()) > 0:
            try:
                message = self._next(left)
            except TimeoutError:
                break
            if message is not None and message["type"] == type_ and fits(message):
                return message
        raise AssertionError(f"no {type_} came; the last: {self.came[-5:]}")

    def answer(self, number: int) -> Json:
        """Return the result of a command, or why it was refused."""
        while True:
            message = self._next(self.patience) or {"type": ""}
            if message["type"] in ("result", "refused") and message["of"] == number:
                return message

    def quiet(self, seconds: float) -> None:
        """Take everything that comes meanwhile."""
        until = time.monotonic() + seconds
        while (left := until - time.monotonic()) > 0:
            try:
                self._next(left)
            except TimeoutError:
                return

    def take(self) -> None:
        """Take one message or frame."""
        self._next(PATIENCE)

    def take_frames(self, count: int) -> list[bytes]:
        """Take what comes until so many more frames came; return these."""
        before = len(self.frames)
        end = time.monotonic() + PATIENCE
        while len(self.frames) < before + count:
            assert time.monotonic() < end, f"{len(self.frames) - before} frames of {count} came"
            self.take()
        return self.frames[before:]

    def quiet_until_closed(self) -> None:
        """Take everything that still comes."""
        try:
            self.quiet(PATIENCE)
        except ConnectionClosed:
            return

    def closed(self) -> Json | None:
        """Read to the end; return the last message, which says why."""
        try:
            while True:
                self._next(PATIENCE)
        except ConnectionClosed:
            return self.came[-1] if self.came else None

    def take_control(self) -> str:
        """Ask for the control right; return the lease."""
        self.send("request_control")
        return self.wait("control", lambda m: m["lease"] != "")["lease"]

    def command(self, lease: str, action: str, **fields: Any) -> int:
        """Send a command; return its number."""
        self.number += 1
        self.send("command", lease=lease, number=self.number, action={"type": action, **fields})
        return self.number

    def _next(self, patience: float) -> Json | None:
        data = self.socket.recv(timeout=patience)
        if isinstance(data, bytes):
            self.frames.append(data)
            return None
        message: Json = json.loads(data)
        self.came.append(message)
        return message


def session_processes(server: int) -> list[psutil.Process]:
    """Return the processes of the sessions of a server, which is told by its process id."""
    found: list[psutil.Process] = []
    for child in psutil.Process(server).children():
        try:
            words = child.cmdline()
            if "vrts.live.nursery" in words:  # of which sessions are forks
                found += child.children()
            elif "vrts.live.session" in words:
                found.append(child)
        except (psutil.NoSuchProcess, psutil.ZombieProcess):
            continue  # gone meanwhile
    return found


def alone(*words: str, module: str = "vrts.cli.main") -> subprocess.Popen[str]:
    """Begin a command in an interpreter that has loaded nothing before."""
    command = [sys.executable, "-m", module, *words]
    return subprocess.Popen(command, stderr=subprocess.PIPE, text=True)


class LiveServer:
    """`vrts serve` on a free port."""

    module = "vrts.cli.main"  # what a server that is `measured` begins as

    def __init__(
        self,
        folder: Path,
        *options: str,
        scenes: tuple[str, ...] = ("cans-on-bases",),
        port: str = "0",
        measured: bool = False,
    ):
        """Start a server; one that is `measured` has an interpreter of its own from the start."""
        self.folder = folder
        self.measured = measured
        self._sockets = ExitStack()
        self._arguments = (*scenes, "--folder", str(folder), *options)
        self.start(port)

    def start(self, port: str) -> None:
        words = ("serve", *self._arguments, "--port", port)
        self.process = alone(*words, module=self.module) if self.measured else Begun(*words)
        assert self.process.stderr is not None
        self.said: list[str] = []
        for line in self.process.stderr:
            self.said.append(line)
            if "this machine" in line:
                break
        said = "".join(self.said)
        found = re.search(r"^serving .* https?://[^\s:]+(?::(\d+))?$", said, re.MULTILINE)
        assert found is not None, said
        self.port = int(found[1] or port)
        self.host = f"127.0.0.1:{self.port}"
        self.supervisor_token = re.findall(r"once: \S+#enter=(\S+)", said)[0]
        codes = re.findall(r"class code: ([\w-]+),", said)  # a course may have none
        self.code = codes[0].replace("-", "") if codes else ""

    def __enter__(self) -> "LiveServer":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close_browsers()
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
        assert self.process.stderr is not None
        self.process.wait(PATIENCE)
        faults = self.process.stderr.read()
        self.process.stderr.close()
        assert "Traceback" not in faults, faults

    def close_browsers(self) -> None:
        """Close all connections."""
        self._sockets.close()

    def kill(self) -> None:
        """Kill -9."""
        self.process.kill()
        self.process.wait()
        assert self.process.stderr is not None
        self.process.stderr.close()

    def request(self, method: str, path: str, body: Any = None, **headers: str) -> Answer:
        """Ask by HTTP, as a page of the server would."""
        link = http.client.HTTPConnection("127.0.0.1", self.port, timeout=4 * PATIENCE)
        data = body if isinstance(body, bytes | None) else json.dumps(body).encode()
        all_headers = {"host": self.host, "origin": f"http://{self.host}"}
        if body is not None:
            all_headers["content-type"] = "application/json"
        all_headers |= {name.replace("_", "-"): value for name, value in headers.items()}
        try:
            link.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
            for name, value in all_headers.items():
                if value:
                    link.putheader(name, value)
            if data is not None:
                link.putheader("content-length", str(len(data)))
            link.endheaders(data)
            return Answer(link.getresponse())
        finally:
            link.close()

    def enter(self, name: str, code: str | None = None) -> str:
        """Enter by the class code; return the cookie."""
        answer = self.request("POST", "/enter", {"code": code or self.code, "name": name})
        assert answer.status == 200, answer.body
        return answer.cookie

    def supervisor(self) -> str:
        """Enter by the supervisor's link."""
        return self.enter("", self.supervisor_token)

    def connected(
        self, path: str, cookie: str, origin: str | None = None, **headers: str
    ) -> ClientConnection:
        """Open a WebSocket, from the server's own page where no origin is given."""
        return connect(
            f"ws://{self.host}{path}",
            origin=Origin(f"http://{self.host}" if origin is None else origin),
            additional_headers={"cookie": cookie, **headers} if cookie else headers,
            compression=None,
            max_size=None,
            max_queue=None,
            open_timeout=PATIENCE,
            close_timeout=1.0,
            proxy=None,
        )

    def open(self, cookie: str, **headers: str) -> Browser:
        """Open the WebSocket of a room."""
        link = self.connected("/ws", cookie, **headers)
        socket = self._sockets.enter_context(link)
        return Browser(socket)

    def join(self, cookie: str, **fields: Any) -> Browser:
        """Open a WebSocket and join a room."""
        browser = self.open(cookie)
        browser.send("join", **fields)
        return browser
