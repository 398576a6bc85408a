"""What is told of a program with several repairs is what a teacher would say of it."""

import pytest

from tests.golden.examples import EXAMPLES
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.mending.behaviour import mended
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task
from vrts.repair.ranking import standing_out


@pytest.mark.thorough
def test_a_way_through_the_roof_is_not_mended_by_a_rounded_corner() -> None:
    """Without BREAK the corner happens to pass: that is luck, and the step before it is wrong."""
    example = next(each for each in EXAMPLES if each.name.startswith("04"))
    program = example / "submissions" / "down-into-the-oven.v2"
    request = Request(
        ProgramFile(program.read_bytes(), program.name), load_task(example / "task.toml")
    )
    best = standing_out(mended(request).repairs)
    assert best is not None
    assert best.change.old == "APPROS baked, 150"
    assert best.change.new == "MOVES baked"


def test_the_hand_that_is_closed_at_the_start_is_opened_at_the_start() -> None:
    """The first program opens it: not the one that is called and opens it again and again."""
    example = EXAMPLES[0]
    right = (example / "solution.v2").read_text()
    wrong = right.replace("        OPENI ", "        ; OPENI ", 1)
    assert wrong != right
    found = mended(Request(ProgramFile(wrong.encode(), "p.v2"), load_task(example / "task.toml")))
    best = found.repairs[0].change
    assert best.new == "OPENI"
    at = right[: right.index("OPENI")].count("\n") + 1
    assert best.line in (at, at + 1)
