"""Words brought into one form."""

import pytest

from vrts.ask.everyday import ALIKE
from vrts.ask.other_languages import names_elsewhere, own_words
from vrts.ask.terms import alike, stem, wanted, words_of


@pytest.mark.parametrize(
    ("words", "one"),
    [
        ("wait waits waiting waited", "wait"),
        ("move moves moving moved", "mov"),
        ("stop stops stopping stopped", "stop"),
        ("entry entries", "entri"),
        ("slowly slow", "slow"),
        ("simulation simulator simulating simulates", "simulat"),
        ("gripper gripping", "grip"),
        ("teach teaches taught", "teach"),  # but a teacher is somebody
        ("teacher teachers", "teacher"),
        ("glass", "glass"),
        ("this", "this"),
        ("bus", "bus"),
        ("ed", "ed"),
    ],
)
def test_endings_are_cut_off(words: str, one: str) -> None:
    assert {stem(word) for word in words.split()} == {one}


def test_words_with_signs_count_whole_and_in_parts() -> None:
    assert words_of("set_digital_out(3)") == ["set_digital_out", "set", "digital", "out", "3"]


def test_phrases_mean_one_thing() -> None:
    (one,) = wanted("let go")
    assert one.said == "let go"
    assert "releas" in one.worth


def test_small_words_are_left_out_unless_there_is_nothing_else() -> None:
    assert [thing.said for thing in wanted("how do I print?")] == ["print"]
    assert [thing.said for thing in wanted("if")] == ["if"]
    assert wanted("how do I")


def test_in_a_piece_of_a_program_small_words_are_words_of_the_language() -> None:
    worth = [thing.worth for thing in wanted("do { } while")]
    assert [max(each, key=lambda term: each[term]) for each in worth] == ["=do", "=while"]
    assert "=do" not in wanted("do it while I wait")[0].worth


def test_what_a_step_is_about_counts_little() -> None:
    worth = {thing.said: max(thing.worth.values()) for thing in wanted("wait 50 p1 V301")}
    assert worth["50"] == worth["p1"] < 0.2
    assert worth["v301"] >= 1


def test_every_group_has_words_and_none_twice() -> None:
    for row in ALIKE:
        words = [word.strip() for word in row.split(",")]
        assert all(words), row
        assert len(words) == len(set(words)) > 1, row
    assert "paus" in alike()["wait"]


@pytest.mark.parametrize(
    ("foreign", "own"),
    [
        ("movel", "MOVES"),  # RAPID
        ("lin", "MOVES"),  # KRL
        ("ptp", "MOVE"),
        ("set_digital_out", "SIGNAL"),  # URScript
        ("twait", "DELAY"),  # AS
        ("lmove", "MOVES"),
        ("wait.event", "DELAY"),  # V+
        ("open_hand", "OPENI"),  # Karel
        ("tpwrite", "TYPE"),
        ("sleep", "DELAY"),
        ("strlen", "LEN"),
    ],
)
def test_words_of_other_languages_come_from_what_diagnostics_advise(foreign: str, own: str) -> None:
    assert own in own_words()[foreign]
    assert foreign in names_elsewhere()[own]
