"""Viewers for the benchmark of the live server: many connections, little work for each frame.

`python -m tests.bench.live_viewers PORT VIEWERS SECONDS COOKIE...` prints one JSON object.
"""

import asyncio
import json
import struct
import sys
import time
from typing import cast

import uvloop

_TIME = struct.Struct("<d")
_AT = 8  # where a pose frame has its time

REQUEST = (
    "GET /ws HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nOrigin: http://127.0.0.1:{port}\r\n"
    "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
    "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nCookie: {cookie}\r\n\r\n"
)


def masked(text: str) -> bytes:
    """Return a client's frame; the mask is zero, which is allowed."""
    payload = text.encode()
    assert len(payload) < 126
    return bytes((0x81, 0x80 | len(payload), 0, 0, 0, 0)) + payload


class Viewer(asyncio.Protocol):
    """One connection."""

    def __init__(self, port: int, cookie: str, delays: list[float]) -> None:
        self._request = REQUEST.format(port=port, cookie=cookie).encode()
        self._delays = delays
        self._data = bytearray()
        self._open = False
        self.measuring = False
        self.count = 0

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self._transport = cast("asyncio.Transport", transport)  # uvloop has its own
        self._transport.write(self._request)

    def data_received(self, data: bytes) -> None:
        now = time.monotonic()
        buffer = self._data
        buffer += data
        if not self._open:
            end = buffer.find(b"\r\n\r\n")
            if end < 0:
                return
            assert buffer.startswith(b"HTTP/1.1 101"), bytes(buffer)
            del buffer[: end + 4]
            self._open = True
            self._transport.write(masked('{"type":"join"}'))
        at = 0
        while len(buffer) - at >= 2:
            length, head = buffer[at + 1], 2
            if length == 126:
                if len(buffer) - at < 4:
                    break
                length, head = int.from_bytes(buffer[at + 2 : at + 4], "big"), 4
            elif length == 127:
                if len(buffer) - at < 10:
                    break
                length, head = int.from_bytes(buffer[at + 2 : at + 10], "big"), 10
            if len(buffer) - at < head + length:
                break
            if buffer[at] == 0x82 and self.measuring:
                (sent,) = _TIME.unpack_from(buffer, at + head + _AT)
                self._delays.append(now - sent)
                self.count += 1
            at += head + length
        del buffer[:at]


async def main(port: int, viewers: int, seconds: float, cookies: list[str]) -> None:
    """Connect, let it settle, measure."""
    loop = asyncio.get_running_loop()
    delays: list[float] = []
    connected: list[Viewer] = []
    for n in range(viewers):
        cookie = cookies[n % len(cookies)]
        _, viewer = await loop.create_connection(
            lambda cookie=cookie: Viewer(port, cookie, delays), "127.0.0.1", port
        )
        connected.append(viewer)
    await asyncio.sleep(5.0)
    print("measuring", flush=True)
    began = time.monotonic()
    for viewer in connected:
        viewer.measuring = True
    await asyncio.sleep(seconds)
    for viewer in connected:
        viewer.measuring = False
    passed = time.monotonic() - began
    least = min(delays)
    delays = sorted(delay - least for delay in delays)
    rates = [viewer.count / passed for viewer in connected]
    found = {
        "fps": sum(rates) / viewers,
        "slowest_fps": min(rates),
        "p50_ms": 1e3 * delays[len(delays) // 2],
        "p95_ms": 1e3 * delays[int(0.95 * len(delays))],
        "p99_ms": 1e3 * delays[int(0.99 * len(delays))],
        "generator": time.process_time(),
    }
    print(json.dumps(found), flush=True)


if __name__ == "__main__":
    uvloop.run(main(int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3]), sys.argv[4:]))
