"""The table of words against the list of the reference, and the rules of abbreviation."""

import json
from pathlib import Path

import pytest

from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.lookup import look_up

WORDS = json.loads((Path(__file__).parents[2] / "data" / "keywords.json").read_text("utf-8"))


@pytest.mark.parametrize("word", WORDS["val2"])
def test_every_word_of_the_language_is_known(word: str) -> None:
    assert INSTRUCTIONS[word].in_val2


@pytest.mark.parametrize("word", WORDS["relatives"])
def test_words_of_relatives_are_known_as_such(word: str) -> None:
    assert not INSTRUCTIONS[word].in_val2


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("MOVE", "MOVE"),  # exact, though longer words begin with it
        ("moves", "MOVES"),
        ("DEL", "DELAY"),
        ("RI", "RIGHTY"),
        ("RET", "RETURN"),  # fixed, though RETURNE begins with it too
        ("RETU", "RETURN"),
        ("WH", "WHILE"),
        ("HA", "HALT"),
    ],
)
def test_abbreviation(text: str, word: str) -> None:
    match = look_up(text)
    assert match.word is not None
    assert match.word.text == word


@pytest.mark.parametrize("text", ["MOV", "OPE", "CLO", "RELA", "APPR", "B"])
def test_ambiguous_abbreviation(text: str) -> None:
    assert look_up(text).word is None
    assert len(look_up(text).candidates) > 1


@pytest.mark.parametrize("text", ["CAS", "FO", "ELS", "EN", "UNT", "VAL", "MOVEE", "ALWAYS"])
def test_structure_words_are_written_in_full(text: str) -> None:
    match = look_up(text)
    assert match.word is None or not match.word.full
