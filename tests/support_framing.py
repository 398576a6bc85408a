"""Messages of the language server and debug adapter protocols: a header, then JSON."""

import json
from typing import IO, Any


def framed(message: object) -> bytes:
    """Return a message as it is sent."""
    data = json.dumps(message).encode()
    return b"Content-Length: %d\r\n\r\n" % len(data) + data


def read_framed(stream: IO[bytes]) -> dict[str, Any] | None:
    """Return the next message; None at the end of the stream."""
    length = 0
    while (line := stream.readline()).strip():
        name, _, value = line.partition(b":")
        if name.lower() == b"content-length":
            length = int(value)
    return json.loads(stream.read(length)) if line else None
