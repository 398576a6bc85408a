"""Numbers in another unit than that of the language are told, and sensible ones are not."""

import pytest

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.lang.compiler import compile_source

DATA = ".LOCATIONS\np 500 0 -100 90 90 0\nq 400 0 -100 90 90 0\n.END\n"


def told(lines: str, data: str = DATA) -> list[Diagnostic]:
    text = f".PROGRAM main\n{lines}\n.END\n{data}"
    found = compile_source(SourceFile("main.v2", text)).diagnostics
    return [d for d in found if d.rule.code in ("V169", "V234", "V235", "V239")]


def mended(lines: str) -> str:
    """Return the lines after the edits of what is told of them."""
    text = f".PROGRAM main\n{lines}\n.END\n{DATA}"
    edits = [e for d in told(lines) if d.fix for e in d.fix.edits]
    for edit in sorted(edits, key=lambda e: -e.span.start):
        text = text[: edit.span.start] + edit.replacement + text[edit.span.end :]
    return text[len(".PROGRAM main\n") : text.index("\n.END")]


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        ("DELAY 500", "DELAY 0.5"),
        ("DELAY 150", "DELAY 0.15"),
        ("DELAY 3000", "DELAY 3"),
        ("TIMER 1 = -1500", None),
        ("TIMER 1 = 1500", "TIMER 1 = 1.5"),
        ("WAIT SIG(1001) OR (TIMER(1) > 3000)", "WAIT SIG(1001) OR (TIMER(1) > 3)"),
        ("WAIT 250 < TIMER(2)", "WAIT 0.25 < TIMER(2)"),
        ("n = 2000\nDELAY n", None),
        (
            "t = TIMER(1)\nIF t > 500 THEN\nTYPE t\nEND",
            "t = TIMER(1)\nIF t > 0.5 THEN\nTYPE t\nEND",
        ),
        ("MOVE TRANS(500, 0, -100, 1.5708, 1.5708, 0)", "MOVE TRANS(500, 0, -100, 90, 90, 0)"),
        ("MOVE TRANS(500, 0, -100, 0, 3.1416, 0)", "MOVE TRANS(500, 0, -100, 0, 180, 0)"),
        ("MOVE p:RX(-1.57)", "MOVE p:RX(-90)"),
        ("MOVE #PPOINT(0, -1.57, 1.57, 0, 0.785, 0)", "MOVE #PPOINT(0, -90, 90, 0, 45, 0)"),
        ("DRIVE 2, 1.57, 50", "DRIVE 2, 90, 50"),
        ("TYPE SIN(1.571)", "TYPE SIN(90)"),
        ("a = 1.5708\nMOVE TRANS(500, 0, -100, a, 90, 0)", None),
        ("SPEED 0.5 ALWAYS", None),
        ("v = 0.5\nSPEED v", None),
    ],
)
def test_another_unit_is_told_once_and_mended_where_it_is_written(
    wrong: str, right: str | None
) -> None:
    """An edit is there where the number stands in the step; else the help says what to write."""
    (one,) = told(wrong)
    assert one.help
    assert (one.fix is None) is (right is None)
    if right is not None:
        assert mended(wrong) == right
        assert told(right) == []


@pytest.mark.parametrize(
    "right",
    [
        "DELAY 60",
        "DELAY 100",
        "DELAY 120",
        "DELAY 300",
        "DELAY 3600",
        "DELAY 500/1000",
        "DELAY 150.5",
        "WAIT TIMER(1) > 90",
        "WAIT 1000*TIMER(1) > 3000",
        "n = 500\nIF n > 400 THEN\nTYPE n\nEND",
        "MOVE TRANS(512.31, 14.02, -88.5, 1.57, 88.91, -0.42)",
        "MOVE TRANS(500, 0, -100, 90, 1.5, 0)",
        "DRIVE 2, 1.5, 50",
        "TYPE SIN(3.14)",
        "SPEED 20\nMOVE p\nSPEED 0.5",
        "SPEED 1",
        "SPEED 0.5 IPS",
        "FOR a = 0 TO 360 STEP 6\nTYPE COS(a)\nEND",
        "FOR a = 0 TO 2*PI STEP 0.1\nTYPE COS(a*180/PI)\nEND",
        "FOR a = 0 TO 3 STEP 0.1\nTYPE COS(a)\nEND",
        "FOR a = 0 TO 2*PI STEP 0.1\nTYPE 50*a\nEND",
    ],
)
def test_numbers_that_may_be_meant_are_not_told(right: str) -> None:
    assert told(right) == []


@pytest.mark.parametrize(
    ("wrong", "help_"),
    [
        (
            "FOR a = 0 TO 2*PI STEP 0.1\nTYPE 50*COS(a)\nEND",
            "write `FOR a = 0 TO 360 STEP 6`",
        ),
        ("FOR a = 0 TO 6.28 STEP PI/18\nTYPE SIN(a)\nEND", "write `FOR a = 0 TO 360 STEP 10`"),
        (
            "a = 0\nWHILE a < 2*PI DO\nTYPE COS(2*a)\na = a+0.1\nEND",
            "write `360`, and let `a` grow by degrees",
        ),
        (
            "a = 0\nDO\na = a+0.1\nTYPE TAN(-a)\nUNTIL PI <= a",
            "write `180`, and let `a` grow by degrees",
        ),
    ],
)
def test_loops_that_turn_in_radians_are_told_at_their_end(wrong: str, help_: str) -> None:
    (one,) = told(wrong)
    assert one.help == (help_,)


def test_typed_locations_in_radians_are_told_and_taught_ones_are_not() -> None:
    """Taught angles are seldom round, so one of them may be 1.571 by chance."""
    data = (
        ".LOCATIONS\np 500 0 -100 1.5708 1.5708 0\nq 512.3 3.1 -88.2 1.571 88.913 -0.402\n"
        "#r 0 -1.57 90 0 0 0\n.END\n"
    )
    found = told("MOVE p\nMOVE q\nMOVE #r", data)
    assert [d.help for d in found] == [("write `90`",), ("write `-90`",)]
    assert [d.primary and d.primary.span.text for d in found] == ["1.5708", "-1.57"]
