"""What is ordered in an editor, each in a process of its own, until it ends or is cancelled."""

import asyncio
import os
from pathlib import Path
from tempfile import TemporaryDirectory

from vrts.lsp.channel.ordered import PATIENCE_S, Done, Ordered, done_of, line_of_ordered
from vrts.lsp.server.background.own_process import OwnProcess

AT_ONCE = 2


class Orders:
    """The processes that carry out what is ordered, and the files that tell what came of it."""

    def __init__(self) -> None:
        self._going: set[OwnProcess] = set()
        self._slots = asyncio.Semaphore(AT_ONCE)
        self._folder: TemporaryDirectory[str] | None = None

    async def carry_out(self, ordered: Ordered) -> Done:
        """Return what came of an order; whoever cancels this ends its process."""
        async with self._slots:
            with OwnProcess("vrts.lsp.runs.carrying_out") as process:
                self._going.add(process)
                try:
                    async with asyncio.timeout(PATIENCE_S):
                        return done_of(await process.answer(line_of_ordered(ordered)))
                except TimeoutError:
                    return done_of(b"")
                finally:
                    self._going.discard(process)

    def written(self, ordered: Ordered, done: Done) -> Path:
        """Return a file that holds what came of an order, for as long as the server lives."""
        if self._folder is None:
            self._folder = TemporaryDirectory(prefix="vrts-orders-", ignore_cleanup_errors=True)
        stem = os.path.splitext(os.path.basename(ordered.path))[0] or "program"
        kept = "".join(c if c.isalnum() or c in "-_" else "-" for c in stem)[:60]
        file = Path(self._folder.name) / f"{kept}-{ordered.work}{'.html' if done.page else '.txt'}"
        file.write_text(done.page or done.text, "utf-8", "replace")
        return file

    def stop(self) -> None:
        """End all that goes on, and take the files away."""
        for process in self._going:
            process.kill()
        if self._folder is not None:
            self._folder.cleanup()
            self._folder = None
