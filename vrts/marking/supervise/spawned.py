"""A child started anew: slower, for systems on which a loaded process cannot be forked safely."""

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Sequence
from pathlib import Path

from vrts.marking.supervise.forked import LOG, NO_MEMORY
from vrts.marking.supervise.limits import Limits

_TURN = 0.02  # [s]


class SpawnedProcess:
    """A process under way."""

    def __init__(self, command: Sequence[str], data: bytes, folder: Path, limits: Limits) -> None:
        """Start it; it answers on its standard output, and logs into its folder."""
        self.started = time.monotonic()
        self.log = folder / LOG
        self._data = b""
        self.peak = 0  # not known: the watching parent has seen what it could
        self._most = limits.answer
        with self.log.open("wb") as log:
            self._process = subprocess.Popen(  # noqa: S603 -- our own command
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                start_new_session=True,
            )
        self.pid = self._process.pid
        self._reader = threading.Thread(target=self._converse, args=(data,), daemon=True)
        self._reader.start()

    def _converse(self, data: bytes) -> None:
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        try:
            self._process.stdin.write(data)
            self._process.stdin.close()
        except OSError:
            pass  # it has gone already: the exit status tells
        self._data = self._process.stdout.read(self._most + 1)
        if self.answered_too_much:
            self.kill()

    def ended(self) -> bool:
        """Return whether it is over."""
        if self._process.poll() is None or self._reader.is_alive():
            return False
        for stream in (self._process.stdin, self._process.stdout):
            if stream is not None:
                stream.close()
        return True

    @property
    def answer(self) -> bytes | None:
        """What it answered; None: it did not, or too much."""
        good = self._process.returncode == 0 and not self.answered_too_much
        return self._data if good else None

    @property
    def answered_too_much(self) -> bool:
        """Whether it was ended because its answer has no end."""
        return len(self._data) > self._most

    @property
    def signal(self) -> int | None:
        """The signal that ended it."""
        code = self._process.returncode
        return -code if code is not None and code < 0 else None

    @property
    def out_of_memory(self) -> bool:
        """Whether it says so itself."""
        return self._process.returncode == NO_MEMORY

    def kill(self) -> None:
        """End it and everything it started."""
        if sys.platform == "win32":
            self._process.kill()
            return
        try:
            os.killpg(self.pid, signal.SIGKILL)
        except ProcessLookupError:
            return  # it is gone already


def wait(processes: Sequence[SpawnedProcess], seconds: float) -> None:
    """Sleep for a moment."""
    if processes:
        time.sleep(min(seconds, _TURN))
