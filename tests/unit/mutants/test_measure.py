"""The measure of an edit: what costs nothing, what costs one, and that it is a distance."""

from itertools import product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.mutants.hunks import applied
from tests.mutants.measure import size
from tests.mutants.mutating import KINDS, mutated
from tests.mutants.originals import originals
from vrts.base.source import SourceFile
from vrts.lang.dialect import VAL2
from vrts.lang.writing.layout import layout

ORIGINALS = originals()
TEXT = ORIGINALS["04"].text
LISTS = ORIGINALS["04-lists"].text
EACH = pytest.mark.parametrize("name", ORIGINALS)


def changed(*changes: tuple[str, str], text: str = TEXT) -> int:
    """Return the size of an edit that replaces the first of each text."""
    after = text
    for old, new in changes:
        assert old in after
        after = after.replace(old, new, 1)
    assert after != text
    return size(text, after)


@EACH
def test_a_program_in_another_layout_is_the_same(name: str) -> None:
    text = ORIGINALS[name].text
    bare = "\n".join(line.split(";")[0].strip() for line in text.splitlines())
    assert size(text, text) == 0
    assert size(text, bare) == 0
    assert size(text, layout(SourceFile("a.v2", bare), VAL2)) == 0
    assert size(text, text.replace("\n        ", "\n\n; a remark\n  ")) == 0


def test_case_and_ways_to_write_a_number_cost_nothing() -> None:
    assert changed(("MOVES baked", "moves BAKED")) == 0
    assert changed(("DEPARTS 140", "DEPARTS 1.4E2"), ("SPEED 40", "SPEED 40.00")) == 0
    assert changed(("1080.00  -350.00", "1080 -350")) == 0


def test_the_order_of_rows_and_of_programs_costs_nothing() -> None:
    rows = TEXT[TEXT.index("can1_grip  ") :].splitlines()[:-1]
    assert size(TEXT, TEXT.replace("\n".join(rows), "\n".join(reversed(rows)))) == 0
    programs = TEXT.split(".PROGRAM ")
    last, data = programs[-1].split(".LOCATIONS")
    turned = f"{programs[0]}.PROGRAM {last}.PROGRAM {'.PROGRAM '.join(programs[1:-1])}"
    assert size(TEXT, f"{turned}.LOCATIONS{data}") == 0


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("DEPARTS 140", "DEPARTS 14"),
        ("DEPARTS 140", "DEPARTS -140"),
        ("BY -305", "BY 305"),
        ("1080.00", "1080.01"),
        ("MOVES door", "MOVES in"),
        ("MOVES door", "MOVE door"),
        ("CLOSEI", "CLOSE"),
        ("from[i]", "from[2]"),
        ("from[i]", "goal[i]"),
        ("from[i]", "from"),
        ("CALL bake", "CALL places"),
        ("        BREAK  ", "  "),
        ("INVERSE(pizza):", "pizza:"),
        ("100 ALWAYS", "100"),
        ("SPEED 40", "SPEED 40 MMPS"),
        ("TO 3", "TO 3 STEP 2"),
        ("(start, finish, rise)", "(start, finish, up)"),
        ("base1_put     ", "base1_puts    "),
        ('"Everything', '"Nothing'),
    ],
)
def test_one_wrong_thing_counts_one(old: str, new: str) -> None:
    assert changed((old, new)) == 1


@pytest.mark.parametrize(
    ("old", "new", "nodes"),
    [
        ("i >= things", "i > things", 1),
        ("i+1", "i-1", 1),
        ("n > 3", "NOT (n > 3)", 2),
        ("7*over", "over", 2),
        ("7*over", "140", 3),
    ],
)
def test_operators_count_one_each(old: str, new: str, nodes: int) -> None:
    assert changed((old, new), text=LISTS) == nodes


@pytest.mark.parametrize(
    ("old", "new", "nodes"),
    [
        ("carry(from[i], goal[i], 60)", "carry(goal[i], from[i], 60)", 2),
        ("690.00   300.00", "300.00   690.00", 2),
        ("690.00   300.00  -185.00", " 27.17    11.81    -7.28", 3),
        ("        MOVES in\n", "", 2),
        ("        APPRO pizza_grip, 80\n", "", 3),
        ("MOVES in", "APPROS in, 20", 2),
        ("rim                 0.00   103.00    18.00    90.00   -90.00     0.00\n", "", 7),
        ("MOVES in\n        SPEED 20\n", "SPEED 20\n        MOVES in\n", 4),
        ("SPEED 20\n        MOVES baked", "SPEED 25\n        MOVES in", 2),
        ("MOVES door\n", "MOVES door\n        MOVES door\n", 2),
    ],
)
def test_what_counts_more(old: str, new: str, nodes: int) -> None:
    assert changed((old, new)) == nodes


def test_the_names_of_two_rows_exchanged_count_two() -> None:
    names = ("can1_grip  ", "base3_put  ")
    between = TEXT.replace(names[0], "?").replace(names[1], names[0]).replace("?", names[1])
    assert size(TEXT, between) == 2


def test_what_is_no_step_counts_its_words() -> None:
    assert changed(("        MOVES door\n", "        go to the door\n")) == 4


@settings(max_examples=examples(60), deadline=None)
@given(
    st.sampled_from(sorted(ORIGINALS)),
    st.lists(st.tuples(st.sampled_from(sorted(KINDS)), st.integers(0, 99)), min_size=2, max_size=2),
)
def test_it_is_a_distance(name: str, mistakes: list[tuple[str, int]]) -> None:
    text = ORIGINALS[name].text
    texts = [text, *(applied(text, mutated(text, kind, seed)) for kind, seed in mistakes)]
    far = {(a, b): size(texts[a], texts[b]) for a, b in product(range(3), repeat=2)}
    for a, b, c in product(range(3), repeat=3):
        assert far[a, a] == 0
        assert far[a, b] == far[b, a]
        assert far[a, c] <= far[a, b] + far[b, c]
