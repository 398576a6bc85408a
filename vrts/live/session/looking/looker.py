"""Blocks of the past, and states of now, made in a child forked from the session, one at a time."""

import base64
from collections import deque
from collections.abc import Callable
from typing import Final

from vrts.live.session.channel.messages import BLOCK, AskBlock, AskState, Left, Looked
from vrts.live.session.live_session import Session
from vrts.live.session.looking.block import block_bytes
from vrts.live.session.looking.state import state_bytes
from vrts.live.session.marks.checker import NICENESS
from vrts.marking.supervise.aside import Aside
from vrts.marking.supervise.limits import Limits

MOST_WAITING: Final = 64  # questions
LIMITS: Final = Limits(
    cpu_s=30, wall_s=60.0, memory=500_000_000, answer=8_000_000, niceness=NICENESS
)
FORGOTTEN: Final = "this part of the past is forgotten"
TO_COME: Final = "this has not happened yet"
FAILED: Final = "vrts cannot show this part of the past"
BUSY: Final = "too many people look at the past at once"
NO_STATE: Final = "the room's session did not give its state"


class Looker:
    """Answers questions for blocks, later; the session only pays for the forks."""

    def __init__(self, session: Session, send: Callable[[Looked | Left], None]) -> None:
        """Look at the past of a session; `send` takes the answers."""
        self._session = session
        self._send = send
        self._aside = Aside(LIMITS)
        self._waiting: deque[AskBlock | AskState] = deque()
        self._asked: tuple[AskBlock | AskState, float] | None = (
            None  # and how far the session had come
        )

    def close(self) -> None:
        """End with the session."""
        self._aside.close()

    @property
    def busy(self) -> bool:
        """Whether somebody waits for an answer."""
        return self._aside.busy or bool(self._waiting)

    def ask(self, order: AskBlock | AskState) -> None:
        """Take a question."""
        if isinstance(order, AskState):
            if len(self._waiting) >= MOST_WAITING:
                self._send(Left(order.ref, why=BUSY))
            else:
                self._waiting.append(order)
            return
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
        self._take()
        if self._aside.busy or not self._waiting:
            return
        order = self._waiting.popleft()
        growing = self._session.growing
        self._asked = (order, growing.time_s)
        growing.drop_run()
        self._aside.begin(self._work)
        self._take()

    def _take(self) -> None:
        done = self._aside.take()
        if done is not None:
            self._answered(done.answer)

    def _work(self) -> bytes:
        """Return the block or the state that is asked for; no bytes: it is forgotten."""
        assert self._asked is not None
        order, growing = self._asked[0], self._session.growing
        if isinstance(order, AskState):
            return state_bytes(self._session)
        number = order.number
        reaches_s = growing.reaches_s
        run = growing.run_of(max(number * BLOCK, reaches_s), (number + 1) * BLOCK)
        return b"" if run is None else block_bytes(run, number, reaches_s)

    def _answered(self, data: bytes | None) -> None:
        assert self._asked is not None
        order, time_s = self._asked
        self._asked = None
        if isinstance(order, AskState):
            encoded = base64.b64encode(data or b"").decode()
            self._send(Left(order.ref, encoded, why="" if data else NO_STATE))
            return
        if not data:
            self._send(Looked(order.ref, why=FAILED if data is None else FORGOTTEN))
            return
        whole = time_s >= (order.number + 1) * BLOCK
        self._send(Looked(order.ref, base64.b64encode(data).decode(), whole))
