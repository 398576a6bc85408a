"""Words for true and false, `&` between strings, lists for TOOL and BASE: what to write instead."""

import pytest

from tests.mistakes import told_once

DATA = ".LOCATIONS\npick 450 -120 -250 90 90 0\n.END\n"


def told(body: str) -> tuple[str, str]:
    """Return the help of the one message about a program, and its body after certain edits."""
    found, after = told_once(f".PROGRAM main\n{body}\n.END\n{DATA}")
    return "; ".join(found.help), after


@pytest.mark.parametrize(
    ("body", "after"),
    [
        ('ok = TRUE\nWAIT ok == "TRUE"', "ok = TRUE\nWAIT ok"),
        ('ok = 2 > 1\nWAIT ok == "FALSE"', "ok = 2 > 1\nWAIT NOT ok"),
        ('ok = FALSE\nWAIT "true" <> ok', "ok = FALSE\nWAIT NOT ok"),
        ('WAIT SIG(1001) == "ON"', "WAIT SIG(1001)"),
        ('WAIT SIG(1001) == "off"', "WAIT NOT SIG(1001)"),
        ('WAIT SIG(1001) <> "1"', "WAIT NOT SIG(1001)"),
        ('$a = "x"\n$b = "y " & $a\nTYPE $b', '$a = "x"\n$b = "y "+$a\nTYPE $b'),
        ('$a = "x"\nWAIT $a & "&" == "x&"', '$a = "x"\nWAIT $a+"&" == "x&"'),
        ("TOOL 0, 0, 150, 90, -90, 0", "TOOL TRANS(0, 0, 150, 90, -90, 0)"),
        ("BASE TRANS(100, 0, 5)", "BASE 100, 0, 5"),
    ],
)
def test_what_is_certain_is_mended(body: str, after: str) -> None:
    assert told(body)[1] == after


@pytest.mark.parametrize(
    ("body", "help_"),
    [
        ('WAIT SIG(1001) == "abc"', "a number never equals a text"),
        ('ok = 5\nWAIT ok == "TRUE"', "write `ok`"),
        ('n = 5\n$s = "a" & n\nTYPE $s', '`$s = "a"+$ENCODE(n)`'),
        ("TOOL 0, 0, 150", "`TOOL TRANS(0, 0, 150, 90, -90, 0)`"),
        ("TOOL 150", "`TOOL TRANS(0, 0, 150, 90, -90, 0)`"),
        ("BASE TRANS(100, 0, 5, 0, 0, 30)", "`BASE 100, 0, 5`, and behind them an angle"),
        ("MOVE box\nbox = box+1", "`box.count = box.count+1`"),
    ],
)
def test_what_is_open_is_told_only(body: str, help_: str) -> None:
    found, after = told(body)
    assert help_ in found
    assert after == body


def test_a_string_without_its_sign_is_told_where_it_is_given() -> None:
    """`$name` has its value from the line that is wrong."""
    found, after = told('name = "Ada"\nTYPE $name')
    assert '`$name = "Ada"`' in found
    assert after == '$name = "Ada"\nTYPE $name'
