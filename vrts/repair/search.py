"""The search: candidates executed cheapest first, until good ones stand out."""

import gc
from collections.abc import Generator
from contextlib import contextmanager
from heapq import heapify, heappop, heappush
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.check.judgement import Judgement
from vrts.check.mark.grade import Grade
from vrts.engine.run import Run
from vrts.lang.dialect import VAL2
from vrts.repair.blame.blame import Blame, blame
from vrts.repair.edit import Candidate, changed
from vrts.repair.ranking import Repair, ranked
from vrts.repair.table.asked import Asked
from vrts.repair.table.table import candidates
from vrts.repair.trying.trial import Place, Stage, Tried, tried
from vrts.repair.written import read

FRUITLESS = 0.08  # how much dearer a group gets with each of it that comes to nothing


class Budget(NamedTuple):
    """How much is executed at most."""

    executions: int = 400
    band: float = 0.5  # how much dearer than the first good candidate others are looked at
    more: int = 20  # executions after the first good candidate


class Search(NamedTuple):
    """What was found."""

    repairs: tuple[Repair, ...]  # best first
    executions: int
    blame: Blame


@contextmanager
def settled() -> Generator[None]:
    """Let the collector leave alone what is there already: its full passes cost more than runs."""
    gc.freeze()
    try:
        yield
    finally:
        gc.unfreeze()


@settled()
def search(
    place: Place, source: SourceFile, run: Run, judgement: Judgement, grade: Grade, budget: Budget
) -> Search:
    """Return changes of a program that earn the full mark."""
    dialect = place.options.dialect or VAL2
    written = read(source, dialect)
    blamed = blame(run, place.task, judgement, grade)
    asked = Asked(written, place.scene, place.task, blamed)
    found: list[Repair] = []
    base = tried(place, source.text).gained
    queue = _Queue(candidates(asked))
    seen = {_code(source.text)}
    count, left = 0, budget.executions
    while count < left:
        candidate = queue.next()
        if candidate is None or (found and candidate.cost > found[0].cost + budget.band):
            break
        text = changed(source.text, candidate.change.edits)
        code = _code(text)
        if code in seen:
            continue
        seen.add(code)
        result = tried(place, text)
        if result.stage is Stage.COMPILES_NOT:
            continue
        count += 1
        if result.stage is Stage.FULL:
            if not found:
                left = min(left, count + budget.more)
            found.append(_repair(candidate, text, result, blamed))
        else:
            queue.failed(candidate, better=result.gained > base)
    return Search(ranked(found), count, blamed)


class _Queue:
    """Candidates, cheapest first; those of a group get dearer when others of it come to nothing."""

    def __init__(self, candidates: list[Candidate]) -> None:
        self._heap = [(c.cost, n, c) for n, c in enumerate(candidates)]
        heapify(self._heap)
        self._dearer: dict[tuple[str, int], float] = {}

    def next(self) -> Candidate | None:
        while self._heap:
            cost, n, candidate = heappop(self._heap)
            now = candidate.cost + self._dearer.get(candidate.group, 0.0)
            if now > cost + 1e-9:
                heappush(self._heap, (now, n, candidate))
                continue
            return candidate
        return None

    def failed(self, candidate: Candidate, *, better: bool) -> None:
        before = self._dearer.get(candidate.group, 0.0)
        self._dearer[candidate.group] = before + (-0.1 if better else FRUITLESS)


def _repair(candidate: Candidate, text: str, result: Tried, blamed: Blame) -> Repair:
    assert result.mark is not None
    weight = blamed.weight(candidate.change.line)
    return Repair(candidate.change, candidate.cost, text, result.mark, weight)


def _code(text: str) -> str:
    """Return a program without what changes nothing: layout."""
    return "\n".join(" ".join(line.split()) for line in text.splitlines() if line.strip())
