"""Work that a process has done beside it, one piece at a time, in children forked from it."""

import os
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Final, NamedTuple

from vrts.marking.supervise.forked import ForkedProcess
from vrts.marking.supervise.limits import Limits

FORKS: Final = sys.platform != "win32"


class Done(NamedTuple):
    """A piece of work that is over."""

    answer: bytes | None  # None: there is none, or more than may be
    took_s: float  # [s]


class Aside:
    """Has work done; ends what is under way when it is left.

    It does not wait: who has begun something asks with `take` whether it is done.
    """

    def __init__(self, limits: Limits, *, forks: bool = FORKS) -> None:
        """Take what a child may use; `forks`: whether there are children.

        Without them `begin` does the work itself, and the first `take` has the answer.
        """
        self._limits = limits
        self._forks = forks
        self._folder = tempfile.TemporaryDirectory()
        self._done: Done | None = None
        self.child: ForkedProcess | None = None  # what becomes readable when it answers

    def close(self) -> None:
        """End what is under way, and forget it."""
        self.drop()
        self._folder.cleanup()

    @property
    def busy(self) -> bool:
        """Whether something was begun that is not taken yet."""
        return self.child is not None or self._done is not None

    def begin(self, work: Callable[[], bytes]) -> None:
        """Have something done. What was begun before has been taken."""
        assert not self.busy
        if self._forks:
            self.child = ForkedProcess(work, Path(self._folder.name), self._limits)
            return
        started = time.monotonic()
        answer = work()
        self._done = Done(answer, time.monotonic() - started)

    def take(self) -> Done | None:
        """Return what was begun, once, if it is over. What takes too long is ended."""
        if self.child is not None:
            took_s = time.monotonic() - self.child.started
            if not self.child.ended():
                if took_s > self._limits.wall_s:
                    self.child.kill()
                return None
            self._done, self.child = Done(self.child.answer, took_s), None
        done, self._done = self._done, None
        return done

    def drop(self) -> None:
        """End what is under way; nobody wants its answer."""
        if self.child is not None:
            self.child.kill()
            os.set_blocking(self.child.fileno(), True)
            while not self.child.ended():
                pass
        self.child = self._done = None
