"""All that is found out about the variants of a task: tried, compared, and copied."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from vrts.assignments.fair.copied import Copied, copied
from vrts.assignments.fair.covering import Covering, covering
from vrts.assignments.fair.remedy import Part, cause, fewest, has, narrowed
from vrts.assignments.fair.trial import Trial, tried
from vrts.assignments.fair.uneven import Measure, fits, measures, problems_of
from vrts.assignments.variants.of_task import VariedTask
from vrts.base.workers import Workers
from vrts.check.variants.drawn import drawn
from vrts.check.variants.model import Combination

MANY = 40  # made-up students whose pairs are tried where there is no list of a class
SAMPLE_KEY = bytes(32)  # by which their variants are drawn: always the same ones
MOST_CAUSES = 24  # variants that fall out, of which the cause is looked for


class FallsOut(NamedTuple):
    """A variant that no student should get."""

    combination: Combination
    students: tuple[str, ...]  # who has it
    why: tuple[str, ...]


class Fairness(NamedTuple):
    """What was found out."""

    covering: Covering
    students: int  # of the list; 0: there is none
    of_students: int  # different variants that they have
    trials: tuple[Trial, ...]
    measures: tuple[Measure, ...]
    out: tuple[FallsOut, ...]
    excluded: tuple[Part, ...]  # what would exclude them
    unexplained: int  # variants that fall out, and that no part of `excluded` has
    copied: Copied | None  # None: there are not two variants that can be done

    @property
    def fair(self) -> bool:
        """Whether every variant that was tried can be handed out."""
        return not self.out and not self.covering.given_up


def fairness(
    varied: VariedTask,
    students: Mapping[str, Combination],
    workers: Workers,
    told: Callable[[int, int], None] = lambda _, __: None,
) -> Fairness:
    """Try a covering set of variants, and those of students; compare them; copy among them.

    Args:
        varied: The task; it has a reference.
        students: Which variant each student has, by a name that is shown; nobody: no list.
        workers: Who tries the variants.
        told: Told how many are tried, and of how many.
    """
    cover = covering(varied.variants)
    made_up = students or _made_up(varied)
    asked = tuple(dict.fromkeys((*cover.combinations, *made_up.values())))
    trials = tuple(_tried(varied, asked, workers, told))
    found = measures(trials, varied.variants.even)
    whose: dict[Combination, list[str]] = {}
    for name, combination in students.items():
        whose.setdefault(combination, []).append(name)
    out = tuple(
        FallsOut(combination, tuple(whose.get(combination, ())), why)
        for combination, why in problems_of(trials, found)
    )
    excluded = _excluded(varied, trials, found, [one.combination for one in out], workers)
    unexplained = sum(not any(has(one.combination, part) for part in excluded) for one in out)
    programs = {trial.combination: trial.program for trial in trials if not trial.problems}
    doing = [one for one in made_up.values() if one in programs]
    return Fairness(
        cover,
        len(students),
        len(whose),
        trials,
        found,
        out,
        excluded,
        unexplained,
        copied(varied, doing, programs, workers) if len(doing) > 1 else None,
    )


def _tried(
    varied: VariedTask,
    asked: Sequence[Combination],
    workers: Workers,
    told: Callable[[int, int], None],
) -> Iterator[Trial]:
    def ask(combination: Combination) -> Trial:
        return tried(varied, combination)

    for done, trial in enumerate(workers.answers(ask, asked), start=1):
        told(done, len(asked))
        yield trial


def _made_up(varied: VariedTask) -> dict[str, Combination]:
    """Return the variants of students that nobody is, drawn as those of a class are."""
    names = (f"student {number}" for number in range(1, MANY + 1))
    return {name: drawn(varied.variants, SAMPLE_KEY, name).combination for name in names}


def _excluded(
    varied: VariedTask,
    trials: Iterable[Trial],
    found: tuple[Measure, ...],
    bad: Sequence[Combination],
    workers: Workers,
) -> tuple[Part, ...]:
    """Return what to exclude, by the values that make variants fall out."""
    known = set(bad)
    good = [trial.combination for trial in trials if trial.combination not in known]
    if not bad or not good:
        return ()

    def falls_out(combination: Combination) -> bool:
        trial = tried(varied, combination)
        return bool(trial.problems) or not fits(trial, found)

    def ask(combination: Combination) -> Part:
        other = max(good, key=lambda one: sum(map(int.__ne__, one, combination)))
        part = cause(combination, other, falls_out, varied.variants.allowed)
        return narrowed(part, combination, good)

    parts = list(workers.answers(ask, bad[:MOST_CAUSES]))
    return fewest(parts, bad)
