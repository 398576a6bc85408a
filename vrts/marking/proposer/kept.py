"""A child that is kept: started once, it answers all processes that mark, one after the other.

A keeper starts it, and another where it ended: of a question, or because it took too long. Who
gets no answer asks a child of its own, as where none is kept, so nothing depends on this one.
"""

import importlib
import os
import signal
import socket
import tempfile
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Final, NoReturn

from vrts.base.workers import END, end_with, undisturbed
from vrts.marking.proposer.process import CHILD, silenced
from vrts.marking.proposer.wire import READY

MOST_STARTS: Final = 1000  # of one keeper
PATIENCE_S: Final = 10  # for all that one process asks at once, which takes milliseconds
_WAITING: Final = 64  # processes that may wait for their turn


class Kept:
    """The keeper and its child; whoever starts it ends it, at the latest by ending itself."""

    def __init__(self, limit: Callable[[], None]) -> None:
        """Start it; this process has no threads.

        Args:
            limit: Limits the process it is called in.
        """
        self._folder = tempfile.TemporaryDirectory()  # nobody else may look into it
        self.address = str(Path(self._folder.name) / "fcl")
        with socket.socket(socket.AF_UNIX) as listening:
            listening.bind(self.address)
            listening.listen(_WAITING)
            with undisturbed():
                parent = os.getpid()
                self._keeper = os.fork()
                if self._keeper == 0:
                    _be_keeper(listening, limit, parent)
        self._parent = parent

    def end(self) -> None:
        """End both, once; in a process forked since, do nothing."""
        if os.getpid() == self._parent:
            self._parent = 0
            os.kill(self._keeper, signal.SIGKILL)
            os.waitpid(self._keeper, 0)
            self._folder.cleanup()


def asked(address: str, message: bytes, answers: int) -> bytes:
    """Return as much of its answers to a message as a kept child gave, at most so many bytes."""
    found: list[bytes] = []
    with suppress(OSError), socket.socket(socket.AF_UNIX) as to:
        to.settimeout(PATIENCE_S)
        to.connect(address)
        to.sendall(message)
        left = len(READY) + answers
        while left and (part := to.recv(min(left, 1 << 16))):
            found.append(part)
            left -= len(part)
    return b"".join(found)[len(READY) :]


def _be_keeper(listening: socket.socket, limit: Callable[[], None], parent: int) -> NoReturn:
    """Keep a child, and never return to the parent's code."""
    try:
        os.setsid()
        for number in END:
            signal.signal(number, signal.SIG_DFL)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, END)
        os.dup2(listening.fileno(), 3)
        silenced(4)
        for number in (0, 1):
            os.dup2(2, number)
        if end_with(parent):
            limit()
            for _ in range(MOST_STARTS):
                keeper = os.getpid()
                child = os.fork()
                if child == 0:
                    _answer_all(keeper)
                os.waitpid(child, 0)
    finally:
        os._exit(0)


def _answer_all(keeper: int) -> NoReturn:
    """Answer one process after the other, until one takes too long: SIGALRM ends this one then."""
    try:
        if end_with(keeper):
            serve = importlib.import_module(CHILD).serve
            with socket.socket(fileno=3) as listening:
                while True:
                    connection, _ = listening.accept()
                    signal.alarm(PATIENCE_S)
                    with connection, suppress(OSError):  # it may be gone
                        serve(connection.fileno(), connection.fileno())
                    signal.alarm(0)
    finally:
        os._exit(0)
