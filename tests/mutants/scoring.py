"""How well mutants are mended: found, no larger than the mistake, at its line, and how quickly.

`python -m tests.mutants score FILE` tries those that FILE has no row of yet, one after another, and
appends a row of JSON each; so it can be stopped and started again. Then it prints the table.
"""

import json
import time
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from pathlib import Path
from random import Random
from statistics import median
from typing import NamedTuple

from tests.mutants.given import Mutant
from tests.mutants.measure import size
from tests.mutants.reading import read
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.mending.behaviour import mended
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import load_task
from vrts.repair.ranking import standing_out

SHUFFLED = 19  # the seed of the order in which mutants are tried


class Scored(NamedTuple):
    """What became of a mutant."""

    id: str
    original: str
    kinds: tuple[str, ...]
    size: int  # of the mistake
    found: bool  # a change earns the full mark
    edit: int  # size of the first of them, 0 where there is none
    blamed: bool  # it blames a line of a mistake
    told: bool  # it stands out: the change itself is told
    executions: int
    cpu_s: float  # processor time of all that a user waits for, the first verification included
    line: int  # that it blames
    does: str  # what it does, in words

    @property
    def minimal(self) -> bool:
        """Whether the full mark is earned by an edit not larger than the mistake."""
        return self.found and self.edit <= self.size


def score(mutants: Sequence[Mutant], file: Path, most: int | None = None) -> list[Scored]:
    """Try those mutants that a file has no row of, and return what became of all of them.

    Args:
        mutants: The mutants.
        file: Where a row is appended for each.
        most: How many are tried at most; None: all.
    """
    done = scored(file)
    waiting = [mutant for mutant in mutants if mutant.id not in done]
    Random(SHUFFLED).shuffle(waiting)
    with file.open("a", encoding="utf-8") as rows:
        for mutant in waiting[:most]:
            row = _scored(mutant)
            rows.write(json.dumps(row._asdict()) + "\n")
            rows.flush()
            done[mutant.id] = row
    return [done[mutant.id] for mutant in mutants if mutant.id in done]


def scored(file: Path) -> dict[str, Scored]:
    """Return the rows of a file by the mutants' names; none if there is no file."""
    if not file.exists():
        return {}
    lines = file.read_text(encoding="utf-8").splitlines()
    found = [Scored(**json.loads(line)) for line in lines]
    return {row.id: row._replace(kinds=tuple(row.kinds)) for row in found}


def lines_of(mutant: Mutant) -> frozenset[int]:
    """Return the lines of a mutant where its mistakes are.

    Beside a step that is missing both lines count, of a row that is missing all of its section:
    rows have no order.
    """
    rows = sorted(row.line for row in read(mutant.text).rows)
    found: set[int] = set()
    moved = 0
    for line, before, after in sorted(mutant.edits):
        first = line + moved
        found.update(range(first, first + len(after)))
        if len(after) < len(before):
            found.update((first + len(after) - 1, first + len(after)))
            if rows and rows[0] <= first <= rows[-1] + 1:
                found.update((*rows, rows[-1] + 1))
        moved += len(after) - len(before)
    return frozenset(found)


def scores(rows: Sequence[Scored]) -> str:
    """Return the table of what became of mutants with one mistake and with two, by kind."""
    one = [row for row in rows if len(row.kinds) == 1]
    two = [row for row in rows if len(row.kinds) > 1]
    head = f"{'':24}{'of':>5}{'found':>7}{'small':>7}{'line':>7}{'told':>7}"
    lines = [f"{head}{'median s':>10}{'95 % s':>8}{'runs':>6}"]
    lines += _by("one mistake", one, lambda row: row.kinds[0])
    lines += _by("two mistakes", two, lambda row: row.original)
    lines.append(
        "found: a change earns the full mark; small: the first is no larger than the mistake;"
    )
    lines.append("line: the first blames its line, of those found; told: it stands out")
    return "\n".join(lines)


def _by(title: str, rows: Sequence[Scored], of: Callable[[Scored], str]) -> list[str]:
    if not rows:
        return []
    names = sorted({of(row) for row in rows})
    kinds = [_line(f"  {name}", [row for row in rows if of(row) == name]) for name in names]
    originals = sorted({row.original for row in rows})
    tasks = [
        _line(f"  in {name}", [row for row in rows if row.original == name]) for name in originals
    ]
    return [_line(title, rows), *kinds, *(tasks if originals != names else ())]


def _line(title: str, rows: Sequence[Scored]) -> str:
    found = [row for row in rows if row.found]
    shares = (
        _share(found, rows),
        _share([row for row in rows if row.minimal], rows),
        _share([row for row in found if row.blamed], found),
        _share([row for row in found if row.told], found),
    )
    times = sorted(row.cpu_s for row in rows)
    late = times[min(len(times) - 1, int(0.95 * len(times)))]
    runs = median(row.executions for row in rows)
    cells = "".join(f"{share:>7}" for share in shares)
    return f"{title:24}{len(rows):5}{cells}{median(times):10.2f}{late:8.2f}{runs:6.0f}"


def _share(some: Iterable[Scored], of: Sequence[Scored]) -> str:
    return f"{100 * sum(1 for _ in some) / len(of):.1f}" if of else "-"


def _scored(mutant: Mutant) -> Scored:
    request = Request(ProgramFile(mutant.text.encode(), "program.v2"), _setting(mutant.task))
    began = time.process_time()
    found = mended(request)
    took = time.process_time() - began
    best = found.repairs[0] if found.repairs else None
    return Scored(
        mutant.id,
        mutant.original.name,
        mutant.kinds,
        mutant.size,
        best is not None,
        0 if best is None else size(mutant.text, best.text),
        best is not None and best.change.line in lines_of(mutant),
        standing_out(found.repairs) is not None,
        found.executions,
        round(took, 3),
        0 if best is None else best.change.line,
        "" if best is None else f"{best.change.does.value}: {best.change.old} -> {best.change.new}",
    )


@cache
def _setting(task: Path) -> Setting:
    return load_task(task)
