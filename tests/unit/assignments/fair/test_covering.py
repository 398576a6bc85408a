"""A covering set has every value, and every two values that may come together."""

from itertools import combinations, product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.unit.assignments.fair.support import variants
from vrts.assignments.fair import covering as covering_of
from vrts.assignments.fair.covering import covering
from vrts.check.variants.model import Combination

Counts = st.lists(st.integers(2, 6), min_size=1, max_size=5)


def pairs(row: Combination) -> set[tuple[tuple[int, int], ...]]:
    return set(combinations(enumerate(row), 2))


@given(Counts, st.data())
def test_whatever_may_come_together_is_tried(counts: list[int], data: st.DataObject) -> None:
    rule = {
        k: frozenset(data.draw(st.sets(st.integers(0, n - 1), min_size=1)))
        for k, n in enumerate(counts)
        if data.draw(st.booleans())
    }
    asked = variants(counts, [rule] if rule else [])
    found = covering(asked, most=99)
    every = [row for row in product(*map(range, counts)) if asked.allowed(row)]
    assert all(asked.allowed(row) for row in found.combinations)
    together = set[tuple[tuple[int, int], ...]]().union(*map(pairs, every))
    values = {value for row in every for value in enumerate(row)}
    tried = set[tuple[tuple[int, int], ...]]().union(*map(pairs, found.combinations))
    assert {value for row in found.combinations for value in enumerate(row)} == values
    assert found.values == len(values)
    if not found.thinned:
        assert tried == together
        assert found.pairs == len(together)
    assert found == covering(asked, most=99)


def test_few_of_many_are_enough() -> None:
    found = covering(variants([5, 5, 5, 5, 5, 5, 3, 2]))
    assert 25 <= len(found.combinations) <= 40
    assert (found.values, found.pairs, found.never, found.thinned) == (35, 531, 0, False)


def test_all_are_tried_where_there_are_few() -> None:
    assert len(covering(variants([4, 5, 5])).combinations) == 100
    assert len(covering(variants([4, 5, 5], [{0: frozenset({0})}])).combinations) == 75


def test_what_was_not_found_in_time_is_not_called_excluded(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Five things choose among three values, of which two may be there once."""
    rules = [
        {a: frozenset({c}), b: frozenset({c})} for a, b in combinations(range(5), 2) for c in (0, 1)
    ]
    asked = variants([3, 3, 3, 3, 3, 9, 9], rules)
    usual = covering(asked, most=99)
    assert usual.given_up == 0
    assert usual.never > 0
    monkeypatch.setattr(covering_of, "MOST_TRIES", 9)
    hurried = covering(asked, most=99)
    assert hurried.given_up > 0
    assert hurried.never <= usual.never
    assert hurried.never + hurried.given_up >= usual.never
    monkeypatch.setattr(covering_of, "MOST_OF_ALL", 30)
    ended = covering(asked, most=99)
    assert ended.given_up > hurried.given_up
    whole = ended.values + ended.pairs + ended.never + ended.given_up
    assert whole == usual.values + usual.pairs + usual.never


def test_wide_ranges_of_many_things_take_no_time() -> None:
    """Counted, not timed: choices are looked at in order, and not all for each variant."""
    found = covering(variants([200] * 20))
    assert (found.values, found.given_up) == (4000, 0)


@pytest.mark.parametrize("counts", [(121, 121, 2), (40,) * 10])
def test_wide_ranges_are_thinned_out_and_lose_no_value(counts: tuple[int, ...]) -> None:
    found = covering(variants(counts))
    assert found.thinned
    assert found.values == sum(counts)
    assert len(found.combinations) < 700
    ends = {((0, a), (1, b)) for a in (0, counts[0] - 1) for b in (0, counts[1] - 1)}
    assert ends <= {((0, row[0]), (1, row[1])) for row in found.combinations}
