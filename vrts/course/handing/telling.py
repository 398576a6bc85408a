"""What students get of a task, in words: read by a process beside the server, and kept."""

import asyncio
from pathlib import Path
from typing import Final, NamedTuple

from vrts.course.beside import Beside, Died
from vrts.course.handing.spoken import TellIt, Words
from vrts.course.handing.words import Block, blocks_of
from vrts.course.variants.task_stamp import task_stamp

MOST_S: Final = 60.0  # for one task [s]
KEPT: Final = 64  # tasks and variants whose words are kept
NOT_READ: Final = "the task cannot be read now: tell your teacher"


class Text(NamedTuple):
    """What students get."""

    blocks: tuple[Block, ...] = ()
    start: str = ""  # the program to begin with
    problem: str = ""


class Telling:
    """Knows the words of tasks that were asked of last, and reads them again after a change."""

    def __init__(self, beside: Beside) -> None:
        """Take the process that reads tasks."""
        self._beside = beside
        self._known: dict[Path, tuple[int, Text]] = {}

    async def text(self, task: Path) -> Text:
        """Return what students get of a task, by its file."""
        stamp = await asyncio.to_thread(task_stamp, task.parent)
        known = self._known.get(task)
        if known is not None and known[0] == stamp:
            return known[1]
        asked = TellIt(str(task))
        try:
            words = await self._beside.ask(asked, Words, MOST_S)
        except Died:
            return Text(problem=NOT_READ)
        blocks = await asyncio.to_thread(blocks_of, words.readme)
        text = Text(blocks, words.start, words.problem)
        self._known.pop(task, None)
        while len(self._known) >= KEPT:
            del self._known[next(iter(self._known))]
        self._known[task] = (stamp, text)
        return text

    async def beat(self) -> None:
        """End the process where nobody asks."""
        await self._beside.rest()

    async def end(self) -> None:
        """End the process."""
        await self._beside.end()
