"""A program at a terminal of its own: a pty, what it writes, and keys typed.

What fills the screen writes only what changes: of a new line that shares letters with the old one
the rest. So what it wrote is looked at in two ways, as text and as what a terminal shows then.
"""

import copy
import fcntl
import os
import re
import select
import struct
import subprocess
import sys
import termios
import time
from collections.abc import Sequence
from pathlib import Path

import pyte

PATIENCE = 60.0  # [s] with a busy machine
_ROWS, _COLUMNS = 40, 110
_SIZE = struct.pack("HHHH", _ROWS, _COLUMNS, 0, 0)


class Child:
    """A command of vrts at a terminal."""

    def __init__(self, arguments: Sequence[str], folder: Path) -> None:
        self._master, slave = os.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, _SIZE)
        environment = {
            "TERM": "xterm",
            "LANG": "C.UTF-8",
            "XDG_CACHE_HOME": str(folder / "cache"),
        }
        self._process = subprocess.Popen(
            [sys.executable, "-m", "vrts.cli.main", *arguments],
            stdin=slave,
            stdout=slave,
            stderr=slave,
            cwd=folder,
            env=environment,
            start_new_session=True,
            preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0),
        )
        os.close(slave)
        self._unread = ""
        self._screen = pyte.Screen(_COLUMNS, _ROWS)  # of what is looked at

    def send(self, keys: str) -> None:
        """Type keys."""
        os.write(self._master, keys.encode())

    def expect(self, pattern: str) -> None:
        """Wait until what is written and not yet looked at shows a pattern; go on behind it."""
        until = time.monotonic() + PATIENCE
        while True:
            match = re.search(pattern, self._unread)
            if match is not None:
                self._screen = self._drawn(self._unread[: match.end()])
                self._unread = self._unread[match.end() :]
                return
            screen = self._drawn(self._unread)
            lines = screen.display
            if any(re.search(pattern, lines[row]) for row in screen.dirty if row < _ROWS):
                self._screen, self._unread = screen, ""
                return
            assert time.monotonic() < until, f"no {pattern!r} in {self._unread!r}"
            assert self._read(), f"no {pattern!r} before the end: {self._unread!r}"

    def children(self, number: int) -> list[int]:
        """Wait until it has so many processes of its own; return their ids."""
        pid = self._process.pid
        path, until = Path(f"/proc/{pid}/task/{pid}/children"), time.monotonic() + PATIENCE
        while True:
            found = [int(word) for word in path.read_text().split()]
            if len(found) >= number:
                return found
            assert time.monotonic() < until, f"{len(found)} processes of its own"
            assert self._read(0.01), f"it has ended: {self._unread!r}"

    def status(self) -> int:
        """Wait for the end and return the exit status."""
        until = time.monotonic() + PATIENCE
        while self._read():
            assert time.monotonic() < until, f"it does not end: {self._unread!r}"
        return self._process.wait(PATIENCE)

    def leave(self) -> int:
        """Press Ctrl-D until it ends, return the exit status: one between two prompts is lost."""
        until = time.monotonic() + PATIENCE
        while self._read(0.05):
            assert time.monotonic() < until, f"it does not end: {self._unread!r}"
            if self._sleeps() and not termios.tcgetattr(self._master)[3] & termios.ICANON:
                self.send("\x04")  # a prompt waits for keys
                self._read()
        return self._process.wait(PATIENCE)

    def until_signals(self) -> None:
        """Wait until Ctrl-C would be a signal, and no key: something is being worked out."""
        until = time.monotonic() + PATIENCE
        while not termios.tcgetattr(self._master)[3] & termios.ISIG:
            assert time.monotonic() < until, f"keys all the time: {self._unread!r}"
            assert self._read(0.001), f"it has ended: {self._unread!r}"

    def until_it_waits(self) -> None:
        """Wait until it sleeps: Ctrl-C just before Python reads is seen only after the reading."""
        until = time.monotonic() + PATIENCE
        while not self._sleeps():
            assert time.monotonic() < until, f"it works on: {self._unread!r}"
            assert self._read(0.01), f"it has ended: {self._unread!r}"

    def hang_up(self) -> int:
        """Take the terminal away as a line that breaks; return the exit status."""
        os.close(self._master)
        self._master = os.open(os.devnull, os.O_RDONLY)
        return self._process.wait(PATIENCE)

    def close(self) -> None:
        """Take the terminal away."""
        if self._process.poll() is None:
            self._process.kill()
            self._process.wait()
        os.close(self._master)

    def _drawn(self, text: str) -> pyte.Screen:
        """Return the screen after more text; `dirty` are the rows that it changed."""
        screen = copy.deepcopy(self._screen)
        screen.dirty.clear()
        pyte.Stream(screen).feed(text)
        return screen

    def _sleeps(self) -> bool:
        state = Path(f"/proc/{self._process.pid}/stat").read_text().rpartition(")")[2]
        return state.split()[0] == "S"

    def _read(self, seconds: float = 1.0) -> bool:
        """Read what is there; return False at the end."""
        if not select.select([self._master], [], [], seconds)[0]:
            return True
        try:
            data = os.read(self._master, 65536)
        except OSError:  # how Linux tells that the other side is closed
            return False
        self._unread += data.decode("utf-8", "replace")
        return bool(data)
