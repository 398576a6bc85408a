"""Searches for a change that earns the full mark, each in a process of its own, when asked for."""

import asyncio
import subprocess
import sys

from vrts.lsp.channel.mend import NOTHING, Mend, mend_of
from vrts.lsp.channel.verification import Asked
from vrts.lsp.server.background.verifying import ask

PATIENCE_S = 120.0  # for a search, whatever it does


class Mending:
    """The processes that look for changes."""

    def __init__(self) -> None:
        self._going: set[subprocess.Popen[bytes]] = set()

    async def mend(self, asked: Asked) -> Mend:
        """Return what was found for a text; nothing where the search did not come to its end."""
        process = subprocess.Popen(
            (sys.executable, "-m", "vrts.lsp.runs.mending"),
            stdin=subprocess.PIPE,  # stays open: where it ends, so does the process
            stdout=subprocess.PIPE,
        )
        assert process.stdout is not None
        self._going.add(process)
        try:
            async with asyncio.timeout(PATIENCE_S):
                await asyncio.to_thread(ask, process, asked)
                return mend_of(await asyncio.to_thread(process.stdout.readline))
        except TimeoutError:
            return NOTHING
        finally:
            self._going.discard(process)
            process.kill()  # unless it has ended
            process.communicate()  # closes its pipes, and waits

    def stop(self) -> None:
        """End all searches."""
        for process in self._going:
            process.kill()
