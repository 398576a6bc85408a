"""Blocks of the past made in a child forked from the session, one at a time."""

import base64
import os
import tempfile
from collections import deque
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Final

from vrts.live.session.channel.messages import BLOCK, AskBlock, Looked
from vrts.live.session.live_session import Session
from vrts.live.session.looking.block import block_bytes
from vrts.live.session.marks.checker import FORKS, NICENESS
from vrts.marking.supervise.forked import ForkedProcess
from vrts.marking.supervise.limits import Limits

MOST_WAITING: Final = 64  # questions
LIMITS: Final = Limits(cpu_s=30, wall_s=60.0, memory=500_000_000, answer=8_000_000)
FORGOTTEN: Final = "this part of the past is forgotten"
TO_COME: Final = "this has not happened yet"
FAILED: Final = "this part of the past could not be worked out"
BUSY: Final = "too many look at the past at once"


class Looker:
    """Answers questions for blocks, later; the session only pays for the forks."""

    def __init__(self, session: Session, send: Callable[[Looked], None]) -> None:
        """Look at the past of a session; `send` takes the answers."""
        self._session = session
        self._send = send
        self._folder = tempfile.TemporaryDirectory()
        self._waiting: deque[AskBlock] = deque()
        self._asked: tuple[AskBlock, float] | None = None  # and how far the session had come
        self._child: ForkedProcess | None = None

    def __enter__(self) -> "Looker":
        """Begin."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        problem: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """End with the session."""
        if self._child is not None:
            self._child.kill()
            while not self._child.ended():
                pass
        self._folder.cleanup()

    def ask(self, order: AskBlock) -> None:
        """Take a question."""
        growing = self._session.growing
        begin_s, end_s = order.number * BLOCK, (order.number + 1) * BLOCK
        if begin_s > growing.time_s:
            self._send(Looked(order.ref, why=TO_COME))
        elif end_s <= growing.reaches_s:
            self._send(Looked(order.ref, why=FORGOTTEN))
        elif len(self._waiting) >= MOST_WAITING:
            self._send(Looked(order.ref, why=BUSY))
        else:
            self._waiting.append(order)

    def beat(self) -> None:
        """Pass the answer on that has come, and begin with the next question."""
        if self._child is not None:
            if not self._child.ended():
                return
            self._answered(self._child.answer)
            self._child = None
        if not self._waiting:
            return
        order = self._waiting.popleft()
        growing = self._session.growing
        self._asked = (order, growing.time_s)
        if FORKS:
            growing.drop_run()
            self._child = ForkedProcess(self._work_aside, Path(self._folder.name), LIMITS)
        else:
            self._answered(self._work())

    def _work_aside(self) -> bytes:
        os.nice(NICENESS)  # frames come first
        return self._work()

    def _work(self) -> bytes:
        """Return the block that is asked for; no bytes: it is forgotten."""
        assert self._asked is not None
        number, growing = self._asked[0].number, self._session.growing
        reaches_s = growing.reaches_s
        run = growing.run_of(max(number * BLOCK, reaches_s), (number + 1) * BLOCK)
        return b"" if run is None else block_bytes(run, number, reaches_s)

    def _answered(self, data: bytes | None) -> None:
        assert self._asked is not None
        order, time_s = self._asked
        self._asked = None
        if not data:
            self._send(Looked(order.ref, why=FAILED if data is None else FORGOTTEN))
            return
        whole = time_s >= (order.number + 1) * BLOCK
        self._send(Looked(order.ref, base64.b64encode(data).decode(), whole))
