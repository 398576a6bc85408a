"""A process that works for one person's editor: begun in an empty folder, watched, ended."""

import asyncio
import logging
import os
import signal
import sys
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Final

import vrts

LONGEST: Final = 8 * 1024 * 1024  # bytes of a message from one
BEHIND: Final = 1024 * 1024  # bytes that may wait for one
LAST_WORDS: Final = 4096  # bytes of what it says when it fails
_KEPT: Final = ("PATH", "LANG", "LC_ALL", "VIRTUAL_ENV", "SYSTEMROOT")

_log = logging.getLogger("vrts.live")


class OwnedProcess:
    """Owns the process. It is given an empty folder, and of the environment what it needs."""

    NAME = "a process"  # as the server's log calls it

    def __init__(self, process: asyncio.subprocess.Process) -> None:
        """Take a process that has begun."""
        assert process.stdin is not None
        assert process.stdout is not None
        assert process.stderr is not None
        self._process = process
        self._in, self._out = process.stdin, process.stdout
        self._errors = asyncio.get_running_loop().create_task(self._listen(process.stderr))

    @property
    def pid(self) -> int:
        """Number of the process."""
        return self._process.pid

    @property
    def behind(self) -> bool:
        """Whether it does not read what it is told."""
        return self._in.transport.get_write_buffer_size() > BEHIND

    def write(self, data: bytes) -> None:
        """Send something, unless it hears no more."""
        if not self._in.is_closing():
            self._in.write(data)

    async def end(self) -> None:
        """End it at once, with all it may have begun; killed before anything is awaited."""
        with suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        await self._process.wait()
        await self._errors

    async def _listen(self, errors: asyncio.StreamReader) -> None:
        """Keep the last of what it says beside its answers, and log it when it fails."""
        last = b""
        while data := await errors.read(LAST_WORDS):
            last = (last + data)[-LAST_WORDS:]
        if await self._process.wait() > 0:  # killed: below 0
            _log.warning("%s ended: %s", self.NAME, last.decode("utf-8", "replace"))


async def begun(
    words: tuple[str, ...], folder: Path, environment: Mapping[str, str]
) -> asyncio.subprocess.Process:
    """Begin a process of this Python in an empty folder.

    Args:
        words: What follows the name of Python.
        folder: It is begun there.
        environment: What it is given beside what every process needs.

    Raises:
        OSError: The system has no process to give.
    """
    own = {name: os.environ[name] for name in _KEPT if name in os.environ}
    package = str(Path(vrts.__file__).resolve().parent.parent)
    return await asyncio.create_subprocess_exec(
        sys.executable,
        *words,
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
        limit=LONGEST,
        cwd=folder,
        env={**own, "PYTHONPATH": package, **environment},
        start_new_session=True,
    )
