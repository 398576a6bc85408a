"""Searches for a change that earns the full mark, each in a process of its own, when asked for."""

import asyncio

from vrts.lsp.channel.mend import NOTHING, Mend, mend_of
from vrts.lsp.channel.verification import Asked, line_of
from vrts.lsp.server.background.own_process import OwnProcess

PATIENCE_S = 120.0  # for a search, whatever it does


class Mending:
    """The processes that look for changes."""

    def __init__(self) -> None:
        self._going: set[OwnProcess] = set()

    async def mend(self, asked: Asked) -> Mend:
        """Return what was found for a text; nothing where the search did not come to its end."""
        with OwnProcess("vrts.lsp.runs.mending") as process:
            self._going.add(process)
            try:
                async with asyncio.timeout(PATIENCE_S):
                    return mend_of(await process.answer(line_of(asked)))
            except TimeoutError:
                return NOTHING
            finally:
                self._going.discard(process)

    def stop(self) -> None:
        """End all searches."""
        for process in self._going:
            process.kill()
