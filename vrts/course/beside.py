"""The processes beside the server that read tasks: begun when one is needed, ended when idle."""

import asyncio
from contextlib import suppress
from pathlib import Path
from typing import Final, TypeVar

import msgspec

from vrts.live.editing import owned_process
from vrts.live.editing.owned_process import OwnedProcess
from vrts.live.lasting.clock import steady

COMMAND: Final = ("-m", "vrts.course.handing.child")
IDLE_S: Final = 300.0  # after which a process ends

Answer = TypeVar("Answer")


class Died(Exception):  # noqa: N818 -- names the situation
    """The process ended before it answered."""


class _Process(OwnedProcess):
    NAME = "marking of a course"

    async def answer(self) -> bytes:
        try:
            return (await self._out.readuntil(b"\n"))[:-1]
        except (asyncio.IncompleteReadError, asyncio.LimitOverrunError) as problem:
            raise Died from problem


class Beside:
    """One such process at a time, asked one thing at a time."""

    def __init__(self, folder: Path) -> None:
        """Take a folder of our own, which stays empty; nothing is begun yet."""
        self._folder = folder
        self._process: _Process | None = None
        self._asking = asyncio.Lock()
        self._used = 0.0

    async def ask(self, asked: msgspec.Struct, kind: type[Answer], most_s: float) -> Answer:
        """Return an answer.

        Args:
            asked: What is wanted.
            kind: Of the answer.
            most_s: How long it may take [s].

        Raises:
            Died: There is none: the process has ended, or took too long, and was ended.
        """
        async with self._asking:
            try:
                if self._process is None:
                    self._process = await self._begun()
                self._process.write(msgspec.json.encode(asked) + b"\n")
                async with asyncio.timeout(most_s):
                    line = await self._process.answer()
                self._used = steady()
                return msgspec.json.decode(line, type=kind)
            except (Died, TimeoutError, OSError, msgspec.DecodeError) as problem:
                await self._end()
                raise Died from problem
            except asyncio.CancelledError:
                await self._end()
                raise

    async def rest(self) -> None:
        """End the process where nobody has asked for a while."""
        idle = self._process is not None and not self._asking.locked()
        if idle and steady() - self._used > IDLE_S:
            await self._end()

    async def end(self) -> None:
        """End it, whatever it does."""
        await self._end()

    async def _begun(self) -> _Process:
        await asyncio.to_thread(self._folder.mkdir, mode=0o700, parents=True, exist_ok=True)
        return _Process(
            await owned_process.begun(COMMAND, self._folder, {"OPENBLAS_NUM_THREADS": "1"})
        )

    async def _end(self) -> None:
        process, self._process = self._process, None
        if process is not None:
            with suppress(ProcessLookupError):
                await process.end()
