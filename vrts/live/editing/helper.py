"""A language server in a process of its own: begun, told, heard, ended."""

import asyncio
import logging
import os
import signal
import sys
from collections.abc import AsyncGenerator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, Final

import vrts
from vrts.live.editing.told import Answer, answer_of, as_json

LONGEST: Final = 8 * 1024 * 1024  # bytes of a message from a language server
BEHIND: Final = 1024 * 1024  # bytes that may wait for one
LAST_WORDS: Final = 4096  # bytes of what it says when it fails
COMMAND: Final = ("-m", "vrts.live.editing.limited")

_log = logging.getLogger("vrts.live")


class Helper:
    """Owns the process. It is given no folder but an empty one, and sees no file of anybody."""

    def __init__(self, process: asyncio.subprocess.Process) -> None:
        """Take a process that has begun."""
        self._process = process
        self._errors = asyncio.get_running_loop().create_task(self._listen())

    @property
    def pid(self) -> int:
        """Number of the process."""
        return self._process.pid

    @property
    def behind(self) -> bool:
        """Whether it does not read what it is told."""
        assert self._process.stdin is not None
        return self._process.stdin.transport.get_write_buffer_size() > BEHIND

    def tell(self, message: Mapping[str, Any]) -> None:
        """Send a message of the protocol."""
        assert self._process.stdin is not None
        if not self._process.stdin.is_closing():
            data = as_json({"jsonrpc": "2.0", **message})
            self._process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(data) + data)

    async def heard(self) -> AsyncGenerator[Answer]:
        """Return its messages, until it ends or says what cannot be read."""
        assert self._process.stdout is not None
        out = self._process.stdout
        with suppress(asyncio.IncompleteReadError, asyncio.LimitOverrunError, ValueError):
            while True:
                head = await out.readuntil(b"\r\n\r\n")
                lengths = [
                    int(line.split(b":")[1])
                    for line in head.split(b"\r\n")
                    if line.lower().startswith(b"content-length:")
                ]
                if len(lengths) != 1 or not 0 < lengths[0] <= LONGEST:
                    return
                yield answer_of(await out.readexactly(lengths[0]))

    async def end(self) -> None:
        """End it at once, with all it may have begun."""
        with suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        await self._process.wait()
        await self._errors

    async def _listen(self) -> None:
        """Keep the last of what it says beside its answers, and log it when it fails."""
        assert self._process.stderr is not None
        last = b""
        while data := await self._process.stderr.read(LAST_WORDS):
            last = (last + data)[-LAST_WORDS:]
        if await self._process.wait() > 0:
            _log.warning("a language server ended: %s", last.decode("utf-8", "replace"))


async def begun(folder: Path) -> Helper:
    """Begin a language server in an empty folder."""
    process = await asyncio.create_subprocess_exec(
        sys.executable,
        *COMMAND,
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
        cwd=folder,
        env=_environment(),
        start_new_session=True,
    )
    return Helper(process)


def _environment() -> dict[str, str]:
    """Return the environment without what is not needed."""
    kept = ("PATH", "LANG", "LC_ALL", "VIRTUAL_ENV", "SYSTEMROOT")
    own = {name: os.environ[name] for name in kept if name in os.environ}
    package = str(Path(vrts.__file__).resolve().parent.parent)
    return {**own, "PYTHONPATH": package, "PYTHONUNBUFFERED": "1"}
