"""A program that does the same everywhere but once is told of that place, not of another."""

from functools import cache

import pytest

from tests.golden.examples import EXAMPLES
from vrts.base.source import SourceFile
from vrts.check.rules.hints import Hints
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.mending.behaviour import Mended, mended
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task
from vrts.repair.ranking import standing_out
from vrts.repair.visits import Part, oddness, visits
from vrts.repair.written import read

RIGHT = (EXAMPLES[0] / "solution.v2").read_text()
APPROACH = "        APPRO goal, 120\n"
SWAPPED = {  # what stands in the solution of the first example, and out of order
    "        OPENI                           ; let go only now: the can stands\n": "",
    "        MOVES goal\n": "        OPENI\n        MOVES goal\n",
}


@cache
def told(example: int, submission: str) -> Mended:
    """Return what would mend a submission of an example, for those who mark."""
    folder = EXAMPLES[example]
    program = folder / "submissions" / f"{submission}.v2"
    request = Request(
        ProgramFile(program.read_bytes(), program.name), load_task(folder / "task.toml")
    )
    return mended(request, hints=Hints.EDIT)


def first_of(text: str) -> tuple[int, str, str]:
    """Return the line, the old and the new text of what mends a program of the first example."""
    request = Request(ProgramFile(text.encode(), "p.v2"), load_task(EXAMPLES[0] / "task.toml"))
    change = mended(request).repairs[0].change
    return change.line, change.old, change.new


def odd(text: str) -> float:
    """Return how far a program is from its own habits."""
    return oddness(read(SourceFile("p.v2", text)))


def swapped() -> str:
    """Return the solution with the hand opened before the place is reached."""
    text = RIGHT
    for before, after in SWAPPED.items():
        text = text.replace(before, after, 1)
    return text


def test_the_visits_of_a_program_are_its_steps_at_one_place() -> None:
    found = visits(read(SourceFile("p.v2", RIGHT)))
    assert [visit.target for visit in found] == ["start", "goal"]
    usual = [Part.APPROACH, Part.SPEED, Part.PLACE, Part.HAND, Part.LEAVE]
    assert [[stop.part for stop in visit.stops] for visit in found] == [usual, usual]


def test_whatever_one_place_lacks_or_has_otherwise_makes_a_program_odder() -> None:
    wrong = (
        RIGHT.replace(APPROACH, ""),
        RIGHT.replace("MOVES goal", "MOVE goal"),
        RIGHT.replace("APPRO goal", "APPRO start"),
        RIGHT.replace("DEPARTS 200", "DEPARTS 20"),
        swapped(),
    )
    assert all(odd(text) > odd(RIGHT) for text in wrong)


def test_the_approach_that_one_place_lacks_is_told_and_no_other_way_to_it() -> None:
    """MOVE for MOVES earns the full mark, too: by luck, for a joint motion comes from above."""
    wrong = RIGHT.replace(APPROACH, "")
    assert wrong != RIGHT
    line = RIGHT[: RIGHT.index(APPROACH)].count("\n") + 1
    assert first_of(wrong) == (line, "", "APPRO goal, 120")


def test_steps_out_of_order_are_put_in_the_order_of_the_other_place() -> None:
    line, old, new = first_of(swapped())
    at = RIGHT[: RIGHT.index("        MOVES goal")].count("\n") + 1
    assert abs(line - at) <= 1
    assert old == new


def test_what_the_examples_submissions_are_told_does_not_mislead() -> None:
    found = {
        (1, "lets-go-too-early"): ((13, "put:early", "put"),),
        (1, "grips-the-middle"): ((2, "stand_mid", "stand_mid:rim"), (21, "-330.00", "-227")),
        (1, "hand-stays-down"): ((2, "stand_flat", "stand_mid"),),
        (2, "backwards"): ((14, "gap2, corner3, corner2, gap1", "gap1, corner2, corner3, gap2"),),
        (3, "loop-variable-lost"): ((8, "i", "(i)"),),
    }
    for (example, submission), parts in found.items():
        best = standing_out(told(example, submission).repairs)
        assert best is not None
        assert tuple((part.line, part.old, part.new) for part in best.change.each) == parts


@pytest.mark.thorough
def test_the_same_step_forgotten_at_every_place_is_one_mistake() -> None:
    """Both cans are dropped from where they are approached, and the hand leaves too low."""
    best = told(0, "releases-in-air").repairs[0].change
    assert [part.line for part in best.each] == [13, 14]
    assert "each place that is only approached" in best.each[0].old


def test_steps_at_no_place_and_numbers_that_are_none_are_taken() -> None:
    """A hand that moves between two steps of SPEED is a visit without a place."""
    wrong = RIGHT.replace("        MOVES goal\n", "").replace(APPROACH, "")
    wrong = wrong.replace("950.00  -130.00", "950.00  - 130.00")
    found = visits(read(SourceFile("p.v2", wrong)))
    assert [visit.target for visit in found] == ["start", ""]
    line, _, new = first_of(
        RIGHT.replace("        MOVES goal ", "        ; ").replace(APPROACH, "")
    )
    assert line in (18, 19)
    assert "goal" in new
