"""The end of the server's own log, kept for the admin page; all of it goes to stderr as before."""

import logging
from collections import deque
from typing import Final

import msgspec

from vrts.live.names import readable

KEPT: Final = 200  # entries
LONGEST: Final = 2000  # characters of one
LOGGERS: Final = ("vrts.live", "uvicorn.error")


class LogEntry(msgspec.Struct, frozen=True):
    """What was logged."""

    at: float  # Unix time [s]
    level: str
    text: str  # every character visible


class LogTail(logging.Handler):
    """Keeps the last entries."""

    def __init__(self) -> None:
        """Begin without any."""
        super().__init__(logging.INFO)
        self.entries: deque[LogEntry] = deque(maxlen=KEPT)
        self.setFormatter(logging.Formatter("%(message)s"))

    def emit(self, record: logging.LogRecord) -> None:
        """Keep an entry; pass it on to where it would have gone without this."""
        text = readable(self.format(record))[-LONGEST:]  # the end of a trace says most
        self.entries.append(LogEntry(record.created, record.levelname.lower(), text))
        last = logging.lastResort
        if last is not None and record.levelno >= last.level:
            last.handle(record)


def follow_log() -> LogTail:
    """Begin to keep what is logged; loggers of an earlier server are left."""
    tail = LogTail()
    for name in LOGGERS:
        logger = logging.getLogger(name)
        for handler in [h for h in logger.handlers if isinstance(h, LogTail)]:
            logger.removeHandler(handler)
        logger.addHandler(tail)
    return tail
