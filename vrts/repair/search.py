"""The search: candidates executed cheapest first, until good ones stand out."""

import gc
import math
from collections.abc import Callable, Generator
from contextlib import contextmanager
from fractions import Fraction
from heapq import heapify, heappop, heappush
from typing import NamedTuple

from vrts.base.remembered import Memory
from vrts.base.source import SourceFile
from vrts.check.judgement import Judgement
from vrts.check.mark.grade import Grade
from vrts.engine.run import Run
from vrts.lang.dialect import VAL2
from vrts.repair.blame.blame import Blame, blame
from vrts.repair.edit import Candidate, both, changed, changed_lines
from vrts.repair.ranking import Repair, keeps_time, ranked
from vrts.repair.surely import surely
from vrts.repair.table.asked import Asked
from vrts.repair.table.habits import odder
from vrts.repair.table.rows import slipped_rows
from vrts.repair.table.table import candidates
from vrts.repair.trying.lost import first_loss
from vrts.repair.trying.touched import known_touches
from vrts.repair.trying.trial import NOWHERE, Place, Stage, Tried, shared, tried, verified_text
from vrts.repair.written import read

DOUBTED = 0.25  # of a repair against which a teacher says so much others are looked for longer
BESIDE_IT = 1.0  # and against it that a program is too slow, and no speed or pause is changed
UNUSED = 0.3  # what a teacher says against it that locations stay that nothing names
UNMENDED = 0.35  # and that a location stays that is nearly as the scene says, but for a slip
MOST_SURE = 2  # slips that are mended first, before two changes are looked for
MOST_JUDGED = 3  # changes that come farthest, to tell which earns most
FARTHER = 0.0015  # more than a line that a step more adds to those that move something
FRUITLESS = 0.08  # how much dearer a group gets with each of it that comes to nothing


class Budget(NamedTuple):
    """How much is executed at most."""

    executions: int = 700  # in all
    one: int = 400  # for one change
    band: float = 0.5  # how much dearer than the first good candidate others are looked at
    more: int = 30  # executions after the first good candidate
    alone: int = 200  # for one change, before changes that help are taken for the first of two
    helpers: int = 5  # changes that help at most, at a time
    others: int = 2  # that are looked at after the first that is one of two good changes
    again: int = 50  # of those given up early that are executed to their end, to find helpers
    second: int = 100  # for the second change beside each of them


class Search(NamedTuple):
    """What was found."""

    repairs: tuple[Repair, ...]  # best first
    executions: int
    blame: Blame
    better: Repair | None = None  # where nothing earns the full mark: what earns most


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
    place: Place,
    source: SourceFile,
    run: Run,
    judgement: Judgement,
    grade: Grade,
    budget: Budget,
    only: Callable[[Candidate], bool] | None = None,
    hear: Callable[[], None] = lambda: None,
) -> Search:
    """Return changes of a program that earn the full mark: one at a time, else two.

    `only` says which changes are asked about: of these none are joined to two. What `hear` raises
    ends the search; it is called before each change that is tried.
    """
    memory = Memory()
    level = _Level(place, source, (run, judgement, grade), memory, budget, only, hear)
    level.go(min(budget.alone, budget.executions))
    count = 0
    good = 0  # helpers looked at since one was good, that one too
    two: list[Repair] = []
    for most in (budget.one, 0) if only is None else ():
        helpers = [] if level.found else level.helping(budget.helpers, budget.again)
        if most and not level.found:
            helpers = [*level.surely(), *helpers]
        for n, helper in enumerate(helpers):
            left = budget.executions - level.count - count
            if left <= 0 or good > budget.others:
                break
            second = _Level(place, *_next(place, source, helper), memory, budget, None, hear)
            second.go(min(budget.second * (1 if n else 2), left))
            count += second.count
            two += _together(source, helper, second.found)
            good += bool(two)
        if two or level.found:
            break
        level.go(min(most, budget.executions - count))
    found = _verified(place, ranked(level.found or two))
    better = None if found else level.better(grade.mark)
    return Search(found, level.count + count, level.blamed, better)


def _verified(place: Place, found: tuple[Repair, ...]) -> tuple[Repair, ...]:
    """Return ranked changes from the first on that the usual run and checks confirm."""
    for n, repair in enumerate(found):
        if verified_text(place, repair.text).stage is Stage.FULL:
            return found[n:]
    return ()


class _Helper(NamedTuple):
    """A change that does not earn the full mark, but comes farther."""

    candidate: Candidate
    text: str
    result: Tried


NOT_TRIED = Tried(Stage.STOPS)


