"""Messages of the debug adapter protocol on a stream: a header that counts bytes, then JSON."""

import json
from collections.abc import Mapping
from typing import Any, BinaryIO, TypeAlias

Message: TypeAlias = Mapping[str, Any]

MOST_BYTES = 4_000_000  # of one message
MOST_HEADER = 4_096  # bytes of all header lines together


class Malformed(ValueError):  # noqa: N818 -- names the situation
    """What came is no message; the text says why."""


def read_message(stream: BinaryIO) -> Message | None:
    """Return the next message; None at the end of the stream.

    Raises:
        Malformed: What came is no message. Where its length is known it has been skipped, so
            reading can go on; otherwise the stream is at its end.
    """
    length = _length(stream)
    if length is None:
        return None
    data = stream.read(length)
    if len(data) < length:
        return None
    try:
        found = json.loads(data)
    except (ValueError, RecursionError) as problem:
        raise Malformed(f"no JSON: {problem}") from problem
    if not isinstance(found, dict):
        raise Malformed("a message is a JSON object")
    return found  # type: ignore[return-value]


def write_message(stream: BinaryIO, message: Message) -> None:
    """Write a message."""
    data = json.dumps(message, ensure_ascii=False, allow_nan=False).encode("utf-8", "replace")
    stream.write(b"Content-Length: %d\r\n\r\n" % len(data) + data)
    stream.flush()


def _length(stream: BinaryIO) -> int | None:
    """Return the length that the header tells; None at the end."""
    length: int | None = None
    seen = 0
    while True:
        line = stream.readline(MOST_HEADER)
        if not line:
            return None
        seen += len(line)
        if seen > MOST_HEADER or not line.endswith(b"\n"):
            _drain(stream)
            raise Malformed("a header without end")
        line = line.strip()
        if not line:
            if length is None:
                raise Malformed("a header without `Content-Length`")
            return length
        name, _, value = line.partition(b":")
        if name.strip().lower() == b"content-length":
            if not value.strip().isdigit() or int(value) > MOST_BYTES:
                _drain(stream)
                raise Malformed(f"a message has at most {MOST_BYTES:,} bytes")
            length = int(value)


def _drain(stream: BinaryIO) -> None:
    """Read to the end: where the next message would begin is not known."""
    while stream.read(1 << 16):
        pass
