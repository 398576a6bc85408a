"""Conditions that ask for something else than they look, and such that ask for nothing."""

import pytest

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.lang.compiler import compile_source

CODES = ("V150", "V152", "V168", "V239", "V240", "V125")


def told(step: str) -> list[Diagnostic]:
    text = f".PROGRAM main(x, y, z, $a)\n{step}\n.END\n"
    return [
        d for d in compile_source(SourceFile("main.v2", text)).diagnostics if d.rule.code in CODES
    ]


MENDED = [
    ("WAIT 10 < x < 20", "V150", "WAIT (10 < x) AND (x < 20)"),
    ("WAIT 0 <= x <= 9", "V150", "WAIT (0 <= x) AND (x <= 9)"),
    ("WAIT x == y == z", "V150", "WAIT (x == y) AND (y == z)"),
    ("WAIT 0 < x < y < z", "V150", "WAIT (0 < x) AND (x < y) AND (y < z)"),
    ("ok = NOT x == 3", "V150", "ok = NOT (x == 3)"),
    ("WAIT NOT x > y", "V150", "WAIT NOT (x > y)"),
    ("WAIT (x <> 1) OR (x <> 2)", "V239", "WAIT (x <> 1) AND (x <> 2)"),
    ('WAIT ($a == "y") AND ($a == "n")', "V168", 'WAIT ($a == "y") OR ($a == "n")'),
    ("WAIT 1001 OR 1002", "V239", "WAIT SIG(1001) OR SIG(1002)"),
    ("WAIT SIG(1001) AND -1002", "V239", "WAIT SIG(1001) AND SIG(-1002)"),
    ("WAIT SIG(1001) AND 1002 AND 1003", "V239", "WAIT SIG(1001) AND SIG(1002) AND SIG(1003)"),
    ("WAIT 1001", "V152", "WAIT SIG(1001)"),
    ("WAIT -1001", "V152", "WAIT SIG(-1001)"),
    ("WAIT 1001, -1002", "V125", "WAIT SIG(1001, -1002)"),
    ("WAIT SIG(x), SIG(y)", "V125", "WAIT SIG(x, y)"),
    ("WAIT 1001, SIG(y)", "V125", "WAIT SIG(1001, y)"),
]


@pytest.mark.parametrize(("wrong", "code", "right"), MENDED)
def test_the_edit_makes_what_was_meant(wrong: str, code: str, right: str) -> None:
    (one,) = told(wrong)
    assert one.rule.code == code
    assert one.fix is not None
    text = f".PROGRAM main(x, y, z, $a)\n{wrong}\n.END\n"
    for edit in sorted(one.fix.edits, key=lambda e: -e.span.start):
        text = text[: edit.span.start] + edit.replacement + text[edit.span.end :]
    assert text == f".PROGRAM main(x, y, z, $a)\n{right}\n.END\n"
    assert told(right) == []


@pytest.mark.parametrize(
    ("wrong", "code"),
    [
        ("WAIT x > 3 > 1", "V150"),
        ("WAIT 0 < x+1 < 5", "V150"),
        ("WAIT 0 < x < 9 AND SIG(1001)", "V150"),
        ("WAIT SIG(1001) AND SIG(-1001)", "V168"),
        ("WAIT SIG(x) OR SIG(-x)", "V239"),
        ("WAIT SIG(1001, 1002) AND NOT SIG(1002)", "V168"),
        ("WAIT (SIG(1001) == ON) AND (SIG(1001) == OFF)", "V168"),
        ("WAIT (x > 5) AND (x < 3)", "V168"),
        ("WAIT (x > 3) OR (5 > x)", "V239"),
        ("WAIT (x == 1) AND SIG(1001) AND (x > 4)", "V168"),
        ("WAIT (x > 5) AND NOT (x > 5)", "V168"),
        ("WAIT x == x", "V239"),
        ("WAIT DX(HERE) < DX(HERE)", "V168"),
    ],
)
def test_a_condition_that_is_decided_is_told_once(wrong: str, code: str) -> None:
    (one,) = told(wrong)
    assert one.rule.code == code
    assert one.help


@pytest.mark.parametrize(
    "right",
    [
        "WAIT (10 < x) AND (x < 20)",
        "WAIT (10 < x) == (y < 20)",
        "WAIT x > 3 == TRUE",
        "WAIT NOT SIG(1001) == TRUE",
        "ok = FALSE\nWAIT NOT ok == SIG(1001)",
        "ok = x > 3\nWAIT NOT ok == done",
        "WAIT NOT x",
        "WAIT (x < 3) OR (x > 5)",
        "WAIT (x >= 3) AND (x <= 3)",
        "WAIT (x <> 1) AND (x <> 2)",
        "WAIT (x == 1) OR (x == 2)",
        "WAIT (x > 1) OR (y < 5)",
        "WAIT (x == 1) AND (y == 2)",
        "WAIT SIG(1001) AND SIG(-1002)",
        "WAIT SIG(x) OR SIG(-y)",
        "WAIT (RANDOM > 0.5) AND (RANDOM < 0.5)",
        "WAIT (SIG(1001) AND SIG(1002)) OR (SIG(-1001) AND SIG(-1002))",
        "WAIT TRUE AND SIG(1001)",
        "WHILE TRUE DO\nREADY\nEND",
        'WAIT ($a <> "y") AND ($a <> "n")',
    ],
)
def test_conditions_that_ask_what_they_say_are_not_told(right: str) -> None:
    assert told(right) == []


def test_time_is_not_offered_where_a_signal_is_named() -> None:
    assert told("WAIT 1001")[0].help == ("to wait for a signal write `WAIT SIG(1001)`",)
    assert "DELAY 5" in told("WAIT 5")[0].help[0]
