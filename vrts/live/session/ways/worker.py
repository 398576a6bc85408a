"""A child forked from a session that answers one question after the other, beside the frames.

It has everything loaded that the session has, and knows the scene as it was when the session began:
scenes never change. What changes comes with the question.
"""

import os
import pickle
import signal
from collections.abc import Callable
from contextlib import suppress
from typing import Any, Final

from vrts.live.session.marks.checker import NICENESS
from vrts.marking.supervise import forked
from vrts.marking.supervise.limits import Limits

LONGEST: Final = 60_000  # bytes of a question: less than a pipe takes without anybody reading
LIMITS: Final = Limits(cpu_s=3600, memory=500_000_000, niceness=NICENESS)
_HEAD: Final = 4  # bytes of a length
_CHUNK: Final = 1 << 16


class TooLong(Exception):  # noqa: N818 -- names the situation
    """A question that a pipe does not take at once."""


class Worker:
    """The child, as the session sees it."""

    def __init__(self, work: Callable[[Any], object]) -> None:
        """Start it; `work` answers a question there."""
        asked, self._ask = os.pipe()
        self._told, tell = os.pipe()
        log = os.open(os.devnull, os.O_WRONLY)
        ends = forked.Ends(tell, log, asked)
        self.pid = forked.start(lambda: _answer(work, tell), ends, LIMITS)
        os.set_blocking(self._told, False)
        self._come = bytearray()
        self.lost = False

    def fileno(self) -> int:
        """Return what becomes readable when it answers or ends."""
        return self._told

    def ask(self, question: object) -> None:
        """Ask it something; one question at a time.

        Raises:
            TooLong: It is too long.
        """
        data = pickle.dumps(question)
        if len(data) > LONGEST:
            raise TooLong
        with suppress(BrokenPipeError):  # it has ended: `answer` tells
            os.write(self._ask, len(data).to_bytes(_HEAD, "little") + data)

    def answer(self) -> tuple[object, ...]:
        """Return the answer, if it has come; nothing: it has not, or the child is `lost`."""
        while not self.lost:
            try:
                part = os.read(self._told, _CHUNK)
            except BlockingIOError:
                break
            self.lost = not part
            self._come += part
        length = int.from_bytes(self._come[:_HEAD], "little")
        if len(self._come) < _HEAD + max(length, 1):
            return ()
        data = bytes(self._come[_HEAD : _HEAD + length])
        self._come.clear()
        return (pickle.loads(data),)  # noqa: S301 -- what our own fork has sent

    def end(self) -> None:
        """End it at once, and wait until it has ended."""
        with suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGKILL)
        os.waitpid(self.pid, 0)
        os.close(self._ask)
        os.close(self._told)


def _answer(work: Callable[[Any], object], tell: int) -> None:
    """Answer until nobody asks any more."""
    while head := _read(0, _HEAD):
        question = pickle.loads(_read(0, int.from_bytes(head, "little")))  # noqa: S301
        data = pickle.dumps(work(question))
        forked.write(tell, len(data).to_bytes(_HEAD, "little") + data)


def _read(end: int, most: int) -> bytes:
    """Return so many bytes, or fewer where nobody writes any more."""
    parts: list[bytes] = []
    while most and (part := os.read(end, most)):
        parts.append(part)
        most -= len(part)
    return b"".join(parts)
