"""HTTP connections that say nothing, or never end, are closed: they take the place of others.

An honest browser sends a request at once. Who takes longer than `HEAD_S` for the head of one is
closed, and so is who has to wait for an answer for longer than `ANSWER_S`, or takes nothing of one
for `STALL_S`: a long answer may take as long as a slow network needs. Where there are too many
connections, the one goes that has been waiting for a request for longest; where all are answered,
the one that has taken nothing for longest.
"""

import asyncio
from collections import OrderedDict
from typing import Any, ClassVar, Final

from uvicorn.protocols.http.auto import AutoHTTPProtocol

HEAD_S: Final = 15.0  # until the whole head of a request must be there
ANSWER_S: Final = 900.0  # until the body of a request has come and its answer was made
STALL_S: Final = 60.0  # without anything of an answer being taken
LOOK_S: Final = 5.0  # how often that is looked at
LONGEST_HEAD: Final = 64 * 1024  # bytes
LONGEST_REST: Final = 2_000_000  # bytes of a body that is refused already
MOST: Final = 4000  # connections without a WebSocket


class PatientProtocol(AutoHTTPProtocol):
    """uvicorn's own protocol, with an end to patience."""

    _all: ClassVar["OrderedDict[PatientProtocol, None]"] = OrderedDict()  # last head last
    most: ClassVar[int] = MOST  # fewer where the process may have few files open
    _transport: asyncio.Transport
    _since = 0.0  # when it began to wait for the head, or the answer began [s]
    _answered = 0.0  # when it was last seen to be answered [s]
    _left: int = 0  # bytes of answers that were still to be sent when that was last looked at
    _moved = 0.0  # when that was last seen to change [s]
    _bytes = 0  # that came since the last head
    _timer: asyncio.TimerHandle | None = None

    def connection_made(self, transport: Any) -> None:
        """Begin to wait for a request."""
        super().connection_made(transport)
        self._transport = transport
        self._since = asyncio.get_running_loop().time()
        self._all[self] = None
        if len(self._all) > min(MOST, self.most):
            gives_way = next((one for one in self._all if not one._answers), None)
            if gives_way is None:
                sent = (one for one in self._all if one._to_send)
                gives_way = min(sent, key=lambda one: max(one._since, one._moved), default=None)
            if gives_way is not None:
                gives_way._end()
        self._look_later()

    def connection_lost(self, exc: Exception | None) -> None:
        """Wait no longer."""
        self._forget()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Take a part of a request, unless its head is too long."""
        before = self._cycle
        super().data_received(data)
        if self._cycle is not before:  # a whole head came
            self._bytes = 0
            self._since = asyncio.get_running_loop().time()
            if self in self._all:
                self._all.move_to_end(self)
        elif not self._answers:
            self._bytes += len(data)
            rest = before is not None and before.more_body
            if self._bytes > (LONGEST_REST if rest else LONGEST_HEAD):
                self._end()

    def handle_websocket_upgrade(self, *event: Any) -> None:
        """Hand the connection over."""
        self._forget()
        upgrade: Any = super()
        upgrade.handle_websocket_upgrade(*event)

    @property
    def _cycle(self) -> Any:
        """The last request; None: there was none."""
        return getattr(self, "cycle", None)

    def timeout_keep_alive_handler(self) -> None:
        """Close a connection on which no further request came, when its answer was taken."""
        if self._to_send:
            loop = asyncio.get_running_loop()
            later = loop.call_later(LOOK_S, self.timeout_keep_alive_handler)
            self.timeout_keep_alive_task = later
            return
        closing: Any = super()
        closing.timeout_keep_alive_handler()

    @property
    def _to_send(self) -> int:
        """Bytes of answers that wait for the network."""
        return self._transport.get_write_buffer_size()

    @property
    def _made(self) -> bool:
        """Whether all of the last answer was made, if there was a request."""
        cycle = self._cycle
        return cycle is None or bool(cycle.response_complete)

    @property
    def _answers(self) -> bool:
        """Whether a request is being answered."""
        return not self._made or self._to_send > 0

    def _look_later(self) -> None:
        self._timer = asyncio.get_running_loop().call_later(LOOK_S, self._look)

    def _look(self) -> None:
        """Close the connection if it takes too long."""
        now, left = asyncio.get_running_loop().time(), self._to_send
        if left != self._left:
            self._left, self._moved = left, now
        if self._answers:
            self._answered = now
            late = now - max(self._since, self._moved) > (STALL_S if left else ANSWER_S)
        else:
            late = now - max(self._since, self._answered) > HEAD_S
        if late:
            self._end()
        else:
            self._look_later()

    def _forget(self) -> None:
        self._all.pop(self, None)
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _end(self) -> None:
        self._forget()
        self._transport.abort()
