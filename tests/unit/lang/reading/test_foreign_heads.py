"""Programs that begin and end as in other languages, and what stands above them."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.mending import edits_of, with_edits

MAIN = ".PROGRAM main\nCALL grip\n.END\n"


@pytest.mark.parametrize(
    ("head", "end"),
    [
        ("def grip():", ".END"),
        ("SUB grip", "END SUB"),
        ("PROCEDURE grip", ".END"),
        ("void grip() {", "}"),
        ("function grip", "end"),
    ],
)
def test_a_program_of_another_language_is_a_program(head: str, end: str) -> None:
    text = f"{MAIN}{head}\nCLOSEI\n{end}\n"
    found = said(compiled(text))
    assert found[0].headline.startswith(f"`{head.split()[0]}` begins no program")
    mended = with_edits(text, edits_of(found))
    name = "grip()" if "(" in head else "grip"
    assert mended == f"{MAIN}.PROGRAM {name}\nCLOSEI\n.END\n"
    assert said(compiled(mended)) == []


@pytest.mark.parametrize(
    "line", ["import math", "# my program", "// my program", "VAR n : INTEGER;"]
)
def test_what_stands_above_a_program_is_told_once(line: str) -> None:
    (found,) = said(compiled(f"{line}\n.PROGRAM main\nREADY\n.END\n"))
    assert found.fix is not None
    assert "outside" not in found.headline


def test_a_value_given_outside_of_programs_is_told_once() -> None:
    (found,) = said(compiled("n = 5\n.PROGRAM main\nTYPE n\n.END\n"))
    assert found.headline == "this step stands outside any program"
