"""Records of the logs, written in the order in which they came, however long the disk is full.

What cannot be written now is kept and tried again; who waits for it is told at once that it was not
written, so nothing is acknowledged that is not on the disk. Only so much waits. What comes then is
lost and counted, first what tells nothing of what was done. Commands are refused meanwhile, but for
stops, and a stop after another changes nothing.
"""

import asyncio
import logging
import sqlite3
from collections import deque
from collections.abc import Callable, Coroutine
from itertools import islice
from typing import Any, Final

from vrts.live.store.database import Connection, Database
from vrts.live.store.log import Entry, append_now

NO_ROOM: Final = sqlite3.OperationalError  # of the disk, which may have room again later
RETRY_S: Final = 1.0
MOST_WAITING: Final = 10_000  # records after which those that are not needed do not wait
MOST: Final = 20_000  # records that wait
FULL: Final = "too many records wait to be written"
_TOGETHER: Final = 200  # records of one commit
_log = logging.getLogger("vrts.live")
_Waiting = tuple[Entry, "asyncio.Future[None]"]


class Journal:
    """Writes; everything of it happens in the event loop's thread."""

    def __init__(
        self,
        database: Database,
        spawn: Callable[[Coroutine[Any, Any, None]], None],
        changed: Callable[[str], None],
    ) -> None:
        """Take what writes, what begins tasks, and who is told of `problem` when it changes."""
        self.problem = ""  # why nothing can be written now; empty: it can
        self.lost = 0  # records, until that is told
        self._database = database
        self._spawn = spawn
        self._changed = changed
        self._waiting: deque[_Waiting] = deque()
        self._writing = False
        self._put = self._written = 0
        self._progress = asyncio.Event()

    def put(self, entry: Entry, *, needed: bool = True) -> "asyncio.Future[None]":
        """Have a record written; the future is fulfilled after the commit, or fails at once.

        Args:
            entry: The record.
            needed: Whether it tells what was done, such as a command.
        """
        future: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        future.add_done_callback(_looked_at)
        if len(self._waiting) >= (MOST if needed else MOST_WAITING):
            self.lost += 1
            future.set_exception(NO_ROOM(FULL))
            return future
        self._waiting.append((entry, future))
        self._put += 1
        if self.problem:
            future.set_exception(NO_ROOM(self.problem))
        if not self._writing:
            self._writing = True
            self._spawn(self._write())
        return future

    async def settled(self) -> None:
        """Wait until all that was put so far is written, however long that takes."""
        until = self._put
        while self._written < until:
            await self._progress.wait()

    async def _write(self) -> None:
        try:
            while self._waiting:
                together = list(islice(self._waiting, _TOGETHER))
                try:
                    count = await self._do(together)
                except NO_ROOM as problem:
                    _fail(together, problem)
                    self._tell(str(problem))
                    await asyncio.sleep(RETRY_S)
                else:
                    self._take_off(count)
                    self._tell("")
        finally:
            self._writing = False
            if self._waiting:
                _log.warning(f"records that could not be written: {len(self._waiting)}")

    async def _do(self, together: list[_Waiting]) -> int:
        """Write records; return with how many of them, from the front, nothing is left to do."""
        try:
            await self._database.do(lambda connection: _append(connection, together))
        except NO_ROOM:
            raise
        except Exception as fault:
            if len(together) > 1:  # find out which
                return await self._do(together[:1])
            _log.exception("a record of a log cannot be written")
            _fail(together, fault)
        return len(together)

    def _take_off(self, count: int) -> None:
        for _ in range(count):
            _, future = self._waiting.popleft()
            if not future.done():
                future.set_result(None)
        self._written += count
        self._progress.set()
        self._progress = asyncio.Event()

    def _tell(self, problem: str) -> None:
        all_written = not self._waiting and not problem
        if bool(problem) == bool(self.problem) and not (self.lost and all_written):
            return
        self.problem = problem
        _log.warning(f"the disk: {problem}" if problem else "the disk: there is room again")
        if self.lost and not problem:
            _log.warning(f"records that were lost meanwhile: {self.lost}")
        self._changed(problem)
        if not problem:
            self.lost = 0


def _append(connection: Connection, together: list[_Waiting]) -> None:
    for entry, _ in together:
        append_now(connection, entry)


def _fail(together: list[_Waiting], problem: Exception) -> None:
    for _, future in together:
        if not future.done():
            future.set_exception(problem)


def _looked_at(future: "asyncio.Future[None]") -> None:
    """Have nobody warned of a failure that nobody waits for: it is tried again."""
    if not future.cancelled():
        future.exception()
