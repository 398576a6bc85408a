"""An editor reduced to its messages."""

import json
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection

from tests.support_live import PATIENCE, Json, LiveServer


def link(server: LiveServer, cookie: str, origin: str = "") -> AbstractContextManager[Any]:
    """Open the WebSocket of an editor."""
    return server.connected("/lsp", cookie, origin or None)


class Editor:
    """A WebSocket, and what came by it; positions are (line, character) from 0."""

    def __init__(self, socket: ClientConnection, text: str | None = None) -> None:
        """Take an open socket; open a text as soon as the help is there."""
        self.socket = socket
        self.raw: list[str] = []
        self._last = 0
        self.until("ready")
        if text is not None:
            self.version = 1
            self.send("textDocument/didOpen", version=1, text=text)

    def send(self, method: str, **fields: Any) -> None:
        self.socket.send(json.dumps({"method": method, **fields}))

    def change(self, text: str) -> None:
        self.version += 1
        self.send("textDocument/didChange", version=self.version, text=text)

    def ask(self, method: str, **fields: Any) -> Any:
        """Return the answer to a question."""
        self._last += 1
        self.send(f"textDocument/{method}", id=self._last, **fields)
        return self._next(lambda m: m.get("id") == self._last)["result"]

    def at(self, method: str, line: int, character: int) -> Any:
        """Ask about a place."""
        return self.ask(method, position={"line": line, "character": character})

    def findings(self) -> list[Json]:
        """Return what is wrong with the text of now."""

        def fits(message: Json) -> bool:
            kind, number = message.get("method"), message.get("version")
            return kind == "textDocument/publishDiagnostics" and number == self.version

        return self._next(fits)["diagnostics"]

    def until(self, method: str) -> Json:
        return self._next(lambda message: message.get("method") == method)

    def closed(self) -> str:
        """Read to the end; return the code with which the server ended it."""
        code = ""
        try:
            while True:
                code = self._next(lambda _: True).get("code", "")
        except ConnectionClosed:
            return code

    def _next(self, fits: Callable[[Json], bool]) -> Json:
        while True:
            data = self.socket.recv(timeout=PATIENCE)
            assert isinstance(data, str)
            self.raw.append(data)
            message: Json = json.loads(data)
            if fits(message):
                return message


def helpers(server: LiveServer) -> list[int]:
    """Return the process numbers of the language servers of a server."""
    found: list[int] = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            parent = int((folder / "stat").read_text().rsplit(")", 1)[1].split()[1])
            words = (folder / "cmdline").read_bytes()
        except OSError:
            continue  # gone meanwhile
        if parent == server.process.pid and b"--no-runs" in words:
            found.append(int(folder.name))
    return found


def gone(pid: int) -> bool:
    """Return whether a process has ended, whoever has to be told."""
    try:
        return (Path("/proc") / str(pid) / "stat").read_text().rsplit(")", 1)[1].split()[0] == "Z"
    except OSError:
        return True
