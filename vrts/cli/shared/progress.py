"""How far marking is, with rate and remaining time: on terminals only, on the error stream."""

import sys
import time
from collections.abc import Generator
from contextlib import contextmanager

import click

from vrts.cli.shared.console import INTERRUPTED, is_quiet, warn, was_interrupted

SHOWN_EVERY = 0.1  # [s]
ERASE = "\r\x1b[K"


class Progress:
    """One line that is written over and over."""

    def __init__(self) -> None:
        """Show nothing yet."""
        self._shown = sys.stderr.isatty() and not is_quiet()
        self._all = 0
        self._done = 0
        self._made = 0  # not there already: these tell the rate
        self._begun = time.monotonic()
        self._last = 0.0

    def begin(self, number: int) -> None:
        """Say how many there are."""
        self._all = number
        self._begun = time.monotonic()

    def step(self, *, reused: bool = False) -> None:
        """Count one more."""
        self._done += 1
        self._made += not reused

    def advance(self, done: int, number: int) -> None:
        """Say how many there are and how many of them are done, and show it."""
        if not self._all:
            self.begin(number)
        self._made += done - self._done
        self._done = done
        self.show()

    def show(self) -> None:
        """Write the line again, if it is old."""
        now = time.monotonic()
        if self._shown and (now - self._last > SHOWN_EVERY or self._done == self._all):
            self._last = now
            click.echo(f"{ERASE}{self.words(now - self._begun)}", nl=False, err=True)

    def words(self, seconds: float) -> str:
        """Return "120 of 300, 5.1 a second, 0:35 left"."""
        text = f"{self._done} of {self._all}"
        left = self._all - self._done
        if not self._made or not left or seconds <= 0.0:
            return text
        rate = self._made / seconds
        minutes, rest = divmod(round(left / rate), 60)
        return f"{text}, {rate:.1f} a second, {minutes}:{rest:02d} left"

    @contextmanager
    def interruptible(self, then: str) -> Generator[None]:
        """When Ctrl-C ends what is inside, tell how far it was, and end with a status of its own.

        Args:
            then: What becomes of what is marked.
        """
        try:
            yield
        except (KeyboardInterrupt, OSError) as problem:
            if not was_interrupted(problem):
                raise
            self.clear()
            begun = f"{self._done} of {self._all} {'is' if self._done == 1 else 'are'} marked; "
            warn(f"interrupted: {begun if self._all else ''}{then}")
            sys.exit(INTERRUPTED)

    def clear(self) -> None:
        """Take the line away."""
        if self._shown:
            click.echo(ERASE, nl=False, err=True)
