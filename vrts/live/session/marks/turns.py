"""Turns of sessions at checks: few check at once, which leaves processors to frames.

Thirty programs that are started together would all be checked in the same second, again and again.
A turn is a lock on a byte of a file that all sessions of a server have open, so who ends gives it
back, however it ends.
"""

import os
import sys
from contextlib import suppress
from typing import Final, Protocol

SHARE: Final = 0.5  # of the processors that checks may take


class Turns(Protocol):
    """Who may check now."""

    def take(self) -> bool:
        """Take a turn; return whether there is one, which one has until it is given back."""
        ...

    def give_back(self) -> None:
        """Let another one have it, if one has a turn."""
        ...


class NoTurns:
    """Everybody may, always: a session that knows of no others."""

    def take(self) -> bool:
        """Take a turn: there always is one."""
        return True

    def give_back(self) -> None:
        """Do nothing."""


def at_once() -> int:
    """Return how many may check at once on this machine."""
    return max(1, int(SHARE * (os.cpu_count() or 1)))


if sys.platform != "win32":
    import fcntl

    class FileTurns:
        """Turns at a file that others have open too."""

        def __init__(self, descriptor: int, count: int) -> None:
            """Take a file that is open to write, and how many have a turn at once."""
            self._descriptor = descriptor
            self._count = count
            self._mine: int | None = None

        def take(self) -> bool:
            """Take a turn; return whether there is one, which one has until it is given back."""
            if self._mine is not None:
                return True
            for place in range(self._count):
                with suppress(BlockingIOError, PermissionError):  # another one has it
                    fcntl.lockf(self._descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, place)
                    self._mine = place
                    return True
            return False

        def give_back(self) -> None:
            """Let another one have it, if one has a turn."""
            if self._mine is not None:
                fcntl.lockf(self._descriptor, fcntl.LOCK_UN, 1, self._mine)
                self._mine = None
