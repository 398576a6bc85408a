"""Messages of the debug adapter protocol on a stream: a header that counts bytes, then JSON."""

import json
import re
from collections.abc import Mapping
from typing import Any, BinaryIO, Protocol, TypeAlias

Message: TypeAlias = Mapping[str, Any]

MOST_BYTES = 4_000_000  # of one message
MOST_HEADER = 4_096  # bytes of a header line that are looked at
_AT_ONCE = 1 << 16  # bytes
_LENGTH = re.compile(rb"(.*)content-length[ \t]*:[ \t]*(\d{1,9})[ \t\r]*\Z", re.I | re.S)


class Malformed(ValueError):  # noqa: N818 -- names the situation
    """What came is no message; the text says why."""


class _Reads(Protocol):
    def read(self, size: int = ..., /) -> bytes | None: ...


class Incoming:
    """Messages that come on a stream; after a bad one it goes on with the next that is none.

    It holds no lock while it waits, so that a program may end meanwhile.
    """

    def __init__(self, stream: BinaryIO) -> None:
        """Take a stream of which nothing was read yet."""
        self._stream: _Reads = getattr(stream, "raw", stream)
        self._bytes = b""
        self._lost = False  # where the next message begins is not known

    def read_message(self) -> Message | None:
        """Return the next message; None at the end of the stream.

        Raises:
            Malformed: What came is no message. It has been skipped, and reading can go on.
        """
        length = self._length()
        if length is None:
            return None
        if length > MOST_BYTES:
            self._lost = True
            raise Malformed(f"a message has at most {MOST_BYTES:,} bytes")
        data = self._exactly(length)
        if data is None:
            return None
        try:
            found = json.loads(data)
        except (ValueError, RecursionError) as problem:
            raise Malformed(f"no JSON: {problem}") from problem
        if not isinstance(found, dict):
            raise Malformed("a message is a JSON object")
        return found  # type: ignore[return-value]

    def _length(self) -> int | None:
        """Return the length that the header tells; None at the end."""
        length: int | None = None
        lines = 0
        while True:
            line = self._line()
            if line is None:
                return None
            lines += 1
            found = _LENGTH.match(line)
            if found is not None and (self._lost or not found[1].strip()):
                length, self._lost = int(found[2]), False
            elif self._lost:
                continue
            elif not line.strip():
                if length is not None:
                    return length
                self._lost = True
                raise Malformed("a header without `Content-Length`")
            elif len(line) >= MOST_HEADER or lines > MOST_HEADER or b":" not in line:
                self._lost = True
                raise Malformed("a header without end")
            elif line.strip().lower().startswith(b"content-length"):
                self._lost = True
                raise Malformed("`Content-Length` is a number of bytes")

    def _line(self) -> bytes | None:
        """Return the next line, or the end of one that is too long; None at the end."""
        while (end := self._bytes.find(b"\n")) < 0:
            if not self._more():
                return None
            if b"\n" not in self._bytes[-_AT_ONCE:]:
                self._bytes = self._bytes[-2 * MOST_HEADER :]
        line, self._bytes = self._bytes[:end], self._bytes[end + 1 :]
        return line[-MOST_HEADER:]

    def _exactly(self, count: int) -> bytes | None:
        pieces, missing = [self._bytes[:count]], count - len(self._bytes)
        self._bytes = self._bytes[count:]
        while missing > 0:
            if not self._more():
                return None
            pieces.append(self._bytes[:missing])
            missing -= len(pieces[-1])
            self._bytes = self._bytes[len(pieces[-1]) :]
        return b"".join(pieces)

    def _more(self) -> bool:
        """Wait for more bytes; return whether any came."""
        came = self._stream.read(_AT_ONCE)
        self._bytes += came or b""
        return bool(came)


def write_message(stream: BinaryIO, message: Message) -> None:
    """Write a message."""
    data = json.dumps(message, ensure_ascii=False, allow_nan=False).encode("utf-8", "replace")
    stream.write(b"Content-Length: %d\r\n\r\n" % len(data) + data)
    stream.flush()
