"""Standard input with limits, so that no header makes the server take all memory."""

import sys
from typing import BinaryIO

MOST = 64_000_000  # bytes of a message
MOST_HEADER = 65_536  # bytes of a line


class Bounded:
    """What the protocol reads from; a message that is too large counts as the end."""

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream

    def readline(self) -> bytes:
        """Return the next line of a header."""
        return self._stream.readline(MOST_HEADER)

    def read(self, size: int) -> bytes:
        """Return a message; nothing when it is too large or cut off."""
        if size > MOST:
            sys.stderr.write(f"a message of {size:,} bytes is too large; the session ends\n")
            return b""
        return self._stream.read(size)
