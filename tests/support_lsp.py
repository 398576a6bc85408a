"""A client of the language server protocol: a real process, real pipes."""

import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from queue import Empty, Queue
from typing import Any

from tests.support_framing import framed, read_framed

PATIENCE = 30.0  # [s] on a busy machine


class Client:
    """Talks to `vrts lsp`; positions are (line, character) from 0."""

    def __init__(self, folder: Path, encodings: list[str] | None = None) -> None:
        words = [sys.executable, "-m", "vrts.cli.main", "lsp"]
        self.process = subprocess.Popen(
            words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
        )
        self.folder = folder
        self.notifications: list[dict[str, Any]] = []
        self.requests: list[dict[str, Any]] = []  # of the server
        self.errors: list[str] = []
        self._came: Queue[dict[str, Any] | None] = Queue()
        self._number = 0
        self._versions: dict[str, int] = {}
        self._threads = [
            threading.Thread(target=self._listen, daemon=True),
            threading.Thread(target=self._listen_errors, daemon=True),
        ]
        for thread in self._threads:
            thread.start()
        general = {"general": {"positionEncodings": encodings}} if encodings else {}
        able = {"inlayHint": {"refreshSupport": True}}
        self.able = self.do(
            "initialize",
            processId=None,
            rootUri=folder.as_uri(),
            capabilities={**general, "workspace": able},
        )["capabilities"]
        self.tell("initialized")

    def __enter__(self) -> "Client":
        return self

    def __exit__(self, *_: object) -> None:
        self.leave()

    def leave(self) -> int:
        """Say goodbye, or find the server gone; return its exit status."""
        if self.process.poll() is None:
            self.do("shutdown")
            self.tell("exit")
        return self.gone()

    def gone(self) -> int:
        """Close this end; return the exit status of the other."""
        assert self.process.stdin is not None
        self.process.stdin.close()
        status = self.process.wait(PATIENCE)
        for thread in self._threads:
            thread.join(PATIENCE)
        for stream in (self.process.stdout, self.process.stderr):
            assert stream is not None
            stream.close()
        return status

    # --- buffers --------------------------------------------------------------------------------

    def uri(self, name: str) -> str:
        """Return the address of a file of the folder."""
        return (self.folder / name).as_uri()

    def open(self, name: str, text: str) -> None:
        """Open a buffer, whatever the file on disk holds."""
        self._versions[name] = 1
        document = {"uri": self.uri(name), "languageId": "val2", "version": 1, "text": text}
        self.tell("textDocument/didOpen", textDocument=document)

    def change(self, name: str, text: str, *at: tuple[int, int]) -> None:
        """Replace what is between two positions, or the whole buffer."""
        self._versions[name] += 1
        change: dict[str, Any] = {"text": text}
        if at:
            first, last = at
            change["range"] = {"start": place(first), "end": place(last)}
        self.tell(
            "textDocument/didChange",
            textDocument={"uri": self.uri(name), "version": self._versions[name]},
            contentChanges=[change],
        )

    def diagnostics(self, name: str) -> list[dict[str, Any]]:
        """Return what is said about the present text of a buffer."""
        wanted = self.uri(name), self._versions[name]

        def matches(m: dict[str, Any]) -> bool:
            if m.get("method") != "textDocument/publishDiagnostics":
                return False
            return (m["params"]["uri"], m["params"].get("version")) == wanted

        for known in self.notifications:
            if matches(known):
                self.notifications.remove(known)
                return known["params"]["diagnostics"]
        found = self._next(matches)
        self.notifications.remove(found)
        return found["params"]["diagnostics"]

    # --- messages -------------------------------------------------------------------------------

    def about(self, method: str, name: str, at: tuple[int, int] | None = None, **more: Any) -> Any:
        """Ask about a buffer, or a place in it; return the result."""
        where = {"position": place(at)} if at is not None else {}
        return self.do(
            f"textDocument/{method}", textDocument={"uri": self.uri(name)}, **where, **more
        )

    def do(self, method: str, **params: Any) -> Any:
        """Send a request that has to succeed; return its result."""
        found = self.ask(method, **params)
        assert "error" not in found, found
        return found["result"]

    def ask(self, method: str, **params: Any) -> dict[str, Any]:
        """Send a request; return its response."""
        self._number += 1
        number = self._number
        self.send({"jsonrpc": "2.0", "id": number, "method": method, "params": params})

        def answers(m: dict[str, Any]) -> bool:
            return m.get("id") == number and "method" not in m

        return self._next(answers)

    def tell(self, method: str, **params: Any) -> None:
        """Send a notification."""
        self.send({"jsonrpc": "2.0", "method": method, "params": params})

    def send(self, message: object) -> None:
        """Send any message."""
        self.raw(framed(message))

    def raw(self, data: bytes) -> None:
        """Write bytes as they are."""
        assert self.process.stdin is not None
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def notified(self, method: str) -> dict[str, Any]:
        """Return the parameters of the next notification of a kind."""
        for known in self.notifications:
            if known["method"] == method:
                self.notifications.remove(known)
                return known["params"]

        def matches(m: dict[str, Any]) -> bool:
            return m.get("method") == method

        found = self._next(matches)
        if found in self.notifications:
            self.notifications.remove(found)
        return found["params"]

    def requested(self, method: str) -> None:
        """Wait for a request of the server; it is answered with nothing."""
        if not any(m["method"] == method for m in self.requests):

            def matches(m: dict[str, Any]) -> bool:
                return m.get("method") == method

            self._next(matches)
        self.requests = [m for m in self.requests if m["method"] != method]

    def _listen(self) -> None:
        stream = self.process.stdout
        assert stream is not None
        message = read_framed(stream)
        while message is not None:
            self._came.put(message)
            message = read_framed(stream)
        self._came.put(None)

    def _listen_errors(self) -> None:
        assert self.process.stderr is not None
        for line in self.process.stderr:
            self.errors.append(line.decode())

    def _next(self, wanted: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
        latest = time.monotonic() + PATIENCE
        while True:
            try:
                message = self._came.get(timeout=max(latest - time.monotonic(), 0.01))
            except Empty:
                raise AssertionError(
                    f"nothing comes; so far {self.notifications} {self.errors}"
                ) from None
            assert message is not None, f"the server is gone: {''.join(self.errors)}"
            if "method" in message and "id" in message:
                self.requests.append(message)
                self.send({"jsonrpc": "2.0", "id": message["id"], "result": None})
            elif "method" in message:
                self.notifications.append(message)
            if wanted(message):
                return message


def place(at: tuple[int, int]) -> dict[str, int]:
    """Return a position of the protocol."""
    return {"line": at[0], "character": at[1]}


def where(text: str, piece: str, number: int = 1) -> tuple[int, int]:
    """Return where a piece of a text begins the n-th time: line and character from 0."""
    at = -1
    for _ in range(number):
        at = text.index(piece, at + 1)
    return text.count("\n", 0, at), at - (text.rfind("\n", 0, at) + 1)
