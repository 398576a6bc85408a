"""The promise of winnowing, for any sequences."""

from hypothesis import given
from hypothesis import strategies as st

from vrts.marking.similarity.regions import regions
from vrts.marking.similarity.symbols import Part
from vrts.marking.similarity.winnowing import K, W, hashes, winnow

SYMBOLS = st.lists(st.integers(0, 3), max_size=60)
LONG = st.lists(st.integers(0, 3), min_size=K + W - 1, max_size=60)


@given(SYMBOLS, LONG, SYMBOLS, SYMBOLS, SYMBOLS)
def test_a_long_common_run_shares_a_fingerprint(
    before: list[int], common: list[int], after: list[int], left: list[int], right: list[int]
) -> None:
    one = {value for value, _ in winnow(hashes(before + common + after))}
    two = {value for value, _ in winnow(hashes(left + common + right))}
    assert one & two


@given(SYMBOLS)
def test_the_hash_of_a_run_depends_on_the_run_alone(symbols: list[int]) -> None:
    rolled = hashes(symbols)
    assert rolled == [hashes(symbols[k : k + K])[0] for k in range(max(0, len(symbols) - K + 1))]


@given(SYMBOLS)
def test_what_was_given_leaves_nothing(symbols: list[int]) -> None:
    values = hashes(symbols)
    assert winnow(values, frozenset(values)) == []
    kept = winnow(values)
    assert [place for _, place in kept] == sorted({place for _, place in kept})
    assert bool(kept) == bool(values)


@given(SYMBOLS, LONG, SYMBOLS)
def test_regions_are_equal_and_as_long_as_they_can_be(
    before: list[int], common: list[int], after: list[int]
) -> None:
    first, second = before + common, common + after

    def part(symbols: list[int]) -> Part:
        return Part(tuple(symbols), tuple(range(len(symbols))))

    def prints(symbols: list[int]) -> list[tuple[int, int, int]]:
        return [(value, 0, place) for value, place in winnow(hashes(symbols))]

    found = regions([part(first)], prints(first), [part(second)], prints(second))
    assert found
    assert found[0].symbols >= K
    for r in found:
        i, j = r.first_start, r.second_start
        assert first[i : r.first_end + 1] == second[j : r.second_end + 1]
        assert i == 0 or j == 0 or first[i - 1] != second[j - 1]
