"""Which mistakes become mutants: those that compile, cost points, and are not all of one kind."""

from collections import Counter
from collections.abc import Iterator
from itertools import chain, count
from random import Random

from tests.mutants.given import Mutant
from tests.mutants.hunks import Hunk, apart, applied
from tests.mutants.measure import size
from tests.mutants.mutating import KINDS, mutated
from tests.mutants.originals import Original, worth

SAME_PLACE = 2  # mutants of one kind on the same lines
TRIALS = 8  # seeds tried for one more mutant of a kind, before the next kind has its turn
FRUITLESS = 40  # seeds one after another that gave none: the kind has no more
SECOND = 500_000  # where the seeds of programs with two mistakes begin, behind the first seed


def one_mistake(original: Original, number: int, first_seed: int = 0) -> list[Mutant]:
    """Return mutants with one mistake; every kind in turn gives one, as long as it has any."""
    chosen: dict[str, Mutant] = {}  # by text
    places: Counter[tuple[object, ...]] = Counter()
    seeds = dict.fromkeys(KINDS, first_seed)
    fruitless = dict.fromkeys(KINDS, 0)
    while len(chosen) < number and min(fruitless.values()) < FRUITLESS:
        for kind in KINDS:
            for _ in range(TRIALS):
                if len(chosen) >= number or fruitless[kind] >= FRUITLESS:
                    break
                seed = seeds[kind]
                seeds[kind] += 1
                fruitless[kind] += 1
                edits = mutated(original.text, kind, seed)
                place = (kind, *(hunk.line for hunk in edits))
                if not edits or places[place] >= SAME_PLACE:
                    continue
                text = applied(original.text, edits)
                found = None if text in chosen else _mutant(original, (kind,), (seed,), edits)
                if found is not None:
                    chosen[text] = found
                    places[place] += 1
                    fruitless[kind] = 0
                    break
    return list(chosen.values())


def two_mistakes(original: Original, number: int, first_seed: int = 0) -> list[Mutant]:
    """Return mutants with two mistakes of different kinds; each alone costs points."""
    chosen: list[Mutant] = []
    used: Counter[str] = Counter()
    for kinds, seeds in _pairs(original, first_seed + SECOND):
        if len(chosen) >= number:
            break
        one, two = (
            mutated(original.text, kind, seed) for kind, seed in zip(kinds, seeds, strict=True)
        )
        if not one or not two or not apart(one, two) or max(used[k] for k in kinds) > number // 8:
            continue
        if not all(
            _mutant(original, (kind,), (seed,), edits)
            for kind, seed, edits in zip(kinds, seeds, (one, two), strict=True)
        ):
            continue
        found = _mutant(original, kinds, seeds, tuple(sorted((*one, *two))))
        if found is not None:
            chosen.append(found)
            used.update(kinds)
    return chosen


def _pairs(
    original: Original, first_seed: int
) -> Iterator[tuple[tuple[str, str], tuple[int, int]]]:
    chance = Random(f"{original.name} {first_seed}")
    for seed in count(first_seed, 2):
        one, two = sorted(chance.sample(list(KINDS), 2))
        yield (one, two), (seed, seed + 1)


def _mutant(
    original: Original, kinds: tuple[str, ...], seeds: tuple[int, ...], edits: tuple[Hunk, ...]
) -> Mutant | None:
    """Return a mutant, if it compiles, differs by the measure, and loses points."""
    text = applied(original.text, edits)
    nodes = size(original.text, text)
    if nodes == 0:
        return None
    found = worth(text, original.example)
    if found is None or found.full:
        return None
    name = "+".join(chain(f"{kind}-{seed}" for kind, seed in zip(kinds, seeds, strict=True)))
    mark = float(found.mark)
    return Mutant(f"{original.name}-{name}", original, kinds, seeds, edits, nodes, mark)
