"""`vrts serve` whose clock somebody else can set on, so that hours pass in which nothing happens.

A process of its own: `python -m tests.bench.live_hours serve ...`. How far its clock is ahead [s],
and by how much the machine's clock was stepped [s], stand in the file that `VRTS_AHEAD` names, as
doubles. A step changes what `time.time` says, as setting the machine's clock does. Both clocks of
`vrts.live.lasting.clock` go by the other number, so turns and leases end, places of who is away are
given up, private rooms close and rates recover as after so many hours. Sessions have processes and
clocks of their own: for them only the time passes that passes.
"""

import mmap
import os
import struct
import time
from pathlib import Path
from typing import Final

from vrts.live.lasting import clock

VARIABLE: Final = "VRTS_AHEAD"
_AHEAD = struct.Struct("dd")


class Ahead:
    """How far a server's clock is ahead of the machine's, as who tries the server sets it."""

    def __init__(self, path: Path) -> None:
        """Begin with no difference."""
        self.path = path
        self.seconds = self.stepped = 0.0
        self._write()

    def set(self, seconds: float) -> None:
        """Have the server's clock so far ahead [s], from now on."""
        self.seconds = seconds
        self._write()

    def step(self, seconds: float) -> None:
        """Step the machine's clock, as the server sees it [s]."""
        self.stepped += seconds
        self._write()

    def _write(self) -> None:
        with self.path.open("r+b" if self.path.exists() else "wb") as file:
            file.write(_AHEAD.pack(self.seconds, self.stepped))


def set_on(path: Path) -> None:
    """Have both clocks go by a file; before anything of the server is imported."""
    with path.open("rb") as file:
        known = mmap.mmap(file.fileno(), _AHEAD.size, access=mmap.ACCESS_READ)
    steady, wall, machine = clock.steady, clock.wall, time.time

    def ahead() -> float:
        return float(_AHEAD.unpack_from(known)[0])

    clock.steady = lambda: steady() + ahead()
    clock.wall = lambda: wall() + ahead()
    time.time = lambda: machine() + float(_AHEAD.unpack_from(known)[1])


if __name__ == "__main__":
    set_on(Path(os.environ[VARIABLE]))
    from vrts.cli.main import main

    main()
