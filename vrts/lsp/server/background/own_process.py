"""A process of ours beside the server: asked one thing in a line, it answers in lines."""

import asyncio
import subprocess
import sys
from collections.abc import AsyncIterator
from contextlib import suppress
from types import TracebackType
from typing import Self


class OwnProcess:
    """Runs a module until it has answered, or until nobody wants the answer.

    Used as a context: leaving it ends the process. Its own end of the pipe tells it the same, so it
    never outlives the server. It is no process of asyncio: whoever cancels the start of such a one
    may wait for ever.
    """

    def __init__(self, module: str) -> None:
        """Begin the process.

        Args:
            module: Full name of what it runs.

        Raises:
            OSError: The system begins no process.
        """
        self._process = subprocess.Popen(  # noqa: S603 -- our own module
            (sys.executable, "-m", module), stdin=subprocess.PIPE, stdout=subprocess.PIPE
        )

    def __enter__(self) -> Self:
        """Return itself."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        problem: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """End the process, unless it has ended."""
        self.kill()
        self._process.communicate()  # closes its pipes, and waits

    @property
    def status(self) -> int | None:
        """Its exit status, negative after a signal; None while it runs."""
        return self._process.returncode

    def kill(self) -> None:
        """End it; whoever waits for a line gets an empty one."""
        self._process.kill()

    async def answer(self, line: bytes) -> bytes:
        """Ask; return the first line of the answer, empty where there is none."""
        await self._ask(line)
        return await self._line()

    async def answers(self, line: bytes) -> AsyncIterator[bytes]:
        """Ask; yield each line of the answer, and wait until the process has ended."""
        await self._ask(line)
        while said := await self._line():
            yield said
        await asyncio.to_thread(self._process.wait)

    async def _ask(self, line: bytes) -> None:
        await asyncio.to_thread(self._write, line)  # its pipe may be full

    def _write(self, line: bytes) -> None:
        assert self._process.stdin is not None
        with suppress(BrokenPipeError):  # its answers have ended then too
            self._process.stdin.write(line)
            self._process.stdin.flush()

    async def _line(self) -> bytes:
        assert self._process.stdout is not None
        return await asyncio.to_thread(self._process.stdout.readline)
