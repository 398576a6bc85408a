"""What students get of a task, in words: read by a process beside the server, and kept."""

import asyncio
from pathlib import Path
from typing import Final, NamedTuple

from vrts.course.course import Assignment
from vrts.course.handing.beside import Beside, Died
from vrts.course.handing.spoken import TellIt, Words
from vrts.course.handing.words import Block, blocks_of
from vrts.pipeline.files import TASK_FILE

MOST_S: Final = 60.0  # for one task [s]
MOST_FILES: Final = 1000  # of a task, whose times are looked at
NOT_READ: Final = "the task cannot be read now: tell your teacher"


class Text(NamedTuple):
    """What students get."""

    blocks: tuple[Block, ...] = ()
    start: str = ""  # the program to begin with
    problem: str = ""


class Telling:
    """Knows the words of each task, and reads them again when it was changed."""

    def __init__(self, folder: Path) -> None:
        """Take a folder of the server for the process."""
        self._beside = Beside(folder)
        self._known: dict[str, tuple[int, Text]] = {}

    async def text(self, assignment: Assignment) -> Text:
        """Return what students get of an assignment."""
        stamp = await asyncio.to_thread(_stamp, assignment.task)
        known = self._known.get(assignment.id)
        if known is not None and known[0] == stamp:
            return known[1]
        asked = TellIt(str((assignment.task / TASK_FILE).resolve()))
        try:
            words = await self._beside.ask(asked, Words, MOST_S)
        except Died:
            return Text(problem=NOT_READ)
        blocks = await asyncio.to_thread(blocks_of, words.readme)
        text = Text(blocks, words.start, words.problem)
        self._known[assignment.id] = (stamp, text)
        return text

    async def beat(self) -> None:
        """End the process where nobody asks."""
        await self._beside.rest()

    async def end(self) -> None:
        """End the process."""
        await self._beside.end()


def _stamp(folder: Path) -> int:
    """Return what is another number when a file of a task was changed, or there is another one."""
    times: list[int] = []
    for path in folder.rglob("*"):
        if path.is_file():
            times.append(path.stat().st_mtime_ns)
        if len(times) >= MOST_FILES:
            break
    return hash((max(times, default=0), len(times)))
