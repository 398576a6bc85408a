"""Brings the files that follow from decisions up to date: beside the desk, and before it ends.

Decisions count from the moment they are written: whoever reads the folder makes the marks of them.
What follows (lists, feedback, pages) is written when nothing was decided for a moment. If the desk
dies before, the next one makes up for it, and so does `vrts grade`.
"""

import threading
from collections.abc import Callable
from typing import Final

QUIET_S: Final = 1.0  # without a decision before files are written
LONGEST_S: Final = 10.0  # that they may be behind while somebody decides without a pause
AGAIN_S: Final = 2.0  # until what could not be written is tried again


class Upkeep:
    """One thread that writes, whenever it is wanted."""

    def __init__(
        self, write: Callable[[], str], quiet_s: float = QUIET_S, again_s: float = AGAIN_S
    ) -> None:
        """Take what writes, and returns what went wrong; then it is tried again after a while."""
        self._write = write
        self.problem = ""  # of the last time
        self._quiet_s = quiet_s
        self._again_s = again_s
        self._wake = threading.Condition()
        self._wanted = 0  # how often, so far
        self._written = 0
        self._ends = False
        self._thread = threading.Thread(target=self._work, daemon=True)

    def begin(self) -> None:
        """Begin to work."""
        self._thread.start()

    def wanted(self) -> None:
        """Say that something was decided."""
        with self._wake:
            self._wanted += 1
            self._wake.notify_all()

    def end(self) -> None:
        """Write what is still to be written, and end."""
        with self._wake:
            self._ends = True
            self._wake.notify_all()
        self._thread.join()

    def _work(self) -> None:
        while True:
            with self._wake:
                self._wake.wait_for(lambda: self._ends or self._wanted > self._written)
                if self._wanted == self._written:
                    return
                waited = 0.0
                while not self._ends and waited < LONGEST_S:
                    seen = self._wanted
                    self._wake.wait_for(
                        lambda seen=seen: self._ends or self._wanted > seen, self._quiet_s
                    )
                    if self._wanted == seen:
                        break
                    waited += self._quiet_s
                until = self._wanted
            try:
                problem = self._write()
            except Exception as fault:  # told, and tried again: it goes on
                problem = f"lists and feedback are not up to date: {fault or type(fault).__name__}"
            self.problem = problem
            with self._wake:
                if not problem or self._ends:
                    self._written = until
                else:
                    self._wake.wait_for(lambda: self._ends, self._again_s)
