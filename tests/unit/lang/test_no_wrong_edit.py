"""Mistakes whose obvious edit would be wrong: the message says what is missing."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.diagnostic import Diagnostic


def told(body: str) -> Diagnostic:
    """Return the one error of a program."""
    (found,) = (d for d in said(compiled(f".PROGRAM main\n{body}\n.END\n")) if d.is_error)
    return found


@pytest.mark.parametrize(
    ("body", "help_"),
    [
        ("GOTO\n10 READY", "the one label of this program is 10: write `GOTO 10`"),
        ("10 GOTO", "the one label of this program is 10: write `GOTO 10`"),
        ("IF SIG(1001) GOTO\n10 READY\n20 OPENI", "labels of this program: 10, 20"),
        ("GOTO", "labels are whole numbers at the start of a line: `10 MOVE a`, then `GOTO 10`"),
    ],
)
def test_a_jump_without_a_label_names_the_labels(body: str, help_: str) -> None:
    found = told(body)
    assert found.rule.code == "V136"
    assert found.headline == "GOTO needs a label"
    assert found.help == (help_,)


def test_a_wait_has_no_time_limit() -> None:
    found = told("WAIT SIG(1001), 5")
    assert "WAIT SIG(1001) OR (TIMER(1) > 5)" in found.help[0]
    assert found.fix is None


def test_two_signals_behind_wait_are_a_list() -> None:
    assert "SIG(1001, 1002)" in told("WAIT SIG(1001), 1002").help[0]


@pytest.mark.parametrize("body", ["WAIT FOR $IN[3]", "WaitDI 3, 1"])
def test_inputs_of_other_languages_begin_at_1001(body: str) -> None:
    assert "WAIT SIG(1003)" in told(body).help[0]


@pytest.mark.parametrize("word", ["HERE", "MOVE", "MOVES"])
def test_a_colon_with_nothing_behind_it_stays(word: str) -> None:
    found = told(f"SET pal = TRANS(1, 2, 3)\n{word} pal:")
    assert found.rule.code == "V124"
    assert "behind `:`" in found.help[0]
    assert found.fix is None


@pytest.mark.parametrize(
    ("body", "after"),
    [
        ("MOVES part FINE", "`FINE`, `MOVES part`"),
        ("APPRO part, 50 SPEED 20", "`SPEED 20`, `APPRO part, 50`"),
        ("MOVE part LEFTY", "`LEFTY`, `MOVE part`"),
        ("OPENI READY", "`OPENI`, `READY`"),
    ],
)
def test_a_setting_goes_before_its_motion(body: str, after: str) -> None:
    assert after in told(f"SET part = TRANS(1, 2, 3)\n{body}").help[0]


@pytest.mark.parametrize(("after", "sure"), [("MOVE b", False), ("DEPARTS 50", True)])
def test_a_hand_that_closes_on_the_way_is_surely_wrong_only_before_leaving(
    after: str, sure: bool
) -> None:
    text = ".PROGRAM main\nSET a = TRANS(1, 2, 3)\nSET b = a\n"
    found = said(compiled(f"{text}MOVE a\nCLOSE\n{after}\nMOVE b\n.END\n"))
    (hand,) = (d for d in found if d.rule.code == "V221")
    assert hand.fix is not None
    assert hand.fix.sure is sure
