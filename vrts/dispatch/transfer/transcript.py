"""All that goes over the line, with times: one row for each piece in one direction."""

from collections.abc import Callable
from datetime import datetime
from typing import TextIO

SENT, RECEIVED = ">", "<"
_LONGEST = 400  # characters of a row


class Transcript:
    """Writes rows as soon as they are whole; control characters as escapes."""

    def __init__(self, file: TextIO, now: Callable[[], datetime]) -> None:
        """Write to a file that somebody else opens and closes."""
        self._file = file
        self._now = now
        self._began: datetime | None = None  # of the row that is not yet whole
        self._direction = ""
        self._row = ""

    def sent(self, data: bytes) -> None:
        """Note what was sent."""
        self._note(SENT, data)

    def received(self, data: bytes) -> None:
        """Note what came."""
        self._note(RECEIVED, data)

    def remark(self, text: str) -> None:
        """Note what is going on."""
        self.finish()
        self._write(self._now(), "-", text)

    def finish(self) -> None:
        """Write the row that is not yet whole."""
        if self._began is not None:
            self._write(self._began, self._direction, ascii(self._row)[1:-1])
        self._began, self._row = None, ""

    def _note(self, direction: str, data: bytes) -> None:
        if direction != self._direction:
            self.finish()
            self._direction = direction
        for character in data.decode("latin-1"):
            if self._began is None:
                self._began = self._now()
            self._row += character
            if character == "\n" or len(self._row) >= _LONGEST:
                self.finish()

    def _write(self, at: datetime, direction: str, text: str) -> None:
        self._file.write(f"{at.isoformat(timespec='milliseconds')} {direction} {text}\n")
        self._file.flush()