class _Level:
    """One change looked for in a program, as long as somebody wants."""

    def __init__(
        self,
        place: Place,
        source: SourceFile,
        judged: tuple[Run, Judgement, Grade],
        memory: Memory,
        budget: Budget,
        only: Callable[[Candidate], bool] | None,
        hear: Callable[[], None],
    ) -> None:
        self._hear = hear
        self.place, self.source, self.memory, self.budget = place, source, memory, budget
        dialect = place.options.dialect or VAL2
        written = read(source, dialect)
        run, judgement, grade = judged
        self.blamed = blame(run, place.task, judgement, grade)
        self._asked = Asked(written, place.scene, place.task, self.blamed, dialect)
        self._queue = _Queue([c for c in candidates(self._asked) if only is None or only(c)])
        self._base = tried(place, source.text, memory).come
        self._shared = shared(place, source.text, memory)
        self._touches = known_touches(run, judgement.collisions)
        self._loss = first_loss(run, self._touches)
        self._seen = {_code(source.text)}
        self._helpers: list[_Helper] = []
        self._given_up: list[tuple[Candidate, str]] = []  # for they lose the same first
        self._tried: set[tuple[float, int]] = set()  # how far those came, and their lines
        self.found: list[Repair] = []
        self.count = 0  # executions

    def go(self, most: int) -> None:
        """Look until a number of executions is reached, or good changes stand out."""
        left, enough = most, math.inf
        while self.count < left:
            self._hear()
            candidate = self._queue.next()
            if candidate is None or candidate.cost > enough:
                break
            text = changed(self.source.text, candidate.change.edits)
            code = _code(text)
            if code in self._seen:
                continue
            self._seen.add(code)
            result = tried(self.place, text, self.memory, self._touches, self._shared, self._loss)
            if result.stage is Stage.COMPILES_NOT:
                continue
            self.count += 1
            if result.stage is Stage.FULL:
                repair = _repair(candidate, text, result, self._asked)
                doubted = repair.against - repair.cost >= DOUBTED
                if not doubted or not self.found:
                    more = self.budget.more * (3 if doubted else 1)
                    left = min(left, self.count + more) if not doubted else self.count + more
                enough = min(enough, max(repair.against, repair.cost) + self.budget.band)
                self.found.append(repair)
                continue
            if result.come == NOWHERE:
                self._given_up.append((candidate, text))
            better = self._helps(candidate, text, result)
            self._queue.failed(candidate, better=better)

    def _helps(self, candidate: Candidate, text: str, result: Tried) -> bool:
        """Keep a change that comes farther than the program; return whether it does."""
        better = result.come > self._base + FARTHER
        if better:
            self._helpers.append(_Helper(candidate, text, result))
        return better

    def surely(self) -> list[_Helper]:
        """Return changes of what is surely a slip, whether they come farther or not."""
        made = [
            _Helper(candidate, changed(self.source.text, candidate.change.edits), NOT_TRIED)
            for candidate in surely(self._asked)
        ]
        return made[:MOST_SURE]

    def helping(self, most: int, again: int) -> list[_Helper]:
        """Return the changes that come farthest; of those that come as far the cheapest.

        Args:
            most: How many.
            again: How many of those given up early are executed to their end before.
        """
        for candidate, text in self._given_up[:again]:
            self.count += 1
            result = tried(self.place, text, self.memory, self._touches, self._shared)
            self._helps(candidate, text, result)
        del self._given_up[:again]
        self._helpers.sort(key=lambda each: (-round(each.result.come, 3), each.candidate.cost))
        taken: dict[tuple[float, int], _Helper] = {}
        for helper in self._helpers:
            place = (round(helper.result.come, 4), helper.candidate.change.line)
            if place not in self._tried:
                taken.setdefault(place, helper)
        best = [place for place in taken if place[0] > self._base + 0.3 * self._gain][:most]
        self._tried.update(best)
        return [taken[place] for place in best]

    def better(self, mark: Fraction) -> Repair | None:
        """Return the change that earns most of those that come farthest; None: no more than a mark.

        Each is verified by the usual run and the usual checks.
        """
        taken = sorted(self._helpers, key=lambda h: (-round(h.result.come, 3), h.candidate.cost))
        best: Repair | None = None
        for helper in taken[:MOST_JUDGED]:
            result = verified_text(self.place, helper.text)
            if result.mark is not None and result.mark > mark:
                mark = result.mark
                best = _repair(helper.candidate, helper.text, result, self._asked)
        return best

    @property
    def _gain(self) -> float:
        """How much farther the best of them comes."""
        return max((each.result.come for each in self._helpers), default=0.0) - self._base


def _next(
    place: Place, source: SourceFile, helper: _Helper
) -> tuple[SourceFile, tuple[Run, Judgement, Grade]]:
    """Return a program with a change that helps, and what is still wrong with it."""
    judged = verified_text(place, helper.text)  # from its beginning: its steps have other lines
    assert judged.run is not None
    assert judged.judgement is not None
    assert judged.grade is not None
    return SourceFile(source.name, helper.text), (judged.run, judged.judgement, judged.grade)


def _together(source: SourceFile, helper: _Helper, found: list[Repair]) -> list[Repair]:
    """Return the changes that are good beside one that helps, each with it."""
    first = helper.candidate
    made: list[Repair] = []
    for repair in found:
        change = both(source, first.change, repair.change)
        if change is not None:
            cost, doubt = first.cost + repair.cost, first.doubt + repair.doubt
            made.append(repair._replace(change=change, cost=cost, doubt=doubt))
    return made


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


def _repair(candidate: Candidate, text: str, result: Tried, asked: Asked) -> Repair:
    assert result.mark is not None
    change = candidate.change
    doubt = candidate.doubt
    said = f"{change.old} {change.new}".lower()
    if asked.idle and not any(name in said for name in asked.idle):
        doubt += UNUSED
    doubt += odder(asked, text)
    doubt += BESIDE_IT if asked.blame.slow and not keeps_time(change) else 0.0
    if any(line not in changed_lines(change) for line in slipped_rows(asked)):
        doubt += UNMENDED
    weight = asked.blame.weight(change.line)
    return Repair(change, candidate.cost, text, result.mark, weight, doubt)


def _code(text: str) -> str:
    """Return a program without what changes nothing: layout."""
    return "\n".join(" ".join(line.split()) for line in text.splitlines() if line.strip())
