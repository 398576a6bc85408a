"""The process of a rehearsal, as the server sees it: begun, asked, heard, ended."""

import asyncio
import signal
from contextlib import suppress
from pathlib import Path
from typing import Final

from vrts.live.editing import owned_process
from vrts.live.editing.owned_process import OwnedProcess
from vrts.live.rehearsing.asked import PassedOn, as_json
from vrts.live.rehearsing.told import NO_MEMORY

COMMAND: Final = ("-m", "vrts.live.rehearsing.child")
TOO_LONG: Final = "the rehearsal took more computing than it may use, and was ended"
TOO_MUCH: Final = "the rehearsal needs more memory than it may use, and was ended"
DIED: Final = "the rehearsal's process ended: rehearse again"


class RehearsalProcess(OwnedProcess):
    """A process that answers in the order in which it is asked."""

    NAME = "a rehearsal"

    @property
    def alive(self) -> bool:
        """Whether it has not ended."""
        return self._process.returncode is None

    def ask(self, question: PassedOn) -> None:
        """Ask something."""
        self.write(as_json(question) + b"\n")

    async def answer(self) -> bytes | None:
        """Return its next answer; None: none comes any more."""
        try:
            return (await self._out.readuntil(b"\n"))[:-1]
        except (asyncio.IncompleteReadError, asyncio.LimitOverrunError):
            return None

    async def why(self) -> str:
        """Let it end by itself, or end it; return in a sentence why it answers no more."""
        self._in.close()
        with suppress(TimeoutError):
            await asyncio.wait_for(self._process.wait(), 0.5)
        await self.end()
        status = self._process.returncode
        if status == -signal.SIGXCPU:
            return TOO_LONG
        return TOO_MUCH if status == NO_MEMORY else DIED


async def begun(folder: Path, *, warm: bool = False) -> RehearsalProcess:
    """Begin a process in an empty folder; numbers are crunched by one thread.

    Args:
        folder: It is begun there.
        warm: It has time to prepare, so that its first answer comes sooner.

    Raises:
        OSError: The system has no process to give.
    """
    words = (*COMMAND, "warm") if warm else COMMAND
    environment = {"OPENBLAS_NUM_THREADS": "1"}
    return RehearsalProcess(await owned_process.begun(words, folder, environment))
