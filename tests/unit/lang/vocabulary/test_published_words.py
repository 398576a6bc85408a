"""Words of published lists: none of them may be unknown."""

import re

import pytest

from tests.support_words import KINDS, READ, dialects, listed

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
