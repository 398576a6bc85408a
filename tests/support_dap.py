"""A client of the debug adapter protocol: a real process, real pipes."""

import threading
from collections.abc import Sequence
from pathlib import Path
from queue import Empty, Queue
from typing import Any

from tests.support_commands import Begun
from tests.support_framing import framed, read_framed

PATIENCE = 60.0  # [s] on a busy machine


class Client:
    """Talks to `vrts dap`."""

    def __init__(self) -> None:
        self.process = Begun("dap", talks=True)
        self.events: list[dict[str, Any]] = []
        self._came: Queue[dict[str, Any] | None] = Queue()
        self._number = 0
        self._listener = threading.Thread(target=self._listen, daemon=True)
        self._listener.start()

    def __enter__(self) -> "Client":
        return self

    def __exit__(self, *_: object) -> None:
        self.leave()

    def leave(self) -> int:
        """Close this end; return the exit status of the other."""
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.stdin.close()
        status = self.process.wait(PATIENCE)
        self._listener.join(PATIENCE)
        self.process.stdout.close()
        return status

    def _listen(self) -> None:
        stream = self.process.stdout
        assert stream is not None
        message = read_framed(stream)
        while message is not None:
            self._came.put(message)
            message = read_framed(stream)
        self._came.put(None)

    def raw(self, data: bytes) -> None:
        """Write bytes as they are."""
        assert self.process.stdin is not None
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def ask(self, command: str, **arguments: Any) -> dict[str, Any]:
        """Send a request; return its response."""
        return self._next("request_seq", self.post(command, **arguments))

    def post(self, command: str, **arguments: Any) -> int:
        """Send a request and wait for nothing; return its number."""
        self._number += 1
        message = {
            "seq": self._number,
            "type": "request",
            "command": command,
            "arguments": arguments,
        }
        self.raw(framed(message))
        return self._number

    def do(self, command: str, **arguments: Any) -> dict[str, Any]:
        """Send a request that has to succeed; return the body of its response."""
        found = self.ask(command, **arguments)
        assert found["success"], found
        return found.get("body", {})

    def event(self, name: str) -> dict[str, Any]:
        """Return the body of the next event of a kind that nobody has taken yet."""
        for known in self.events:
            if known["event"] == name:
                self.events.remove(known)
                return known["body"]
        found = self._next("event", name)
        self.events.remove(found)
        return found["body"]

    def go(self, command: str, **arguments: Any) -> dict[str, Any]:
        """Send a request that moves it; return the body of the event that it has stopped."""
        self.do(command, **{"threadId": 1, **arguments})
        return self.event("stopped")

    def launch(self, program: Path, lines: Sequence[int] = (), **more: Any) -> dict[str, Any]:
        """Begin as editors do; return the body of the first stop."""
        self.do("initialize", adapterID="vrts", linesStartAt1=True)
        self.do("launch", program=str(program), **more)
        self.event("initialized")
        if lines:
            self.lines(program, *lines)
        self.do("configurationDone")
        return self.event("stopped")

    def lines(self, program: Path, *lines: int, **more: Any) -> list[dict[str, Any]]:
        """Set breakpoints, all with the same options."""
        wishes = [{"line": line, **more} for line in lines]
        body = self.do("setBreakpoints", source={"path": str(program)}, breakpoints=wishes)
        return body["breakpoints"]

    def line(self, thread: int = 1) -> int:
        """Return the line at which a program stands."""
        return self.do("stackTrace", threadId=thread)["stackFrames"][0]["line"]

    def value(self, expression: str, context: str = "watch") -> str:
        """Return the value of an expression."""
        return self.do("evaluate", expression=expression, context=context)["result"]

    def in_frame(self, frame: int, expression: str) -> str:
        """Return the value that an expression has for a program being executed."""
        return self.do("evaluate", expression=expression, frameId=frame, context="hover")["result"]

    def shown(self) -> dict[str, dict[str, dict[str, Any]]]:
        """Return everything that the scopes show."""
        frame = self.do("stackTrace", threadId=1)["stackFrames"][0]["id"]
        return {
            scope["name"]: {
                item["name"]: item
                for item in self.do("variables", variablesReference=scope["variablesReference"])[
                    "variables"
                ]
            }
            for scope in self.do("scopes", frameId=frame)["scopes"]
            if scope["variablesReference"]
        }

    def output(self) -> str:
        """Return what the program has written and the client has not looked at."""
        self.do("threads")  # everything before it has come
        found = [m for m in self.events if m["event"] == "output"]
        self.events = [m for m in self.events if m["event"] != "output"]
        return "".join(m["body"]["output"] for m in found if m["body"]["category"] == "stdout")

    def _next(self, field: str, value: object) -> dict[str, Any]:
        """Return the next message of which a field has a value; keep the events before it."""
        while True:
            try:
                message = self._came.get(timeout=PATIENCE)
            except Empty:
                raise AssertionError(f"nothing comes; so far {self.events}") from None
            assert message is not None, "the adapter is gone"
            if message["type"] == "event":
                self.events.append(message)
            if message.get(field) == value:
                return message
