"""A value set by hand is written back to the one literal that decides it, and to no other place."""

from pathlib import Path

import pytest

from tests.unit.debug.editing.test_text import opened_session
from tests.unit.debug.scripted.test_commands import refused, said
from vrts.cli.shared.console import write_file
from vrts.debug.dap.arguments import Fields
from vrts.debug.dap.editing import EDITING
from vrts.debug.dap.session import Session as Client
from vrts.debug.files import Files
from vrts.debug.scripted.commander import carry_out
from vrts.debug.scripted.session import Session

TEXT = """.PROGRAM main()
 x = 3            ; three \xb0
 SET g = TRANS(900, 30, 100, 90, 90, 0)
 $s = "hello"
 MOVE far
 y = x+1
 MOVE g
 MOVE near
.END
.LOCATIONS
far 700 300 0 90 90 0
near  700.00 250 0 90 90 0  ; n
.END
.REALS
w 2
.END
"""
BYTES = TEXT.replace("\n", "\r\n").encode("latin-1")


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "prog.v2"
    path.write_bytes(BYTES)
    return path


@pytest.fixture
def s(program: Path) -> Session:
    found = opened_session(program)
    found.write = write_file
    carry_out(found, "to 6")
    return found


@pytest.mark.parametrize(
    ("given", "before", "after"),
    [
        ("x = 5.5", " x = 3   ", " x = 5.5   "),
        ("g = 900 31 100 90 90 0", "TRANS(900, 30, 100,", "TRANS(900, 31, 100,"),
        ('$s = "hi"', '"hello"', '"hi"'),
        ("near = 700 260.25 10 90 90 0", "near  700.00 250 0", "near  700.00 260.25 10"),
        ("w = 0.25", "w 2", "w 0.25"),
    ],
)
def test_the_literal_is_shown_then_written_in_the_bytes_of_the_file(
    s: Session, program: Path, given: str, before: str, after: str
) -> None:
    said(s, f"set {given}")
    shown = said(s, "keep")
    assert shown.startswith("--- prog.v2")
    assert program.read_bytes() == BYTES
    name = given.partition(" = ")[0]
    assert "written to prog.v2" in said(s, f"keep {name} yes")
    wanted = TEXT.replace(before, after)
    assert wanted != TEXT
    assert program.read_bytes() == wanted.replace("\n", "\r\n").encode("latin-1")
    assert s.debugger.tree.current.by.value == "text"
    assert s.console.files is not None
    assert s.console.files.news() == ""


def test_what_no_literal_decides_is_refused_with_the_reason(s: Session, program: Path) -> None:
    assert "set x = 5" in refused(s, "keep")
    said(s, "set y = 9")
    carry_out(s, "at end")
    said(s, "set y = 10")
    assert refused(s, "keep") == "line 6 `y = x+1` works `y` out: no literal decides it alone"
    said(s, "set q = 1")
    assert "no literal to change" in refused(s, "keep")
    said(s, "set x = 3")
    assert "this value already" in refused(s, "keep x")
    assert program.read_bytes() == BYTES


def test_a_file_that_has_changed_is_never_overwritten(s: Session, program: Path) -> None:
    said(s, "set x = 4")
    program.write_bytes(BYTES + b"; mine\r\n")
    assert "nothing is written" in refused(s, "keep yes")
    assert program.read_bytes() == BYTES + b"; mine\r\n"
    program.unlink()
    assert "nothing is written" in refused(s, "keep yes")
    assert not program.exists()


def test_a_file_that_cannot_be_written_is_as_it_was(s: Session, program: Path) -> None:
    def full(path: Path, data: bytes) -> None:
        raise OSError(28, "No space left on device")

    said(s, "set x = 4")
    s.write = full
    assert "no space left" in refused(s, "keep yes")
    s.write = None
    assert "a script changes no file" in refused(s, "keep yes")
    assert program.read_bytes() == BYTES


def test_an_editor_gets_the_edits_and_carries_them_out(s: Session, program: Path) -> None:
    said(s, "set x = 4")
    client = Client(s.debugger, s.console, Files([program]))
    answer = EDITING["vrts/keep"](client, Fields({"name": "x"}))
    (edit,) = answer.body["edits"]
    assert (edit["line"], edit["column"], edit["endColumn"], edit["text"]) == (2, 6, 7, "4")
    assert program.read_bytes() == BYTES


CALLS = """.PROGRAM main()
 x = 3
 m = 0
 CALL twice(5, m, "hi, you")
 CALL twice(x, m, "no")
 CALL twice(x+1, m, "no")
 TYPE m
.END
.PROGRAM twice(a, b, $c)
 AUTO n
 n = 2
 b = a*n
 b = b+0
.END
"""


@pytest.mark.parametrize(
    ("times", "given", "before", "after"),
    [
        (1, "a = 7", "twice(5, m", "twice(7, m"),
        (1, '$c = "ho"', 'm, "hi, you")', 'm, "ho")'),
        (1, "n = 4", " n = 2", " n = 4"),
        (2, "a = 9", " x = 3", " x = 9"),
    ],
)
def test_an_argument_is_written_where_its_call_or_its_variable_has_the_literal(
    tmp_path: Path, times: int, given: str, before: str, after: str
) -> None:
    path = tmp_path / "calls.v2"
    path.write_text(CALLS)
    s = opened_session(path)
    s.write = write_file
    for _ in range(times):
        carry_out(s, "to 12")
    said(s, f"set {given}")
    name = given.partition(" = ")[0]
    assert f"`keep {name} yes` writes it" in said(s, "keep")
    said(s, f"keep {name} yes")
    assert path.read_text() == CALLS.replace(before, after)


def test_an_argument_that_is_worked_out_is_refused_with_the_call(tmp_path: Path) -> None:
    path = tmp_path / "calls.v2"
    path.write_text(CALLS)
    s = opened_session(path)
    for _ in range(3):
        carry_out(s, "to 12")
    said(s, "set a = 9")
    assert "gives `a` the value of `x+1`: that is no literal" in refused(s, "keep")
    assert path.read_text() == CALLS
