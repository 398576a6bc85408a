"""Steps by themselves, files with bad lines, and what programs refer to."""

import pytest

from vrts.base.source import SourceFile
from vrts.lang.dialect import AS, VAL2, VAL2_PLUS
from vrts.lang.typed.entry import check_alone, check_step, references
from vrts.lang.typed.loading import contents


@pytest.mark.parametrize("text", ["READY", "100 MOVE part ; go", "100", "", "; only words", "END"])
def test_good_steps(text: str) -> None:
    assert check_step(text, VAL2) == ()


@pytest.mark.parametrize(
    ("text", "code"),
    [("MOVEE part", "V120"), ("MOVE", "V124"), (".END", "V522"), ("x = " + "1+" * 200, "V105")],
)
def test_bad_steps(text: str, code: str) -> None:
    assert [d.rule.code for d in check_step(text, VAL2)] == [code]


@pytest.mark.parametrize(
    "text",
    ["FOR i = 1 TO 3", "END", "ELSE", "GOTO 10", "IF x GOTO 10", "RETURN", "10 READY", "CASE n OF"],
)
def test_what_needs_its_program_is_not_done_alone(text: str) -> None:
    (found,) = check_alone(text, VAL2)
    assert found.rule.code == "V522"
    assert found.notes == ("VAL-II says *Illegal in DO*",)


@pytest.mark.parametrize("text", ["READY", "CALL pick", "n = n+1", "HALT"])
def test_instructions_that_stand_alone(text: str) -> None:
    assert check_alone(text, VAL2) == ()


def test_references_tell_programs_and_variables_apart() -> None:
    lines = (
        "CALL pick(n, part)",
        'CALLS "place"',
        "REACT 1001, alarm",
        "MOVES tray:grip",
        "FOR i = 1 TO last[n]",
        "MOVEE odd",  # cannot be read: its names may be anything
    )
    found = references(lines, VAL2_PLUS)
    assert found.programs == {"pick", "place", "alarm", "odd", "movee"}
    assert found.variables >= {"n", "part", "tray", "grip", "i", "last", "odd"}
    assert "pick" not in found.variables


TEXT = """\
; a file
.PROGRAM Pick.one(n, $s) ; comment
  MOVEE part

  ; a comment
READY
.END
.LOCATIONS
part 1 2 3
bad one
.END
.PROGRAM b
.END
"""


def test_a_file_is_read_with_its_bad_lines() -> None:
    found = contents(SourceFile("f.v2", TEXT), VAL2)
    first, second = found.programs
    assert first.header == ".PROGRAM pick.one(n, $s)"
    assert first.lines == ("  MOVEE part", "", "  ; a comment", "READY")
    assert (second.name, second.lines) == ("b", ())
    assert [(d.name, d.span.line) for d in found.data] == [("part", 9)]
    assert [d.primary.span.line for d in found.diagnostics if d.is_error and d.primary] == [10]


def test_steps_outside_any_program_become_one() -> None:
    found = contents(SourceFile("f.v2", "READY\nMOVE a\n"), VAL2)
    assert [p.name for p in found.programs] == ["main"]
    assert found.programs[0].lines[:2] == ("READY", "MOVE a")


def test_headers_of_as_lose_date_and_number() -> None:
    (program,) = contents(SourceFile("f.as", ".PROGRAM p(.a)@24/01/01 #3\n.END\n"), AS).programs
    assert program.header == ".PROGRAM p(.a)"
