"""The process of a session that the nursery has forked, as asyncio shows one of its own."""

import asyncio
import os
import signal
from contextlib import suppress


class Forked:
    """Owns the process, though another one is its parent."""

    def __init__(self, pid: int, ends: int) -> None:
        """Take its number, and its pidfd, which is ours from now on."""
        self.pid = pid
        self.returncode: int | None = None  # None: it runs, or nobody can tell how it ended
        self.stdin: asyncio.StreamWriter | None = None
        self.stdout: asyncio.StreamReader | None = None
        self._ends = ends
        self._loop = asyncio.get_running_loop()
        self._ended = asyncio.Event()
        self._watched = False

    async def connect(self, ask: int, told: int) -> None:
        """Take the pipes to and from it."""
        writing = asyncio.streams.FlowControlMixin(self._loop)
        to, _ = await self._loop.connect_write_pipe(lambda: writing, os.fdopen(ask, "wb", 0))
        self.stdin = asyncio.StreamWriter(to, writing, None, self._loop)
        reader = asyncio.StreamReader(loop=self._loop)
        await self._loop.connect_read_pipe(
            lambda: asyncio.StreamReaderProtocol(reader, loop=self._loop),
            os.fdopen(told, "rb", 0),
        )
        self.stdout = reader

    def kill(self) -> None:
        """End it at once."""
        if not self._ended.is_set():
            with suppress(ProcessLookupError):  # it has ended, which is not known yet
                signal.pidfd_send_signal(self._ends, signal.SIGKILL)

    async def wait(self) -> int | None:
        """Wait until it has ended; return its status, if that is known."""
        await self._ended.wait()
        return self.returncode

    def has_ended(self, status: int | None) -> None:
        """Take note that it has ended."""
        if self._ended.is_set():
            return
        self.returncode = status
        self._ended.set()
        if self._watched:
            self._loop.remove_reader(self._ends)
        os.close(self._ends)

    def watch(self) -> None:
        """Find out without its parent when it ends."""
        if not self._ended.is_set() and not self._watched:
            self._watched = True
            self._loop.add_reader(self._ends, self.has_ended, None)
