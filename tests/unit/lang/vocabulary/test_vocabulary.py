"""The table of words against the list of the reference, and the rules of abbreviation."""

import json

import pytest

from tests.places import TESTS
from vrts.lang.dialect import AS, VAL2_PLUS
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.lookup import look_up

WORDS = json.loads((TESTS / "data" / "keywords.json").read_text("utf-8"))


@pytest.mark.parametrize("word", WORDS["val2"])
def test_every_word_of_the_language_is_known(word: str) -> None:
    assert INSTRUCTIONS[word].in_val2


@pytest.mark.parametrize("word", WORDS["relatives"])
def test_words_of_relatives_are_known_as_such(word: str) -> None:
    assert not INSTRUCTIONS[word].in_val2


def test_columns_are_those_of_the_reference() -> None:
    """A program is never refused for a word of its language; two words are in more."""
    listed = WORDS["columns"]
    missing = {w for w, letters in listed.items() if set(letters) - set(INSTRUCTIONS[w].dialects)}
    added = {w for w, letters in listed.items() if set(INSTRUCTIONS[w].dialects) - set(letters)}
    assert missing == set()
    assert added == {"HALT", "SHIFT"}  # HALT in VAL; SHIFT as an instruction of VAL-II


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


@pytest.mark.parametrize(("text", "word"), sorted(WORDS["as_shortest"].items()))
def test_shortest_forms_of_as(text: str, word: str) -> None:
    match = look_up(text, AS)
    assert match.word is not None
    assert match.word.text == word


@pytest.mark.parametrize("word", ["OPEN", "OPENI", "CLOSE", "RELAX", "ON", "ONE", "ONI", "RETURNE"])
def test_words_of_as_that_stand_in_full(word: str) -> None:
    assert look_up(word, AS).word is not None
    shorter = look_up(word[:-1], AS).word
    assert shorter is None or shorter.text != word


def test_a_tolerant_dialect_takes_the_shortest_of_several() -> None:
    assert look_up("MOV").word is None
    found = look_up("MOV", VAL2_PLUS)
    assert found.word is not None
    assert found.word.text == "MOVE"
    assert len(found.candidates) > 1
    assert look_up("B", VAL2_PLUS).word is None  # none of them begins all the others


def test_words_of_other_dialects_do_not_count() -> None:
    assert look_up("STAB").word is None
    found = look_up("STAB", AS).word
    assert found is not None
    assert found.text == "STABLE"
