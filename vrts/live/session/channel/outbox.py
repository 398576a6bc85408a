"""Messages on their way to the server, which may be slow: pose frames are dropped, news is not."""

import os

import msgspec

from vrts.live.session.channel.messages import LENGTH, News

PATIENCE = 64 * 1024  # bytes that wait, beyond which pose frames are dropped
MOST = 64 * 1024 * 1024  # bytes that wait, beyond which the server counts as gone


class ServerGone(Exception):  # noqa: N818 -- names the situation
    """Nobody reads what the session says."""


class Outbox:
    """Writes without ever waiting."""

    def __init__(self, descriptor: int) -> None:
        """Take a file descriptor to write to."""
        self._descriptor = descriptor
        self._waiting = bytearray()
        self._encoder = msgspec.json.Encoder()
        os.set_blocking(descriptor, False)

    def fileno(self) -> int:
        """Return what becomes writable."""
        return self._descriptor

    @property
    def waits(self) -> bool:
        """Whether something is still to be written."""
        return bool(self._waiting)

    def send(self, message: News | bytes) -> None:
        """Send news, or a pose frame.

        Raises:
            ServerGone: Nobody reads.
        """
        is_frame = isinstance(message, bytes)
        if is_frame and len(self._waiting) > PATIENCE:
            return
        data = message if isinstance(message, bytes) else self._encoder.encode(message)
        self._waiting += LENGTH.pack(len(data)) + data
        if len(self._waiting) > MOST:
            raise ServerGone

    def flush(self) -> None:
        """Write what can be written at once.

        Raises:
            ServerGone: Nobody reads any more.
        """
        while self._waiting:
            try:
                written = os.write(self._descriptor, self._waiting)
            except BlockingIOError:
                return
            except BrokenPipeError as gone:
                raise ServerGone from gone
            del self._waiting[:written]
