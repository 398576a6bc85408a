"""The mutants of `tests/data/mutants` are what the mutator makes, and cost what the files say."""

from collections import Counter

import pytest

from tests.mutants.choosing import one_mistake
from tests.mutants.given import Mutant, mutants, written
from tests.mutants.hunks import Hunk, StaleError, apart, applied, hunks
from tests.mutants.measure import size
from tests.mutants.mutating import KINDS, mutated
from tests.mutants.originals import FOLDER, originals, worth
from tests.mutants.table import table

ALL = mutants()
ONE = [mutant for mutant in ALL if len(mutant.kinds) == 1]
TWO = [mutant for mutant in ALL if len(mutant.kinds) == 2]
SAMPLE = ALL[::40]
SOLUTIONS = ("01", "02", "03", "04")


def ids(mutant: Mutant) -> str:
    return mutant.id


def costs_what_is_said(mutant: Mutant) -> None:
    """Assert that a mutant compiles, loses points, and earns the mark of its row."""
    found = worth(mutant.text, mutant.original.example)
    assert found is not None, "it does not compile"
    assert not found.full
    assert float(found.mark) == mutant.mark


def test_there_are_enough_of_every_example() -> None:
    of_solutions = Counter(m.original.name for m in ONE if m.original.name in SOLUTIONS)
    assert of_solutions.total() >= 320
    assert len(TWO) >= 80
    assert all(of_solutions[name] >= 70 for name in SOLUTIONS)


def test_no_kind_has_more_than_its_share() -> None:
    kinds = Counter(mutant.kinds[0] for mutant in ONE)
    assert max(kinds.values()) <= 0.12 * len(ONE)
    assert len(kinds) >= 30
    assert kinds.keys() <= KINDS.keys()


def test_ids_and_programs_are_unique() -> None:
    assert [name for name, n in Counter(m.id for m in ALL).items() if n > 1] == []
    texts = Counter((m.original.example, m.text) for m in ALL)
    assert max(texts.values()) == 1


def test_the_mutator_makes_them_again() -> None:
    for mutant in ALL:
        made = [
            edits
            for kind, seed in zip(mutant.kinds, mutant.seeds, strict=True)
            for edits in mutated(mutant.original.text, kind, seed)
        ]
        assert tuple(sorted(made)) == tuple(sorted(mutant.edits)), mutant.id


def test_the_files_are_as_they_are_written() -> None:
    for name in originals():
        of_this = [mutant for mutant in ALL if mutant.original.name == name]
        assert written(of_this) == (FOLDER / f"{name}.jsonl").read_text(encoding="utf-8")


@pytest.mark.thorough
@pytest.mark.parametrize("name", originals())
def test_what_they_are_made_from_has_the_full_mark(name: str) -> None:
    original = originals()[name]
    found = worth(original.text, original.example)
    assert found is not None
    assert found.full


@pytest.mark.parametrize("mutant", SAMPLE, ids=ids)
def test_a_mutant_costs_points(mutant: Mutant) -> None:
    costs_what_is_said(mutant)
    assert size(mutant.original.text, mutant.text) == mutant.size


@pytest.mark.thorough
@pytest.mark.parametrize("mutant", [m for m in ALL[::4] if m not in SAMPLE], ids=ids)
def test_more_mutants_cost_points(mutant: Mutant) -> None:
    costs_what_is_said(mutant)
    assert size(mutant.original.text, mutant.text) == mutant.size


@pytest.mark.thorough
@pytest.mark.parametrize("mutant", TWO, ids=ids)
def test_each_of_two_mistakes_costs_points_alone(mutant: Mutant) -> None:
    text = mutant.original.text
    halves = [mutated(text, k, s) for k, s in zip(mutant.kinds, mutant.seeds, strict=True)]
    assert apart(*halves)
    for edits in halves:
        found = worth(applied(text, edits), mutant.original.example)
        assert found is not None
        assert not found.full


@pytest.mark.thorough
def test_choosing_is_the_same_every_time_and_other_seeds_give_others() -> None:
    original = originals()["03"]
    first = one_mistake(original, 3)
    assert first == one_mistake(original, 3)
    assert first == [m for m in ONE if m.original == original][:3]
    assert {m.text for m in one_mistake(original, 3, 90_000)} != {m.text for m in first}


def test_an_edit_gives_the_text_it_was_made_of() -> None:
    before, after = ["a", "b", "c", "d"], ["x", "a", "c", "D", "d"]
    edits = hunks(before, after)
    assert applied("a\nb\nc\nd\n", edits).splitlines() == after
    with pytest.raises(StaleError, match="line 2"):
        applied("a\nB\nc\nd\n", edits)
    one, near, far = Hunk(1, ("a",), ()), Hunk(2, ("b",), ()), Hunk(3, (), ("c",))
    assert not apart([one], [near])
    assert apart([one], [far])


def test_the_table_counts_every_mutant_once() -> None:
    lines = table(ALL).splitlines()
    assert lines[1].split()[-1] == str(len(ONE))
    assert next(line for line in lines if line.startswith("two")).split()[-1] == str(len(TWO))
