"""`vrts serve` whose clock somebody else can set on, so that hours pass in which nothing happens.

A process of its own: `python -m tests.bench.live_hours serve ...`. How far its clock is ahead [s]
stands in the file that `VRTS_AHEAD` names, as a double. Both clocks of `vrts.live.lasting.clock`
go by it, so turns and leases end, places of who is away are given up, private rooms close and
rates recover as after so many hours. Sessions have processes and clocks of their own: for them only
the time passes that passes.
"""

import mmap
import os
import struct
from pathlib import Path
from typing import Final

from vrts.live.lasting import clock

VARIABLE: Final = "VRTS_AHEAD"
_AHEAD = struct.Struct("d")


class Ahead:
    """How far a server's clock is ahead of the machine's, as who tries the server sets it."""

    def __init__(self, path: Path) -> None:
        """Begin with no difference."""
        self.path = path
        self.seconds = 0.0
        self.set(0.0)

    def set(self, seconds: float) -> None:
        """Have the server's clock so far ahead [s], from now on."""
        self.seconds = seconds
        with self.path.open("r+b" if self.path.exists() else "wb") as file:
            file.write(_AHEAD.pack(seconds))


def set_on(path: Path) -> None:
    """Have both clocks go by a file; before anything of the server is imported."""
    with path.open("rb") as file:
        known = mmap.mmap(file.fileno(), _AHEAD.size, access=mmap.ACCESS_READ)
    steady, wall = clock.steady, clock.wall

    def ahead() -> float:
        return float(_AHEAD.unpack_from(known)[0])

    clock.steady = lambda: steady() + ahead()
    clock.wall = lambda: wall() + ahead()


if __name__ == "__main__":
    set_on(Path(os.environ[VARIABLE]))
    from vrts.cli.main import main

    main()
