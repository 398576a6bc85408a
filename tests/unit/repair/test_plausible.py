"""What is told of a program with several repairs is what a teacher would say of it."""

import pytest

from tests.golden.examples import EXAMPLES
from vrts.check.rules.hints import Hints
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.mending.behaviour import Mended, mended
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task
from vrts.repair.ranking import standing_out
from vrts.repair.telling import sentence


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


def of_submission(example: int, name: str) -> Mended:
    """Return what would mend a submission of an example, for those who mark."""
    folder = EXAMPLES[example]
    program = folder / "submissions" / f"{name}.v2"
    request = Request(
        ProgramFile(program.read_bytes(), program.name), load_task(folder / "task.toml")
    )
    return mended(request, hints=Hints.EDIT)


@pytest.mark.thorough
def test_a_program_goes_by_the_place_that_it_goes_by_elsewhere() -> None:
    """A straight line passes the oven by luck: the program goes by `safe` before the pizza."""
    best = standing_out(of_submission(3, "straight-across").repairs)
    assert best is not None
    assert (best.change.line, best.change.new) == (29, "MOVE safe")


@pytest.mark.thorough
def test_a_place_that_nobody_taught_is_told_by_the_step_that_goes_there() -> None:
    """`safe` in its place earns the full mark, too: by luck. Its row is missing."""
    found = of_submission(2, "forgot-a-point")
    assert standing_out(found.repairs) is None
    assert sentence(found.repairs, Hints.EDIT) == "look at line 16"


@pytest.mark.thorough
def test_a_way_over_the_walls_is_no_small_mistake_but_points_go_at_its_lines() -> None:
    found = of_submission(2, "over-the-walls")
    assert not found.repairs
    assert found.shown == (9, 11)


@pytest.mark.thorough
def test_a_demand_that_no_line_breaks_shows_at_no_line() -> None:
    """Four copies of the same steps: the task asks for one program that is called."""
    found = of_submission(3, "four-copies")
    assert not found.repairs
    assert found.shown == ()


def test_a_program_that_is_too_slow_is_told_of_its_speed() -> None:
    """A shorter way would save the time, too."""
    example = EXAMPLES[2]
    right = (example / "solution.v2").read_text()
    wrong = right.replace("SPEED 40\n", "SPEED 3.2\n", 1)
    assert wrong != right
    found = mended(Request(ProgramFile(wrong.encode(), "p.v2"), load_task(example / "task.toml")))
    assert found.repairs[0].change.old == "3.2"


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


@pytest.mark.parametrize(
    ("right", "wrong", "line"),
    [("SPEED 30\n", "SPEED 4.5\n", 14), ("DEPARTS 200 ", "DEPARTS 60 ", 17)],
    ids=["not MOVE in place of MOVES", "not a way round"],
)
def test_the_number_that_is_wrong_is_told(right: str, wrong: str, line: int) -> None:
    """Going there by the joints is quicker, and going by `safe` clears the bases, too."""
    example = EXAMPLES[0]
    text = (example / "solution.v2").read_text().replace(right, wrong, 1)
    assert wrong in text
    found = mended(Request(ProgramFile(text.encode(), "p.v2"), load_task(example / "task.toml")))
    best = standing_out(found.repairs)
    assert best is not None
    assert (best.change.line, best.change.old) == (line, wrong.split()[1])
