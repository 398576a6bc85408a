"""Orders from the server: one JSON document a line."""

import os

import msgspec

from vrts.live.session.channel.messages import LONGEST_ORDER, ToSession

_CHUNK = 1 << 16


class Unreadable(Exception):  # noqa: N818 -- names the situation
    """A line is no order: the server is another version, or broken."""


class Inbox:
    """Reads without ever waiting."""

    def __init__(self, descriptor: int) -> None:
        """Take a file descriptor to read from."""
        self._descriptor = descriptor
        self._begun = bytearray()
        self._decoder = msgspec.json.Decoder(ToSession)
        self.ended = False
        os.set_blocking(descriptor, False)

    def orders(self) -> list[ToSession]:
        """Return the orders that have come.

        Raises:
            Unreadable: A line is no order, or has no end.
        """
        found: list[ToSession] = []
        while not self.ended:
            try:
                data = os.read(self._descriptor, _CHUNK)
            except BlockingIOError:
                break
            if not data:
                self.ended = True
                break
            self._begun += data
            *lines, rest = self._begun.split(b"\n")
            self._begun = bytearray(rest)
            found += map(self._order, lines)
            if len(self._begun) > LONGEST_ORDER:
                raise Unreadable("a line has no end")
        return found

    def _order(self, line: bytearray) -> ToSession:
        try:
            return self._decoder.decode(line)
        except msgspec.MsgspecError as problem:
            raise Unreadable(str(problem)) from problem
