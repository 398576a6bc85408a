"""What the machine and the server's processes use, as Linux tells it; zero where it does not."""

import os
import shutil
import time
from pathlib import Path
from typing import NamedTuple

_PAGE = 4096 if not hasattr(os, "sysconf") else os.sysconf("SC_PAGE_SIZE")


class Load(NamedTuple):
    """What is used now."""

    processors: int
    load: float  # processes that want a processor, in the last minute on average
    own_share: float  # of one processor, of the server itself since it was asked before
    memory: int  # bytes that the machine has
    memory_free: int  # bytes
    server: int  # bytes of the server's process
    sessions: int  # bytes of its sessions' processes, shared ones counted in each
    disk_free: int  # bytes, where the folder is


class Machine:
    """Looks at the machine."""

    def __init__(self, folder: Path) -> None:
        """Look at the disk of a folder as well."""
        self._folder = folder
        self._before = (time.monotonic(), time.process_time())

    def load(self) -> Load:
        """Return what is used now; a few small files are read."""
        now, used = time.monotonic(), time.process_time()
        (then, before), self._before = self._before, (now, used)
        memory = _memory()
        return Load(
            processors=os.cpu_count() or 1,
            load=round(os.getloadavg()[0], 2),
            own_share=round((used - before) / max(now - then, 1e-3), 3),
            memory=memory.get("MemTotal", 0),
            memory_free=memory.get("MemAvailable", 0),
            server=_resident(os.getpid()),
            sessions=sum(map(_resident, _children(os.getpid()))),
            disk_free=shutil.disk_usage(self._folder).free,
        )


def _memory() -> dict[str, int]:
    """Return the rows of /proc/meminfo [bytes]."""
    rows = (line.split() for line in _read(Path("/proc/meminfo")).splitlines())
    return {row[0].rstrip(":"): int(row[1]) * 1024 for row in rows if len(row) == 3}


def _resident(process: int) -> int:
    """Return the memory of a process; 0 when it has ended meanwhile [bytes]."""
    words = _read(Path(f"/proc/{process}/statm")).split()
    return int(words[1]) * _PAGE if len(words) > 1 else 0


def _children(process: int) -> list[int]:
    found: list[int] = []
    for task in Path(f"/proc/{process}/task").glob("*/children"):
        found += map(int, _read(task).split())
    return found


def _read(file: Path) -> str:
    try:
        return file.read_text("ascii")
    except OSError:  # another system, or the process has ended
        return ""
