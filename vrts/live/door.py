"""What leaves for a browser: WebSocket frames made once for everybody, straight to the transport.

The transport's own buffer is the queue. Reliable messages may fill it to `MOST`; who reads slower
is disconnected and may come back for what was missed. Latest-value messages are not added to a
buffer that holds `FEW` bytes: they wait in a slot, where the next one replaces them.
"""

import asyncio
import socket
import sys
from collections.abc import Callable
from typing import Any, Final, cast

from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol
from websockets.frames import Frame
from websockets.http11 import Request

from vrts.live.callers.frames import SLICE, Frames

MOST: Final = 2 * 1024 * 1024  # bytes that may wait for one client
FEW: Final = 16 * 1024
EXTENSION: Final = "vrts.door"  # where an application finds the door in its scope

_NOT_SENT = 25 if sys.platform == "linux" else 0  # TCP_NOTSENT_LOWAT, which Python 3.11 has not
_TEXT, _BINARY = 0x81, 0x82  # final frame, opcode


def text_frame(payload: bytes) -> bytes:
    """Return the WebSocket frame of a text message from the server."""
    return _head(_TEXT, len(payload)) + payload


def binary_frame(payload: bytes) -> bytes:
    """Return the WebSocket frame of a binary message from the server."""
    return _head(_BINARY, len(payload)) + payload


class Door:
    """The way to one client."""

    __slots__ = ("_protocol", "_slots", "_transport", "slow")

    def __init__(self, protocol: "DoorProtocol") -> None:
        """Take an accepted connection."""
        self._protocol = protocol
        self._transport = protocol.transport
        self._slots: dict[str, bytes] = {}
        self.slow = False  # was disconnected for reading too slowly

    @property
    def open(self) -> bool:
        """Whether anything can be sent."""
        return not (self._protocol.close_sent or self._transport.is_closing())

    def send(self, frame: bytes) -> None:
        """Send a reliable frame."""
        if not self.open:
            return
        if self._transport.get_write_buffer_size() + len(frame) > MOST:
            self.slow = True
            self._transport.abort()
        else:
            self._transport.write(frame)

    def latest(self, kind: str, frame: bytes) -> None:
        """Send a frame of which only the latest of its kind matters."""
        transport = self._transport
        if transport.get_write_buffer_size() >= FEW:
            self._slots[kind] = frame
            return
        if self._slots:
            self._slots.pop(kind, None)  # older than this one
        if self.open:
            transport.write(frame)

    def flush(self) -> None:
        """Send what waits in slots, if there is room now."""
        if self._slots and self._transport.get_write_buffer_size() < FEW:
            waiting, self._slots = self._slots, {}
            for frame in waiting.values():
                self.send(frame)

    def finish(self) -> None:
        """End the connection after what was sent."""
        self._protocol.finish()

    def abort(self) -> None:
        """End the connection at once."""
        self._transport.abort()


class DoorProtocol(WebSocketsSansIOProtocol):
    """uvicorn's own protocol, with a door for the application."""

    _came: Frames | None = None

    def handle_connect(self, event: Request) -> None:
        """Put the door into the scope before the application sees it."""
        super().handle_connect(event)
        if self.response.status_code == 101:
            extensions = cast("dict[str, Any]", self.scope.get("extensions"))
            extensions[EXTENSION] = lambda: Door(self)
            _keep_buffers_short(self.transport)

    def data_received(self, data: bytes) -> None:
        """Take frames, a few at a time, unless there are far too many."""
        for begin in range(0, len(data), SLICE):
            if self.transport.is_closing():
                return
            super().data_received(data[begin : begin + SLICE])

    def handle_text(self, event: Frame) -> None:
        """Take a text frame."""
        if self._counted():
            super().handle_text(event)

    def handle_bytes(self, event: Frame) -> None:
        """Take a binary frame."""
        if self._counted():
            super().handle_bytes(event)

    def handle_cont(self, event: Frame) -> None:
        """Take one more part of a message."""
        if self._counted():
            super().handle_cont(event)

    def handle_ping(self) -> None:
        """Answer a ping."""
        if self._counted():
            super().handle_ping()

    def handle_pong(self, event: Frame) -> None:
        """Take a pong."""
        if self._counted():
            super().handle_pong(event)

    def _counted(self) -> bool:
        """Count a frame; return whether it may be, else the connection ends."""
        if self.transport.is_closing():
            return False
        self._came = self._came or Frames()
        if self._came.take():
            return True
        self.transport.abort()
        return False

    def finish(self) -> None:
        """Say that the server has no more, and close."""
        if not (self.close_sent or self.transport.is_closing()):
            self.conn.send_close(1008)
            self.transport.write(b"".join(self.conn.data_to_send()))
            self.close_sent = True
            self.close_timer = self.loop.call_later(self.close_timeout, self.transport.close)


def door_of(scope: Any) -> Door:
    """Return the door of an accepted connection."""
    make = cast("Callable[[], Door]", scope["extensions"][EXTENSION])
    return make()


def _head(first: int, length: int) -> bytes:
    if length < 126:
        return bytes((first, length))
    if length < 65_536:
        return bytes((first, 126)) + length.to_bytes(2, "big")
    return bytes((first, 127)) + length.to_bytes(8, "big")


def _keep_buffers_short(transport: asyncio.Transport) -> None:
    """Have the system hold back little that is not sent yet, so that poses do not grow old."""
    found = transport.get_extra_info("socket")
    if found is not None and found.family in (socket.AF_INET, socket.AF_INET6) and _NOT_SENT:
        found.setsockopt(socket.IPPROTO_TCP, _NOT_SENT, FEW)
