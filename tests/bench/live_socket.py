"""WebSockets for benchmarks, by hand: little work for each frame, and the kernel's own stamps.

A stamp tells when the data reached the socket, so what the reader itself is late by does not count.
"""

import json
import socket
import struct
import time
from collections import deque
from typing import Any, Final, NamedTuple

STAMPED: Final = 35  # SO_TIMESTAMPNS, which Python has no name for [asm-generic/socket.h]
_PING: Final = 9
_STAMP = struct.Struct("qq")
_TIME = struct.Struct("<d")
AT: Final = 8  # where a pose frame has its session time
_REQUEST = (
    "GET /ws HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nOrigin: http://127.0.0.1:{port}\r\n"
    "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
    "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nCookie: {cookie}\r\n\r\n"
)


class Came(NamedTuple):
    """What came by a socket."""

    stamp_s: float  # when the kernel had it, by `time.monotonic`
    opcode: int  # 1: text, 2: binary
    payload: bytes


def clock_offset() -> float:
    """Return what to add to the kernel's time to have that of `time.monotonic` [s]."""
    least = min(
        (after - before, 0.5 * (before + after) - kernel)
        for before, kernel, after in (
            (time.monotonic(), time.time(), time.monotonic()) for _ in range(100)
        )
    )
    return least[1]


class LiveSocket:
    """A connection that has joined."""

    def __init__(self, port: int, cookie: str, offset: float, **join: Any) -> None:
        self._offset = offset
        self._data = bytearray()
        self._texts: deque[Came] = deque()  # taken, but not waited for yet
        self.number = 0
        link = self.socket = socket.create_connection(("127.0.0.1", port))
        link.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        link.setsockopt(socket.SOL_SOCKET, STAMPED, 1)
        link.settimeout(30.0)
        link.sendall(_REQUEST.format(port=port, cookie=cookie).encode())
        while b"\r\n\r\n" not in self._data:
            data = link.recv(1 << 16)
            assert data, "the server has closed the connection"
            self._data += data
        end = self._data.index(b"\r\n\r\n") + 4
        assert self._data.startswith(b"HTTP/1.1 101"), bytes(self._data)
        del self._data[:end]
        self.send("join", **join)

    def fileno(self) -> int:
        return self.socket.fileno()

    def close(self) -> None:
        self.socket.close()

    def send(self, type_: str, **fields: Any) -> None:
        """Send a message; the mask is zero, which is allowed."""
        payload = json.dumps({"type": type_, **fields}).encode()
        size = len(payload)
        assert size < 1 << 16
        head = bytes((0x81, 0x80 | size)) if size < 126 else b"\x81\xfe" + size.to_bytes(2, "big")
        self.socket.sendall(head + bytes(4) + payload)

    def command(self, lease: str, action: str, **fields: Any) -> int:
        """Send a command; return its number."""
        self.number += 1
        self.send("command", lease=lease, number=self.number, action={"type": action, **fields})
        return self.number

    def take(self) -> list[Came]:
        """Take what there is; wait for it if there is nothing."""
        data, extra, _, _ = self.socket.recvmsg(1 << 16, 64)
        if not data:
            raise ConnectionError("the server has closed the connection")
        if extra:
            seconds, nanoseconds = _STAMP.unpack_from(extra[0][2])
            stamp_s = seconds + 1e-9 * nanoseconds + self._offset
        else:  # the kernel has only begun to stamp
            stamp_s = time.monotonic()
        buffer = self._data
        buffer += data
        found: list[Came] = []
        at = 0
        while (frame := _frame(buffer, at)) is not None:
            opcode, begin, end = frame
            payload = bytes(buffer[begin:end])
            at = end
            if opcode == _PING:
                self.socket.sendall(bytes((0x8A, 0x80 | len(payload), 0, 0, 0, 0)) + payload)
            else:
                found.append(Came(stamp_s, opcode, payload))
        del buffer[:at]
        return found

    def wait(self, type_: str, **fields: Any) -> tuple[float, dict[str, Any]]:
        """Return the next message of a type with these fields, and its stamp."""
        while True:
            while self._texts:
                came = self._texts.popleft()
                message: dict[str, Any] = json.loads(came.payload)
                if message["type"] == type_ and fields.items() <= message.items():
                    return came.stamp_s, message
            self._texts += (came for came in self.take() if came.opcode == 1)

    def take_control(self) -> str:
        """Ask for the control right; return the lease."""
        self.send("request_control")
        while True:
            _, control = self.wait("control")
            if control["lease"]:
                return str(control["lease"])


def _frame(buffer: bytearray, at: int) -> tuple[int, int, int] | None:
    """Return opcode, begin and end of the payload of the frame there, None if it is not whole."""
    if len(buffer) - at < 2:
        return None
    length, begin = buffer[at + 1], at + 2
    if length == 126:
        length, begin = int.from_bytes(buffer[at + 2 : at + 4], "big"), at + 4
    elif length == 127:
        length, begin = int.from_bytes(buffer[at + 2 : at + 10], "big"), at + 10
    if len(buffer) < begin + length:
        return None
    return buffer[at] & 0x0F, begin, begin + length


def session_time(payload: bytes) -> float:
    """Return the session time that a pose frame tells [s]."""
    (time_s,) = _TIME.unpack_from(payload, AT)
    return float(time_s)
