"""Functions written otherwise: how they are written, as an edit where that is clear."""

import pytest

from tests.mistakes import told_once

DATA = ".LOCATIONS\npick 450 -120 -250 90 90 0\nover 450 -120 -100 90 90 0\n.END\n"


def told(body: str) -> tuple[str, str]:
    """Return the help of the one message about a program, and its body after certain edits."""
    found, after = told_once(f".PROGRAM main\n{body}\n.END\n{DATA}")
    return "; ".join(found.help), after


@pytest.mark.parametrize(
    ("body", "help_"),
    [
        ("SET f = FRAME(pick, over, pick)", "`FRAME(on_x1, on_x2, on_y, origin)`"),
        ("d = DISTANCE(pick)", "`DISTANCE(one, other)`"),
        ("a = COS()", "`COS(angle)`"),
        ("n = BITS(1001)", "`BITS(first, count)`"),
        ("n = LEN()", "`LEN($text)`"),
        ("SET p = SHIFT(pick, 5)", "`SHIFT(location BY dx, dy, dz)`"),
        ("d = SQRT SQR(DX(pick))+SQR(DY(pick))", "`SQRT(SQR(DX(pick))+SQR(DY(pick)))`"),
        ("d = INT DX(pick)/2", "`INT(DX(pick)/2)`"),
        ("x = f(2)", "`f[2]`"),
        ("x = f(2)", "`CALL f(2, x)`"),
        ("x = f(2)+1", "`CALL f(2, result)`"),
    ],
)
def test_the_form_is_told_where_nothing_is_certain(body: str, help_: str) -> None:
    found, after = told(body)
    assert help_ in found
    assert after == body


@pytest.mark.parametrize(
    ("body", "after"),
    [
        ("a = ATAN2(3/4)\nTYPE a", "a = ATAN2(3, 4)\nTYPE a"),
        ("d = DISTANCE(pick-over)\nTYPE d", "d = DISTANCE(pick, over)\nTYPE d"),
        ("d = DISTANCE pick, over\nTYPE d", "d = DISTANCE(pick, over)\nTYPE d"),
        ("SET p = SHIFT pick BY 0, 0, 50", "SET p = SHIFT(pick BY 0, 0, 50)"),
        ("SET p = TRANS 1, 2, 3, 4, 5, 6", "SET p = TRANS(1, 2, 3, 4, 5, 6)"),
        ("WAIT SIG 1001, 1002", "WAIT SIG(1001, 1002)"),
        ("IF DZ pick > 5 THEN\nREADY\nEND", "IF DZ(pick) > 5 THEN\nREADY\nEND"),
        ("TYPE DX pick, 5", "TYPE DX(pick), 5"),
        ("$s = $ENCODE 5\nTYPE $s", "$s = $ENCODE(5)\nTYPE $s"),
        ("MOVE TRANS(20*(3+1)),0,0,90,-90,0)", "MOVE TRANS(20*(3+1),0,0,90,-90,0)"),
        ("SET p = SHIFT(pick BY 0,0,(3+5)),2)", "SET p = SHIFT(pick BY 0,0,(3+5),2)"),
        ("x = MAX(3),4)\nTYPE x", "x = MAX(3,4)\nTYPE x"),
        ("x = (3+4))*2\nTYPE x", "x = (3+4)*2\nTYPE x"),
        ("TYPE SQRT(SQR(3)+SQR(4)))", "TYPE SQRT(SQR(3)+SQR(4))"),
    ],
)
def test_what_is_certain_is_mended(body: str, after: str) -> None:
    assert told(body)[1] == after


def test_a_parenthesis_that_may_lack_its_partner_is_not_taken_out() -> None:
    """`3+4)*2` means `(3+4)*2` more likely."""
    found, after = told("x = 3+4)*2\nTYPE x")
    assert "add `(`" in found
    assert after == "x = 3+4)*2\nTYPE x"


def test_a_minus_behind_a_function_makes_no_variable_of_it() -> None:
    """One warning, of which the edit is offered only."""
    found, after = told("d = ABS -5\nTYPE d")
    assert "`ABS(-5)`" in found
    assert after == "d = ABS -5\nTYPE d"
