"""Handles of a program's locations: where they stand, and why some cannot be dragged."""

from typing import Any

import pytest

from tests.support_programs import compiled, ran
from vrts.ir.module import Module
from vrts.report.locations.rows import BASE, JOINTS, location_rows

MANY = """.PROGRAM main()
        MOVE a
        SET pallet = SHIFT(a BY 0, 100, 0)
        MOVES pallet:slot
        MOVE #p
        HERE b
        CALL sub(a, c, frame:near)
        MOVE row[1]
        TOOL tool1
.END
.PROGRAM sub(x, y, z)
        SET y = x
        MOVE z
.END
.LOCATIONS
a 700 -150.5 0 90 90 0
b 700 -150 0 90 90 0
c 700 -150 0 90 90 0
slot 0 10 20 0 0 0
frame 700 100 0 90 90 0
near 10 0 0 0 0 0
tool1 0 0 100 0 0 0
#p 0 -90 90 0 45 0
row[1] 600 200 0 90 90 0
.END
"""


def rows(text: str, unwritable: str = "") -> dict[str, Any]:
    module: Module = compiled(text, "val2+")
    run = ran(text)
    return {str(row["name"]): row for row in location_rows(module, run, lambda _: unwritable)}


@pytest.fixture(scope="module")
def many() -> dict[str, Any]:
    return rows(MANY)


def test_places_that_a_program_goes_to_can_be_dragged(many: dict[str, Any]) -> None:
    draggable = [name for name, row in many.items() if not row["why"]]
    assert draggable == ["a", "frame", "row[1]"]
    a = many["a"]
    assert (a["numbers"], a["X"][9:], a["line"]) == ([700, -150.5, 0], [0.7, -0.1505, 0.0], 16)
    assert (many["row[1]"]["of"], many["row[1]"]["subscripts"]) == ("row", [1])


def test_the_others_say_why_not_and_stand_where_the_program_has_them(many: dict[str, Any]) -> None:
    why = {name: row["why"] for name, row in many.items() if row["why"]}
    assert why == {
        "b": "line 6 of the program gives it another value",
        "c": "line 12 of the program gives it another value",  # by its argument
        "slot": "it is relative to `pallet`",
        "near": "it is relative to `frame`",
        "#p": JOINTS,
        "pallet": "line 3 works it out",
    }
    assert many["slot"]["X"][9:] == pytest.approx([0.7, -0.0405, -0.02]), "behind its frame"
    assert many["pallet"]["X"][9:] == pytest.approx([0.7, -0.0505, 0.0]), "as it was worked out"
    assert many["c"]["X"][9:] == many["a"]["X"][9:], "the value that it was given"
    assert "tool1" not in many, "it is no place"


def test_files_that_cannot_be_written_and_bases_that_move_are_reasons() -> None:
    text = ".PROGRAM main\n{}\n MOVE a\n.END\n.LOCATIONS\na 700 0 0 90 90 0\n.END\n"
    assert rows(text.format(""), "`a.lc` is write-protected")["a"]["why"].endswith("protected")
    moved = rows(text.format(" BASE 100, 0, 0, 0"))["a"]
    assert moved["why"] == BASE
    assert moved["X"][9:] == pytest.approx([0.6, 0.0, 0.0])
