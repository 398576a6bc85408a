"""What each check earned adds up to the mark, for every submission of every example."""

from fractions import Fraction

import pytest

from tests.golden.examples import assessed
from vrts.check.mark.earned import not_reached
from vrts.check.mark.grade import Earned, Grade
from vrts.check.verdict import Answer
from vrts.pipeline.files import CHECKOUT
from vrts.pipeline.settings import load_task

EXAMPLES = CHECKOUT / "examples"
PROGRAMS = sorted(EXAMPLES.glob("0[14]*/submissions/*.v2"))


def graded(example: str, program: str) -> Grade:
    """Return the grade of a submission."""
    a = assessed(EXAMPLES / example / program)
    assert a.grade is not None
    return a.grade


def by_title(grade: Grade) -> dict[str, Earned]:
    """Return what was earned, by what for."""
    return {entry.title: entry for entry in grade.earned}


@pytest.mark.parametrize("name", [f"{p.parts[-3]}/{p.name}" for p in PROGRAMS])
def test_the_points_add_up_to_the_mark(name: str) -> None:
    example, program = name.split("/")
    grade = graded(example, f"submissions/{program}")
    if grade.earned:
        assert sum(entry.points for entry in grade.earned) == grade.mark
        assert sum(entry.most for entry in grade.earned) == 10
    for entry in grade.earned:
        assert entry.points <= entry.most or entry.kind == "rounding"


def test_a_reference_earns_everything() -> None:
    grade = graded("04-final-project", "solution.v2")
    assert all(entry.points == entry.most for entry in grade.earned)
    assert all(entry.answer is Answer.HOLDS for entry in grade.earned)
    assert [entry.title for entry in grade.earned if entry.kind == "target"] == [
        "can1 on base1",
        "can2 on base2",
        "can3 on base3",
        "dish on stand",
        "pizza on oven",
    ]


def test_losses_stand_at_what_they_are_about() -> None:
    found = by_title(graded("01-cans-on-bases", "submissions/hits-base.v2"))
    assert found["no contact"].points == Fraction(-3, 2)
    assert found["no contact"].answer is Answer.VIOLATED
    assert found["time"].points == 0
    found = by_title(graded("04-final-project", "submissions/cold-oven.v2"))
    broken = [entry for entry in found.values() if entry.kind == "demand" and entry.points]
    assert [(entry.title, entry.points) for entry in broken] == [
        ("must use SIGNAL", Fraction(-1, 2))
    ]
    assert broken[0].message


def test_a_program_that_cannot_run_reaches_nothing() -> None:
    setting = load_task(EXAMPLES / "04-final-project" / "task.toml")
    assert setting.task is not None
    found = not_reached(setting.task)
    whole = graded("04-final-project", "solution.v2")
    assert [(e.check, e.most) for e in found] == [(e.check, e.most) for e in whole.earned]
    assert all(e.answer is None and e.points == 0 for e in found)
