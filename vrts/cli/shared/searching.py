"""How far a search is, on terminals only, and when to end it: after a time, or at Ctrl-C."""

import os
import signal
import sys
import time
from collections.abc import Generator
from contextlib import contextmanager
from types import FrameType
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import is_quiet
from vrts.cli.shared.progress import ERASE, SHOWN_EVERY

if TYPE_CHECKING:
    from vrts.prove.asking import Told

ENDED = f"{ERASE}telling what is known so far; Ctrl-C again leaves at once\n".encode()


class Searching:
    """One line that is written over and over, and whether it was enough."""

    def __init__(self, seconds: float | None) -> None:
        """Begin to count.

        Args:
            seconds: When it is enough [s]; None: never.
        """
        self._shown = sys.stderr.isatty() and not is_quiet()
        self._begun = time.monotonic()
        self._seconds = seconds
        self._last = 0.0
        self.interrupted = self.replaying = False

    def told(self, so_far: "Told") -> None:
        """Show how far the search is, if the line is old."""
        now, self.replaying = time.monotonic(), so_far.replaying
        if self._shown and now - self._last > SHOWN_EVERY * (not so_far.replaying):
            self._last = now
            click.echo(f"{ERASE}{words(so_far, now - self._begun)}", nl=False, err=True)

    def enough(self) -> bool:
        """Return whether the search is to end now."""
        late = self._seconds is not None and time.monotonic() - self._begun > self._seconds
        return self.interrupted or late

    def clear(self) -> None:
        """Take the line away."""
        if self._shown:
            click.echo(ERASE, nl=False, err=True)


def words(so_far: "Told", seconds: float) -> str:
    """Return "12,345 states, 4,100 a second, 210 futures open"."""
    rate = so_far.states / seconds if seconds > 0.0 else 0.0
    found = f", {so_far.found} found" if so_far.found else ""
    replayed = ": they are replayed" if so_far.replaying and found else ""
    open_ = f"{so_far.open:,} futures open"
    return f"{so_far.states:,} states, {rate:,.0f} a second, {open_}{found}{replayed}"


@contextmanager
def searching(seconds: float | None) -> Generator[Searching]:
    """Lend what a search tells; the first Ctrl-C ends the search, the second ends the command."""
    found = Searching(seconds)
    before = signal.getsignal(signal.SIGINT)

    def end(_number: int, _frame: FrameType | None) -> None:
        found.interrupted = True
        signal.signal(signal.SIGINT, before)
        if sys.stderr.isatty():
            os.write(2, ENDED)  # whatever is being written just now
        if found.replaying:
            raise KeyboardInterrupt  # a replay may last: it is given up, and so are its workers

    signal.signal(signal.SIGINT, end)
    try:
        yield found
    finally:
        signal.signal(signal.SIGINT, before)
        found.clear()
