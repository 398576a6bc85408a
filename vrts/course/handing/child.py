"""A process beside the server that reads tasks, and has programs marked in processes of their own.

It is told by lines of JSON, and answers each by one. It ends when its input does.
"""

import os
import sys
from pathlib import Path
from typing import Final

import msgspec

from vrts.assignments.handed.of_folder import readme_to_hand_out
from vrts.assignments.task_folder import read_folder
from vrts.assignments.variants.handed_out import tags_in
from vrts.assignments.variants.of_task import load_varied
from vrts.course.handing.public_marker import PAGE, PublicMarker
from vrts.course.handing.spoken import (
    LONGEST,
    Asked,
    MarkIt,
    PublicMark,
    TellIt,
    Words,
)
from vrts.course.variants.asked import GiveIt, Given
from vrts.course.variants.giving import Giver
from vrts.marking.submission.one import Order
from vrts.marking.supervise.outcome import Answer
from vrts.marking.supervise.staging import staging_folder
from vrts.marking.supervise.supervisor import Supervisor
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.pipeline.settings import load_task
from vrts.report.plain import capital

TITLE: Final = "program.v2"
START: Final = "start.v2"
NO_TASK: Final = "the task has a fault that only your teacher can mend: your program is kept"
LOST: Final = "your program {}: it has no public mark; your teacher can mark it by hand"
OTHER: Final = "it names the variant `{}`, and yours is `{}`: it is marked by yours"
KEPT: Final = 2  # markers


class Reader:
    """Answers, and keeps the tasks that were asked of last."""

    def __init__(self) -> None:
        """Begin with none."""
        self._markers: dict[tuple[str, int], PublicMarker] = {}
        self._giver = Giver()

    def answer(self, asked: Asked) -> PublicMark | Words | Given:
        """Return what was asked for."""
        match asked:
            case TellIt():
                return _words(Path(asked.task))
            case GiveIt():
                return self._giver.give(asked)
            case MarkIt():
                return _with_doubt(self._mark(asked), asked)

    def _mark(self, asked: MarkIt) -> PublicMark:
        try:
            marker = self._marker(Path(asked.task))
        except (CannotRead, Refused):
            return PublicMark("failed", said=NO_TASK)
        order = Order(asked.digest[:16], TITLE, asked.program)
        page = Path(asked.page)
        page.parent.mkdir(parents=True, exist_ok=True)
        with staging_folder(page.parent / ".staging") as folder:
            supervisor = Supervisor(marker, folder, limits=marker.limits)
            (finished,) = (
                _kept(one.outcome, one.folder / PAGE, page) for one in supervisor.run([order])
            )
        return finished

    def _marker(self, task: Path) -> PublicMarker:
        key = (str(task), newest(task.parent))
        if key not in self._markers:
            while len(self._markers) >= KEPT:
                del self._markers[next(iter(self._markers))]
            self._markers[key] = PublicMarker(task)
        return self._markers[key]


def _with_doubt(found: PublicMark, asked: MarkIt) -> PublicMark:
    """Return a mark that tells where a program says that it is for somebody else's variant."""
    others = [tag for tag in tags_in(asked.program) if tag != asked.variant]
    if not asked.variant or not others:
        return found
    doubt = OTHER.format(others[0], asked.variant)
    said = f"{found.said}; {doubt}" if found.said else capital(doubt)
    return msgspec.structs.replace(found, said=said)


def _kept(outcome: object, draft: Path, page: Path) -> PublicMark:
    """Return what a process answered, and move the page that it wrote."""
    if not isinstance(outcome, Answer):
        loss = getattr(outcome, "loss", None)
        why = "could not be marked" if loss is None else f"was stopped: the process {loss.value}"
        return PublicMark("failed", said=LOST.format(why))
    if draft.is_file() and not draft.is_symlink():
        draft.replace(page)
    return msgspec.json.decode(outcome.data, type=PublicMark)


def newest(folder: Path) -> int:
    """Return when something of a task was changed last [ns]."""
    times = [path.stat().st_mtime_ns for path in folder.rglob("*") if path.is_file()]
    return max(times, default=0)


def _words(task: Path) -> Words:
    folder = task.parent
    try:
        public = load_task(task, staff=False)
        readme = readme_to_hand_out(folder, public).decode()
        varied = public.task is not None and public.task.variants is not None
        files = load_varied(folder).as_written() if varied else read_folder(folder).public
        start = files.get(START, b"").decode(errors="replace")
    except (CannotRead, Refused) as problem:
        said = problem.message if isinstance(problem, CannotRead) else "its task has errors"
        return Words(problem=said)
    return Words(readme, start)


def main() -> None:
    """Answer until the input ends."""
    if hasattr(os, "nice"):
        os.nice(5)  # rooms come first
    reader = Reader()
    while line := sys.stdin.buffer.readline(LONGEST):
        answer = reader.answer(msgspec.json.decode(line, type=Asked))
        sys.stdout.buffer.write(msgspec.json.encode(answer) + b"\n")
        sys.stdout.buffer.flush()


if __name__ == "__main__":
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    main()
