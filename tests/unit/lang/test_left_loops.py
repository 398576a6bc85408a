"""BREAK that was to leave a loop, VALUE that is never chosen, and states among signals."""

import pytest

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.lang.compiler import compile_source

HEAD = ".PROGRAM main(k, stop, $a)\n"
CODES = ("V167", "V223", "V230")


def told(lines: str) -> list[Diagnostic]:
    text = f"{HEAD}{lines}\n.END\n.LOCATIONS\np 500 0 -100 90 90 0\n.END\n"
    return [
        d for d in compile_source(SourceFile("main.v2", text)).diagnostics if d.rule.code in CODES
    ]


def mended(lines: str) -> str:
    text = f"{HEAD}{lines}\n.END\n"
    edits = [e for d in told(lines) if d.fix for e in d.fix.edits]
    for edit in sorted(edits, key=lambda e: -e.span.start):
        text = text[: edit.span.start] + edit.replacement + text[edit.span.end :]
    return text.removeprefix(HEAD).removesuffix("\n.END\n")


def searching(test: str, head: str = "FOR i = 1 TO 8", foot: str = "END", step: str = "") -> str:
    return f"{head}\nMOVE p\nn = n+1\n{step}IF {test} THEN\nBREAK\nEND\n{foot}\nREADY"


@pytest.mark.parametrize(
    "lines",
    [
        searching("SIG(1006)"),
        searching("NOT SIG(1006)", "WHILE SIG(1001) DO"),
        searching("n == 5", "DO", "UNTIL SIG(1001)"),
        searching("TIMER(1) > 5"),
        searching("DZ(HERE) < 100"),
        searching("(k == 3) AND SIG(1006)"),
    ],
)
def test_break_that_was_to_leave_a_loop_is_told_with_the_jump(lines: str) -> None:
    (one,) = told(lines)
    assert one.rule.code == "V167"
    assert "GOTO 100" in one.help[0]
    assert one.fix is not None
    assert not one.fix.sure
    assert mended(lines) == lines.replace("BREAK", "GOTO 100").replace("READY", "100 READY")
    assert told(mended(lines)) == []


def test_break_leads_to_the_label_that_nothing_jumps_to() -> None:
    (one,) = (
        d
        for d in told(searching("SIG(1006)") + '\nRETURN\n50 TYPE "found"')
        if d.rule.code == "V167"
    )
    assert one.help == ("to leave the loop write `IF SIG(1006) GOTO 50`",)


@pytest.mark.parametrize(
    "lines",
    [
        searching("i == 3"),
        searching("(i MOD 3) == 0"),
        searching("stop[i]"),
        searching("stop"),
        searching("k == 2"),
        searching("(n MOD 3) == 0"),
        "IF SIG(1006) THEN\nBREAK\nEND\nREADY",
        "FOR i = 1 TO 3\nIF SIG(1006) THEN\nMOVE p\nBREAK\nEND\nSIGNAL 2\nEND",
        "FOR i = 1 TO 3\nIF SIG(1006) THEN\nBREAK\nCLOSEI\nEND\nEND",
        "FOR i = 1 TO 3\nMOVE p\nBREAK\nSIGNAL 2\nEND",
    ],
)
def test_break_that_waits_for_the_arm_is_not_told(lines: str) -> None:
    assert told(lines) == []


@pytest.mark.parametrize(
    ("values", "place"),
    [
        ("VALUE 1, 2:\nREADY\nVALUE 2:\nOPENI", "2"),
        ("VALUE 1:\nREADY\nVALUE 2:\nOPENI\nVALUE 1.0:\nCLOSEI", "1.0"),
        ("VALUE -1, 3, -1:\nREADY", "-1"),
        ("VALUE stop:\nREADY\nVALUE STOP:\nOPENI", "STOP"),
    ],
)
def test_a_value_twice_is_told_at_the_second_place(values: str, place: str) -> None:
    (one,) = told(f"CASE k OF\n{values}\nEND")
    assert one.primary is not None
    assert one.primary.span.text == place
    assert len(one.secondary) == 1


def test_values_of_two_cases_are_not_compared() -> None:
    inner = "CASE stop OF\nVALUE 1:\nREADY\nVALUE 2:\nOPENI\nEND"
    assert told(f"CASE k OF\nVALUE 1:\n{inner}\nVALUE 2:\nCLOSEI\nEND") == []


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        ("SIGNAL 5, OFF", "SIGNAL -5"),
        ("SIGNAL 5, ON", "SIGNAL 5"),
        ("SIGNAL k, FALSE", "SIGNAL -k"),
        ("SIGNAL ON, 4", "SIGNAL 4"),
        ("SIGNAL 1, 2, OFF", "SIGNAL -1, -2"),
        ("SIGNAL 5, 0", "SIGNAL -5"),
        ("SIGNAL NOT 4", "SIGNAL -4"),
    ],
)
def test_states_among_signals_are_mended(wrong: str, right: str) -> None:
    (one,) = told(wrong)
    assert one.rule.code == "V230"
    assert mended(wrong) == right
    assert told(right) == []


def test_one_behind_a_signal_is_a_state_only_where_zero_is() -> None:
    """`SIGNAL 4, 1` sets two signals, unless the writer also writes `SIGNAL 4, 0`."""
    assert told("SIGNAL 4, 1") == []
    assert [d.help[0] for d in told("SIGNAL 4, 1\nSIGNAL 4, 0")] == [
        "write `SIGNAL 4`",
        "write `SIGNAL -4`",
    ]
