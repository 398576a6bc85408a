"""Messages from a stream of bytes, with limits, and to one; what is broken there is told."""

import asyncio
import re
from contextlib import suppress
from typing import BinaryIO, NamedTuple

MOST = 64_000_000  # bytes of a message
MOST_HEADER = 65_536  # bytes of a line
_LENGTH = re.compile(rb"Content-Length:[ \t]*(.*?)[ \t]*\r?\n?\Z", re.IGNORECASE | re.DOTALL)


class Broken(NamedTuple):
    """Bytes that are no message."""

    why: str


class Messages:
    """The messages of a client, one after the other.

    Where a header is broken nothing tells how long its message is. The next header is found by its
    words, also where they stand behind that message: JSON cannot hold them at the end of a line.
    """

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream
        self._lost = False  # between a broken header and the next one

    def next(self) -> bytes | Broken | None:
        """Return the next message; None at the end, also where that cuts a message off."""
        found: bytes | None = None  # what the header says of the length
        is_begun = False
        while line := self._stream.readline(MOST_HEADER):
            match = _LENGTH.search(line)
            if match is not None:
                found, self._lost = match[1], False
            elif line.strip():
                is_begun = True
            elif found is not None:
                return self._body(found)
            elif is_begun and not self._lost:
                return self._broken("the header of a message lacks `Content-Length`")
        return None

    def _body(self, length: bytes) -> bytes | Broken | None:
        if not length.isdigit():
            told = length[:20].decode("ascii", "replace")
            return self._broken(f"`Content-Length: {told}` is not a number of bytes")
        digits = length.lstrip(b"0")
        if len(digits) > len(str(MOST)) or int(digits or b"0") > MOST:
            told = length[:20].decode()
            return self._broken(f"a message of {told} bytes is too large: {MOST:,} at most")
        size = int(digits or b"0")
        body = bytearray()
        while len(body) < size and (piece := self._stream.read(size - len(body))):
            body += piece
        return bytes(body) if len(body) == size else None

    def _broken(self, why: str) -> Broken:
        self._lost = True
        return Broken(why)


class Outgoing:
    """Where messages to a client are written; when it no longer reads, it counts as gone."""

    def __init__(self, stream: BinaryIO, gone: asyncio.Future[int]) -> None:
        """Take the stream, and what learns that the client is gone."""
        self._stream = stream
        self._gone = gone

    def write(self, data: bytes) -> None:
        """Write a message."""
        try:
            self._stream.write(data)
            self._stream.flush()
        except (OSError, ValueError):  # its end is closed, or this one
            if not self._gone.done():
                self._gone.set_result(1)

    def close(self) -> None:
        """Close this end."""
        with suppress(OSError):
            self._stream.close()
