"""Words of published lists: none of them may be unknown."""

import re

import pytest

from tests.support_words import (
    KINDS,
    OF_PROGRAMS,
    READ,
    UNKNOWN,
    Listed,
    dialects,
    listed,
    state,
    table,
)

_WORD = re.compile(r"[.$#]?[A-Z][A-Z0-9_.]*(/[A-Z0-9]+)?|\$?V\.2[A-Z.]+|[-+*/^<>=]{1,2}")


@pytest.mark.parametrize("dialect", dialects())
def test_lists_hold_words_and_nothing_else(dialect: str) -> None:
    words = list(listed(dialect))
    assert words
    assert {word.read for word in words} <= set(READ)
    assert {word.kind for word in words} <= set(KINDS)
    assert [word.word for word in words if not _WORD.fullmatch(word.word)] == []


@pytest.mark.parametrize("dialect", dialects())
def test_no_list_names_a_word_twice_as_the_same_kind(dialect: str) -> None:
    words = list(listed(dialect))
    lists = {(word.title, word.read) for word in words}
    for title, read in lists:
        own = [(w.kind, w.word) for w in words if (w.title, w.read) == (title, read)]
        assert len(own) == len(set(own))


@pytest.mark.parametrize("dialect", ["val", "val2", "vplus"])
def test_no_word_of_a_published_list_is_unknown_in_programs(dialect: str) -> None:
    words = {Listed("", "", word.kind, word.word) for word in listed(dialect)}
    unknown = [
        f"{word.kind} {word.word}"
        for word in words
        if word.kind in OF_PROGRAMS and state(dialect, word) == UNKNOWN
    ]
    assert sorted(unknown) == []


def test_what_is_carried_out_and_what_is_opaque_are_counted_apart(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The table that `-s` prints: words of the published lists, and how far vrts goes."""
    rows: list[str] = []
    for dialect in dialects():
        for kind, states in table(dialect).items():
            found = ", ".join(f"{states[name]} {name}" for name in sorted(states))
            rows.append(f"{dialect:6} {kind:12} {sum(states.values()):4}: {found}")
    with capsys.disabled():
        print("\n" + "\n".join(rows))
    assert table("vplus")["instruction"]["runs"] >= 87  # of 233
    assert table("vplus")["function"]["runs"] >= 75  # of 129
