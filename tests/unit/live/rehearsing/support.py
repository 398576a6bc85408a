"""Rehearsals for tests: questions to a process's own answers, and a browser's socket."""

import json
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection

from tests.places import ROOT
from tests.support_live import PATIENCE, Json, LiveServer
from vrts.engine.run import Run
from vrts.live.rehearsing.asked import AskBlock, At, Begin, Go, Rehearse, What
from vrts.live.rehearsing.child import Child
from vrts.live.rehearsing.told import Block, Ready, Refused, Stopped
from vrts.live.session.channel.messages import Start

TASK = ROOT / "examples" / "01-cans-on-bases" / "task.toml"
HITS = (TASK.parent / "submissions" / "hits-base.v2").read_text("utf-8")
ENDLESS = """.PROGRAM main()
  i = 0
  10 i = i + 1
  DRIVE 1, 20 + i / 10, 3
  DRIVE 1, -20 - i / 10, 3
  GOTO 10
.END
"""
CALLS = """.PROGRAM main()
  total = 0
  CALL add(3)
  TYPE "total ", total
  CALL add(4)
  TYPE "total ", total
.END
.PROGRAM add(n)
  twice = 2 * n
  total = total + twice
.END
"""


class Questions:
    """A rehearsal in this process."""

    def __init__(self, task: Path | None = None, scene_sha256: str = "") -> None:
        """Rehearse for a task; None: a robot alone."""
        path = "" if task is None else str(task)
        self._where = Start(1, "", task=path, scene_sha256=scene_sha256)
        self._child = Child()
        self._of = 0

    def rehearse(self, text: str, *breakpoints: int, state: str = "") -> Ready | Refused:
        self._of += 1
        order = Rehearse(self._of, text, breakpoints=breakpoints)
        told = self._child.answer(Begin(self._where, order, state))
        assert isinstance(told, Ready | Refused)
        return told

    def ready(self, text: str, *breakpoints: int) -> Ready:
        told = self.rehearse(text, *breakpoints)
        assert isinstance(told, Ready), told
        return told

    @property
    def run(self) -> Run:
        """The run that is looked into."""
        assert self._child.rehearsal is not None
        return self._child.rehearsal.run

    def go(self, what: What) -> Stopped:
        told = self._child.answer(Go(self._of, what))
        assert isinstance(told, Stopped)
        return told

    def at(self, time_s: float) -> Stopped:
        told = self._child.answer(At(self._of, time_s))
        assert isinstance(told, Stopped)
        return told

    def block(self, number: int) -> Block:
        told = self._child.answer(AskBlock(self._of, number))
        assert isinstance(told, Block)
        return told


def link(
    server: LiveServer, cookie: str, room: str, origin: str = ""
) -> AbstractContextManager[ClientConnection]:
    """Open the WebSocket of a rehearsal."""
    return server.connected(f"/rehearse?room={room}", cookie, origin or None)


class Page:
    """A browser that rehearses."""

    def __init__(self, socket: ClientConnection) -> None:
        """Take an open socket."""
        self.socket = socket
        self._of = 0

    def send(self, type_: str, **fields: Any) -> None:
        self.socket.send(json.dumps({"type": type_, "id": self._of, **fields}))

    def ask(self, type_: str, **fields: Any) -> Json:
        """Send a message; return the next one that comes."""
        self.send(type_, **fields)
        return self.next()

    def rehearse(self, text: str, **fields: Any) -> Json:
        """Have a text rehearsed; return the answer."""
        self.order(text, **fields)
        return self.next()

    def order(self, text: str, **fields: Any) -> None:
        """Have a text rehearsed, and do not wait."""
        self._of += 1
        self.send("rehearse", text=text, **fields)

    def next(self) -> Json:
        data = self.socket.recv(timeout=4 * PATIENCE)
        assert isinstance(data, str)
        message: Json = json.loads(data)
        return message

    def closed(self) -> str:
        """Read to the end; return the code with which the server ended it."""
        code = ""
        try:
            while True:
                code = self.next().get("code", "")
        except ConnectionClosed:
            return code


def processes(server: LiveServer) -> list[int]:
    """Return the numbers of the processes of rehearsals, those that began first before others.

    The one that waits for the next rehearsal began after those that are in use.
    """
    found: list[tuple[int, int]] = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            fields = (folder / "stat").read_text().rsplit(")", 1)[1].split()
            words = (folder / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue  # gone meanwhile
        if int(fields[1]) == server.process.pid and b"vrts.live.rehearsing.child" in words:
            found.append((int(fields[19]), int(folder.name)))
    return [pid for _, pid in sorted(found)]
