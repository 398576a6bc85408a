"""A live server with an operator in every room whose program moves the arm for ever."""

import time
from pathlib import Path
from types import TracebackType
from typing import NamedTuple

import psutil

from tests.bench.live_socket import LiveSocket, clock_offset
from tests.support_live import LiveServer

LOOP = ".PROGRAM loop()\n10 DRIVE 1,30,100\n DRIVE 1,-30,100\n GOTO 10\n.END\n"


class Operator(NamedTuple):
    """Who has the control right in a room."""

    socket: LiveSocket
    lease: str
    room: str
    epoch_s: float  # clock at session time 0


class Stage:
    """A server, its rooms and operators."""

    def __init__(
        self, folder: Path, rooms: int = 1, *, moving: bool = True, module: str = "vrts.cli.main"
    ) -> None:
        names = folder / "rooms.txt"
        names.write_text("".join(f"Room {n + 1}\n" for n in range(rooms)))
        kind = type("Server", (LiveServer,), {"module": module})
        self.server = kind(folder / "live", "--rooms", str(names), measured=True)
        self.process = psutil.Process(self.server.process.pid)
        self._offset = clock_offset()
        self.operators: list[Operator] = []
        try:
            self._begin(rooms, moving=moving)
        except BaseException:
            self.server.kill()
            raise

    def _begin(self, rooms: int, *, moving: bool) -> None:
        first = self._enter("Operator 1", "")
        _, snapshot = first.wait("snapshot")
        ids = [str(room["id"]) for room in snapshot["rooms"]]
        first.close()
        assert len(ids) == rooms
        self.operators += [self._operator(n, room) for n, room in enumerate(ids)]
        if moving:
            for operator in self.operators:
                operator.socket.command(operator.lease, "upload", name="loop.v2", text=LOOP)
                operator.socket.command(operator.lease, "line", line="EXECUTE loop,-1")
        for operator in self.operators:
            operator.socket.send("rate", rate=1)

    def __enter__(self) -> "Stage":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        for operator in self.operators:
            operator.socket.close()
        self.server.__exit__(kind, error, trace)

    def viewers(self, count: int) -> list[tuple[str, str, float]]:
        """Return who joins: cookies of few accounts, rooms by turns."""
        cookies = [self.server.enter(f"Viewer {n}") for n in range((count + 7) // 8)]
        rooms = self.operators
        return [
            (cookies[n // 8], rooms[n % len(rooms)].room, rooms[n % len(rooms)].epoch_s)
            for n in range(count)
        ]

    def _enter(self, name: str, room: str) -> LiveSocket:
        return LiveSocket(self.server.port, self.server.enter(name), self._offset, room=room)

    def _operator(self, number: int, room: str) -> Operator:
        link = self._enter(f"Operator {number + 1}", room)
        _, snapshot = link.wait("snapshot")
        if snapshot["state"] is None:
            link.wait("state")
        return self._in_control(link, room)

    def _in_control(self, link: LiveSocket, room: str) -> Operator:
        lease = link.take_control()
        return Operator(link, lease, room, _epoch(link, lease))


def _epoch(link: LiveSocket, lease: str) -> float:
    """Return what the clock showed at session time 0, or up to 0.3 ms less.

    A command is stamped after it was sent, so its session time and the time at which it was sent
    are at most so far apart; the closest pair of many is taken. Delays come out too long, if wrong.
    """
    best = 0.0
    for _ in range(20):
        sent_s = time.monotonic()
        number = link.command(lease, "let_go")
        _, message = link.wait("result", of=number)
        best = max(best, sent_s - float(message["result"]["at_s"]))
        time.sleep(0.02)
    return best
