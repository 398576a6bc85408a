"""Has programs marked by the public checks, one after another, whatever waits in the database."""

import asyncio
import logging
from contextlib import suppress
from pathlib import Path
from typing import Final

from vrts.course.beside import Beside, Died
from vrts.course.course import Assignment
from vrts.course.facts import facts_of
from vrts.course.handing.names import page_of
from vrts.course.handing.queue import Job, in_order
from vrts.course.handing.spoken import MarkIt, PublicMark
from vrts.course.handing.taking import Taking
from vrts.live.store.course.attempts import Attempt, keep_public_mark, waiting
from vrts.live.store.database import Database
from vrts.pipeline.files import CannotRead

MOST_S: Final = 1800.0  # for one program [s]; its own limits come long before
TRIES: Final = 2  # for one program, before it has no public mark
NOT_THERE: Final = "the program is not as it was handed in any more: tell your teacher"
NO_TASK: Final = "the task is not there any more: tell your teacher"
NO_VARIANT: Final = (
    "the variant that it was handed in for is not there: your program is kept, tell your teacher"
)
NOT_MARKED: Final = "it could not be marked here: your program is kept, your teacher can mark it"
_log = logging.getLogger("vrts.live")


class Marking:
    """Marks what waits; a crash of the server loses nothing of it."""

    def __init__(self, taking: Taking, database: Database, folder: Path) -> None:
        """Take hand-ins, and a folder of the server for pages and processes."""
        self._taking = taking
        self._database = database
        self._pages = folder / "pages"
        self._beside = Beside(folder / "marking")
        self._wanted = asyncio.Event()
        self._work: asyncio.Task[None] | None = None
        self.now: Job | None = None  # what is being marked

    def page(self, attempt: Attempt) -> Path:
        """Return where the page about a program is, if it is there."""
        return self._pages / attempt.assignment / page_of(attempt.digest, attempt.variant)

    def begin(self) -> None:
        """Begin to mark."""
        self._wanted.set()
        self._work = asyncio.create_task(self._go_on())

    def wake(self) -> None:
        """Look at what waits: there is more."""
        self._wanted.set()

    async def beat(self) -> None:
        """Go on after a fault, and end the process where nothing waits for long."""
        if self._work is not None and self._work.done() and not self._work.cancelled():
            _log.error("a fault in vrts, in marking", exc_info=self._work.exception())
            self.begin()
        await self._beside.rest()

    async def end(self) -> None:
        """End what goes on; it is marked after the next start."""
        if self._work is not None:
            self._work.cancel()
            with suppress(asyncio.CancelledError, Exception):
                await self._work
        await self._beside.end()

    async def _go_on(self) -> None:
        while True:
            await self._wanted.wait()
            self._wanted.clear()
            while jobs := in_order(rows := await self._database.do(waiting)):
                job = jobs[0]
                one = next(row for row in rows if (row.assignment, row.digest, row.variant) == job)
                self.now = job
                try:
                    found = await self._mark(one)
                finally:
                    self.now = None
                told = one._replace(
                    state=found.state,
                    mark=found.mark,
                    total=found.total,
                    said=found.said,
                    causes=found.losses,
                )
                await self._database.do(lambda c, told=told: keep_public_mark(c, told))

    async def _mark(self, attempt: Attempt) -> PublicMark:
        assignment = self._taking.assignment(attempt.assignment)
        if assignment is None:
            return PublicMark("failed", said=NO_TASK)
        try:
            facts = await asyncio.to_thread(facts_of, assignment)
        except CannotRead:
            return PublicMark("failed", said=NO_TASK)
        program = await self._taking.program(facts, attempt)
        if program is None:
            return PublicMark("failed", said=NOT_THERE)
        task = await self._task(assignment, attempt)
        if task is None:
            return PublicMark("failed", said=NO_VARIANT)
        page = str(self.page(attempt).resolve())
        order = MarkIt(str(task), attempt.digest, program, page, attempt.variant)
        for _ in range(TRIES):
            with suppress(Died):
                return await self._beside.ask(order, PublicMark, MOST_S)
        return PublicMark("failed", said=NOT_MARKED)

    async def _task(self, assignment: Assignment, attempt: Attempt) -> Path | None:
        """Return the file of the task that an attempt is marked by; None: it is not there.

        It is that of the variant which the student had then, as the task is now.
        """
        variants = self._taking.variants
        own = await variants.of(assignment, attempt.account)
        if own.tag == attempt.variant:
            return own.task if not own.problem else None
        task = variants.task(assignment, attempt.variant)
        return task if attempt.variant and await asyncio.to_thread(task.is_file) else None
