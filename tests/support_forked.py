"""`vrts` forked from an interpreter that has loaded it, seen as asyncio shows a process."""

import asyncio
import os
import signal
from asyncio.streams import FlowControlMixin
from pathlib import Path

from tests.support_commands import Waiting


class Forked:
    """A process with pipes for its three streams: what of `asyncio.subprocess.Process` is used."""

    def __init__(
        self,
        waiting: Waiting,
        pid: int,
        stdin: asyncio.StreamWriter,
        stdout: asyncio.StreamReader,
        stderr: asyncio.StreamReader,
    ) -> None:
        """Watch a process that has begun; `begin` makes one."""
        self.pid, self.stdin, self.stdout, self.stderr = pid, stdin, stdout, stderr
        self.returncode: int | None = None
        self._waiting = waiting
        self._pipes: list[asyncio.BaseTransport] = []
        self._ended = asyncio.Event()
        self._watched = os.pidfd_open(pid)
        asyncio.get_running_loop().add_reader(self._watched, self._reap)

    @classmethod
    async def begin(cls, waiting: Waiting, *words: str) -> "Forked":
        """Begin a command in the folder of the tests."""
        given, theirs_in = os.pipe()
        theirs_out, said = os.pipe()
        theirs_err, told = os.pipe()
        pid = waiting.begin(words, Path.cwd(), os.environ, given, said, told)
        for stream in (given, said, told):
            os.close(stream)
        loop = asyncio.get_running_loop()
        pipe, protocol = await loop.connect_write_pipe(FlowControlMixin, os.fdopen(theirs_in, "wb"))
        stdin = asyncio.StreamWriter(pipe, protocol, None, loop)
        stdout, out = await _reader(theirs_out)
        stderr, err = await _reader(theirs_err)
        found = cls(waiting, pid, stdin, stdout, stderr)
        found._pipes = [pipe, out, err]
        return found

    async def wait(self) -> int:
        """Wait for the end; return the exit status."""
        await self._ended.wait()
        assert self.returncode is not None
        return self.returncode

    def send_signal(self, number: int) -> None:
        """Send a signal, unless it has ended."""
        if self.returncode is None:
            os.kill(self.pid, number)

    def kill(self) -> None:
        """Kill -9."""
        self.send_signal(signal.SIGKILL)

    def close(self) -> None:
        """Close this end of the pipes."""
        for pipe in self._pipes:
            pipe.close()

    def _reap(self) -> None:
        asyncio.get_running_loop().remove_reader(self._watched)
        os.close(self._watched)
        self.returncode = self._waiting.reap(self.pid)
        self._ended.set()


async def _reader(descriptor: int) -> tuple[asyncio.StreamReader, asyncio.BaseTransport]:
    loop = asyncio.get_running_loop()
    reader = asyncio.StreamReader()
    pipe, _ = await loop.connect_read_pipe(
        lambda: asyncio.StreamReaderProtocol(reader), os.fdopen(descriptor, "rb")
    )
    return reader, pipe
