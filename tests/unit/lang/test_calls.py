"""Calls that do not fit their program, names that are almost others: told once, and mended."""

import pytest

from tests.mistakes import compiled, said

FETCH = """.PROGRAM fetch(where, high)
        APPRO where, high
        MOVES where
.END
.PROGRAM show(t[])
        TYPE t[1]
.END
.PROGRAM grip
        CLOSEI
.END
.LOCATIONS
feeder 450 -120 -250 90 90 0
#safe 0 -90 180 0 90 0
.END
"""


def program(step: str) -> str:
    """Return a program of one step, and others to call."""
    return f".PROGRAM main\n        h[1] = 5\n        {step}\n.END\n{FETCH}"


def mended(wrong: str) -> str:
    """Return a program after the edit of its one diagnostic."""
    (found,) = said(compiled(wrong))
    assert found.fix is not None
    start, end = found.fix.span.start, found.fix.span.end
    return wrong[:start] + found.fix.replacement + wrong[end:]


@pytest.mark.parametrize(
    ("step", "meant"),
    [
        ("CALL fetch(60, feeder)", "CALL fetch(feeder, 60)"),
        ("CALL fetch, feeder, 60", "CALL fetch(feeder, 60)"),
        ("CALL fetch feeder, 60", "CALL fetch(feeder, 60)"),
        ("CALL show(h)", "CALL show(h[])"),
        ("EXECUTE grip", "CALL grip"),
        ("REACTI 1003, grip(1)", "REACTI 1003, grip"),
        ("MOVE safe", "MOVE #safe"),
        ("MOVE #feeder", "MOVE feeder"),
        ("#n = 3", "n = 3"),
    ],
)
def test_a_step_that_is_almost_right_is_mended(step: str, meant: str) -> None:
    """One message on the line, and its edit."""
    assert mended(program(step)) == program(meant)
    assert said(compiled(program(meant))) == []


@pytest.mark.parametrize(
    ("step", "says"),
    [
        ("CALL fetch(feeder, 60, 2)", "fetch(feeder, 60)"),
        ("CALL fetch(feeder)", "fetch(where, high)"),
        ("CALL fetch", "fetch(where, high)"),
        ("CALL feeder", "MOVE feeder"),
        ("MOVE grip", "CALL grip"),
        ("TYPE done", '"done"'),
        ("MOVE part two", "part_two"),
        ("WHERE", "HERE"),
    ],
)
def test_help_says_what_to_write(step: str, says: str) -> None:
    """One message, on the line of the step."""
    found = said(compiled(program(step)))
    assert [d.primary.span.line for d in found if d.primary is not None] == [3]
    assert says in found[0].help[0]


def test_an_argument_that_a_program_asks_for_may_be_left_out() -> None:
    """DEFINED says that the program knows, and a formal that gets its value needs none."""
    asks = FETCH.replace("APPRO where, high", "IF NOT DEFINED(high) THEN\n high = 50\n END")
    assert said(compiled(f".PROGRAM main\n        CALL fetch(feeder)\n.END\n{asks}")) == []


def test_a_program_is_not_named_as_an_instruction() -> None:
    """At its header, once."""
    text = ".PROGRAM main\n        CALL close\n.END\n.PROGRAM close\n        CLOSEI\n.END\n"
    assert [(d.rule.code, d.primary and d.primary.span.line) for d in said(compiled(text))] == [
        ("V160", 4)
    ]


def test_returne_of_a_program_that_is_called_is_told_unless_there_is_reacte() -> None:
    """With REACTE any program may be the one for errors."""
    text = (
        ".PROGRAM main\n        CALL b\n.END\n.PROGRAM b\n        CLOSEI\n        RETURNE\n.END\n"
    )
    assert mended(text) == text.replace("RETURNE", "RETURN")
    assert said(compiled(text.replace("CALL b", "REACTE b\n        CALL b"))) == []


def test_long_names_that_are_cut_to_the_same_are_told_once() -> None:
    """Where a program uses the first of them, and not again in the data."""
    names = ("assembly_station_left", "assembly_station_right")
    steps = "".join(f"        MOVE {name}\n" for name in names)
    data = "".join(f"{name} 500 0 -200 90 90 0\n" for name in names)
    text = f".PROGRAM main\n{steps}.END\n.LOCATIONS\n{data}.END\n"
    assert [(d.rule.code, d.primary and d.primary.span.line) for d in said(compiled(text))] == [
        ("V212", 2)
    ]
