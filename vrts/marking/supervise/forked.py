"""A child forked from a warm parent: it starts in milliseconds, with everything loaded.

Only a parent without threads may fork; whoever starts threads (recordings, browsers, clusters)
does so in the children.
"""

import faulthandler
import gc
import os
import select
import signal
import sys
import time
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple, NoReturn

from vrts.base.workers import END, end_with
from vrts.marking.supervise.limits import Limits, impose

LOG = "child.log"
FAILED, NO_MEMORY = 70, 71  # exit statuses
_CHUNK = 1 << 16
_SELDOM = 100_000  # objects made, and not yet gone, between looks for rings of dead ones


class Ends(NamedTuple):
    """What is open in a child, as the numbers it has in the parent, which closes its own."""

    tell: int  # keeps its number: where it answers
    log: int  # its output, and what it complains of
    asked: int | None = None  # its input; None: an empty one


class ForkedProcess:
    """A process under way."""

    def __init__(self, work: Callable[[], bytes], folder: Path, limits: Limits) -> None:
        """Start it; it answers with what `work` returns, and logs into its folder."""
        self.started = time.monotonic()
        self.log = folder / LOG
        self._parts: list[bytes] = []
        self._length = 0
        self._most = limits.answer
        self.status: int | None = None  # wait status
        self.peak = 0  # bytes of memory in use at most, known when it is over
        self._ours, theirs = os.pipe()
        # opened here: when the parent is interrupted it takes the folder away at once
        log = os.open(self.log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
        self.pid = start(lambda: write(theirs, work()), Ends(theirs, log), limits)
        os.set_blocking(self._ours, False)

    def fileno(self) -> int:
        """Return what becomes readable when it answers."""
        return self._ours

    def ended(self) -> bool:
        """Read what there is; return whether it is over."""
        if self.status is not None:
            return True
        while True:
            try:
                part = os.read(self._ours, _CHUNK)
            except BlockingIOError:
                return False
            if not part:
                _, self.status, used = os.wait4(self.pid, 0)
                self.peak = used.ru_maxrss * (1 if sys.platform == "darwin" else 1024)
                os.close(self._ours)
                return True
            self._length += len(part)
            if self._length <= self._most:
                self._parts.append(part)
            else:
                self.kill()

    @property
    def answer(self) -> bytes | None:
        """What it answered; None: it did not, or too much."""
        if self.status != 0 or self.answered_too_much:
            return None
        return b"".join(self._parts)

    @property
    def answered_too_much(self) -> bool:
        """Whether it was ended because its answer has no end."""
        return self._length > self._most

    @property
    def signal(self) -> int | None:
        """The signal that ended it."""
        if self.status is None or not os.WIFSIGNALED(self.status):
            return None
        return os.WTERMSIG(self.status)

    @property
    def out_of_memory(self) -> bool:
        """Whether it says so itself."""
        return self.status is not None and os.waitstatus_to_exitcode(self.status) == NO_MEMORY

    def kill(self) -> None:
        """End it and everything it started."""
        try:
            os.killpg(self.pid, signal.SIGKILL)
        except ProcessLookupError:  # it has not made its group yet, or is gone already
            if self.status is None:
                os.kill(self.pid, signal.SIGKILL)


def wait(processes: Sequence[ForkedProcess], seconds: float) -> None:
    """Sleep until one of them says something, or for a time."""
    select.select(processes, [], [], seconds)


def start(work: Callable[[], object], ends: Ends, limits: Limits) -> int:
    """Fork a child that does its work and ends, at the latest with its parent.

    Nothing else that the parent has open is open in it. Exit status 0: it has done its work.

    Returns:
        Its number; it leads a group of its own.
    """
    sys.stdout.flush()
    sys.stderr.flush()
    gc.freeze()  # what is loaded is not copied by the children's garbage collection
    parent = os.getpid()
    pid = os.fork()
    if pid == 0:
        _be_child(work, ends, limits, parent)
    for end in ends:
        if end is not None:
            os.close(end)
    return pid


def _be_child(work: Callable[[], object], ends: Ends, limits: Limits, parent: int) -> NoReturn:
    """Work and leave without ever returning to the parent's code."""
    status = FAILED
    try:
        _redirect(ends)  # first: whatever goes wrong is no business of the terminal's
        os.setsid()
        if not end_with(parent):
            os._exit(FAILED)
        for number in END:
            signal.signal(number, signal.SIG_DFL)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, END)
        impose(limits)
        faulthandler.enable(2)
        gc.set_threshold(_SELDOM)
        work()
        status = 0
    except MemoryError:
        status = NO_MEMORY
    except BaseException:  # whatever it is goes into the log; the parent goes on
        traceback.print_exc()
    finally:
        try:
            sys.stdout.flush()
            sys.stderr.flush()
        finally:
            os._exit(status)


def write(out: int, data: bytes) -> None:
    """Write all of it."""
    left = memoryview(data)
    while left:
        left = left[os.write(out, left) :]


def _redirect(ends: Ends) -> None:
    """Leave nothing open but the input, the log, and the way to the parent."""
    asked = os.open(os.devnull, os.O_RDONLY) if ends.asked is None else ends.asked
    os.dup2(asked, 0)
    os.dup2(ends.log, 1)
    os.dup2(ends.log, 2)
    sys.stdout = sys.stderr = open(2, "w", errors="backslashreplace", closefd=False)  # noqa: SIM115
    os.closerange(3, ends.tell)
    os.closerange(ends.tell + 1, 4096)
