"""The child as a process: started, asked, and ended when it takes too long."""

import importlib
import os
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from threading import Timer
from typing import IO, Final, NoReturn, Protocol

import vrts
from vrts.marking.proposer.wire import READY

CHILD: Final = "vrts.marking.proposer.child"
_PLACE: Final = Path(vrts.__file__).parents[1]  # no file beside a program is taken for a library
_THREADS: Final = Path("/proc/self/task")
_GONE: Final = (BrokenPipeError, ConnectionResetError)


class _Started(Protocol):
    """A process that reads questions and writes answers."""

    questions: IO[bytes]
    answers: IO[bytes]

    def kill(self) -> None: ...

    def wait(self) -> None: ...


class Process:
    """A child under way."""

    def __init__(self, *, fork: bool | None = None) -> None:
        """Start it; what it loads it loads while we go on.

        Args:
            fork: Whether to fork this process: 20 ms instead of 90. None: where that is safe.
        """
        self._owner = os.getpid()
        self._said_ready = False
        forks = can_fork() if fork is None else fork
        self._child: _Started = _Forked() if forks else _Spawned()

    def ask(self, message: bytes, answers: int, seconds: float) -> bytes:
        """Return as much of its answers as it gave before it died, at most so many bytes.

        Args:
            message: The questions.
            answers: Bytes of the answers to all of them.
            seconds: It is ended when it takes longer: the last resort.
        """
        child = self._child
        late = Timer(seconds, child.kill)
        late.start()
        try:
            with suppress(*_GONE):  # what it said last is read
                child.questions.write(message)
                child.questions.flush()
            if not self._said_ready:
                self._said_ready = child.answers.read(len(READY)) == READY
            return child.answers.read(answers) if self._said_ready else b""
        finally:
            late.cancel()
            late.join()  # a process with threads cannot fork

    @property
    def is_of_another(self) -> bool:
        """Whether it was started by the process that this one was forked from."""
        return self._owner != os.getpid()

    @property
    def started(self) -> bool:
        """Whether it ever was ready; known after the first question."""
        return self._said_ready

    def kill(self) -> None:
        """End it, and say so to nobody."""
        self._child.kill()

    def end(self) -> None:
        """End it and wait until it has ended; one that is of another process is let go."""
        if not self.is_of_another:
            self._child.kill()
            self._child.wait()
        for stream in (self._child.questions, self._child.answers):
            with suppress(*_GONE):
                stream.close()


def can_fork() -> bool:
    """Return whether this process may be forked: on Linux, without threads of any library."""
    return sys.platform == "linux" and len(list(_THREADS.iterdir())) == 1


def load_for_children() -> None:
    """Load once what every child that is forked from here on needs; nothing is asked here."""
    importlib.import_module(CHILD)


def silenced(first: int) -> None:
    """Leave nothing open of what the parent has from a number on, and complain nowhere."""
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 2)  # words of a library that gives up
    os.closerange(first, 4096)  # the ends of our own pipes too


class _Spawned:
    """A process started anew."""

    def __init__(self) -> None:
        self._process = subprocess.Popen(  # noqa: S603 -- our own command
            [sys.executable, "-m", CHILD],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,  # words of a library that gives up
            cwd=_PLACE,
        )
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self.questions: IO[bytes] = self._process.stdin
        self.answers: IO[bytes] = self._process.stdout

    def kill(self) -> None:
        self._process.kill()

    def wait(self) -> None:
        self._process.wait()


class _Forked:
    """A copy of this process, which has loaded most of what the child needs."""

    def __init__(self) -> None:
        asked, ask = os.pipe()
        told, tell = os.pipe()
        self._pid = os.fork()
        if self._pid == 0:
            _be_child(asked, tell)
        os.close(asked)
        os.close(tell)
        self._over = False
        self.questions: IO[bytes] = os.fdopen(ask, "wb")
        self.answers: IO[bytes] = os.fdopen(told, "rb")

    def kill(self) -> None:
        if not self._over:  # its number is still its own
            os.kill(self._pid, signal.SIGKILL)

    def wait(self) -> None:
        if not self._over:
            self._over = True
            os.waitpid(self._pid, 0)


def _be_child(asked: int, tell: int) -> NoReturn:
    """Answer, and leave without ever returning to the parent's code."""
    try:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        asked, tell = os.dup(asked), os.dup(tell)  # lest one of them is where the other goes
        os.dup2(asked, 0)
        os.dup2(tell, 1)
        silenced(3)
        importlib.import_module(CHILD).serve(0, 1)
    finally:
        os._exit(0)
