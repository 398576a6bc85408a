"""What a person has to decide is told by name on every medium: both marks, and why."""

from dataclasses import replace
from fractions import Fraction

import pytest

from tests.support_programs import cans, ran
from tests.support_runs import assessment
from vrts.base.source import SourceFile
from vrts.check.judge import judge
from vrts.check.mark.mark import grade
from vrts.check.task.task_file import read_task
from vrts.check.verdict import Answer
from vrts.pipeline.files import CHECKOUT
from vrts.report.assessment import Assessment
from vrts.report.formats.json_form import assessment_json, result_json
from vrts.report.review import review_of
from vrts.report.screen.assessment_text import assessment_text
from vrts.report.screen.row_text import row_text

SOLUTION = (CHECKOUT / "examples" / "01-cans-on-bases" / "solution.v2").read_text("utf-8")
TASK = """[task]
scene = "cans-on-bases"
[[goal]]
object = "can1"
on = "base2"
[[limit]]
tool_mm_s = 9000
points = 2.5
[time]
reference_s = 12
"""
DISPUTE = "palm and can1 at 2.000 s: coal measures 1.00 mm, fcl 3.00 mm"
DOUBT = "demand tool speed: the tool is no faster than 9000 mm/s: at every instant"


@pytest.fixture(scope="module")
def sure() -> Assessment:
    scene = cans()
    run = ran(SOLUTION, scene)
    task, problems = read_task(SourceFile("lab/task.toml", TASK), scene)
    assert task is not None, problems
    judgement = judge(scene, run, task)
    made = assessment()
    return replace(
        made,
        scene=scene,
        task=task,
        run=run,
        judgement=judgement,
        grade=grade(task, run, judgement),
    )


@pytest.fixture(scope="module")
def doubtful(sure: Assessment) -> Assessment:
    """The same, with a demand that cannot be told and engines that disagree."""
    task, run, judgement = sure.task, sure.run, sure.judgement
    assert task is not None
    assert run is not None
    assert judgement is not None
    assert judgement.collisions is not None
    verdicts = tuple(
        replace(v, answer=Answer.UNDETERMINED) if v.check == "demand tool speed" else v
        for v in judgement.verdicts
    )
    disputed = replace(judgement.collisions, disagreements=(DISPUTE,))
    judgement = replace(judgement, verdicts=verdicts, collisions=disputed)
    return replace(sure, judgement=judgement, grade=grade(task, run, judgement))


def test_nothing_is_to_be_reviewed_where_everything_can_be_told(sure: Assessment) -> None:
    assert review_of(sure) is None
    assert "review" not in assessment_text(sure, color=False)
    assert "review" not in row_text(sure)
    assert result_json(sure)["review"] is None


def test_marks_and_reasons_are_those_of_the_grade(doubtful: Assessment) -> None:
    review = review_of(doubtful)
    assert review is not None
    assert (review.lowest, review.highest) == (6, 10)
    assert review.range == "6.0 to 10.0"
    assert review.reasons == (DOUBT, f"two engines disagree: {DISPUTE}")


def test_the_terminal_names_them(doubtful: Assessment) -> None:
    lines = assessment_text(doubtful, color=False).split("\n")
    assert lines[2] == f"review: the mark is 6.0 to 10.0: {DOUBT}; two engines disagree: {DISPUTE}"


def test_the_list_of_a_class_has_a_row_more(doubtful: Assessment) -> None:
    first, second = row_text(doubtful).split("\n")
    assert first.startswith("10.0  submission-07.v2")
    assert second == f"      review 6.0 to 10.0: {DOUBT}; two engines disagree: {DISPUTE}"


def test_json_has_them_in_verify_and_in_grade(doubtful: Assessment) -> None:
    wanted = {
        "lowest": 6.0,
        "highest": 10.0,
        "reasons": [DOUBT, f"two engines disagree: {DISPUTE}"],
    }
    assert result_json(doubtful)["review"] == wanted
    whole = assessment_json(doubtful)
    assert whole["review"] == wanted
    collisions = whole["collisions"]
    assert isinstance(collisions, dict)
    assert collisions["disagreements"] == [DISPUTE]


def test_what_demands_cost_is_among_the_parts(sure: Assessment) -> None:
    assert sure.grade is not None
    cost = replace(sure, grade=replace(sure.grade, demands=Fraction(5, 2)))
    parts = assessment_json(cost)["parts"]
    assert isinstance(parts, dict)
    assert (parts["demands"], parts["demands_exact"]) == (2.5, "5/2")


def test_without_a_task_a_disagreement_is_told(doubtful: Assessment) -> None:
    alone = replace(doubtful, task=None, grade=None)
    review = review_of(alone)
    assert review is not None
    assert review.range is None
    assert f"review: two engines disagree: {DISPUTE}" in assessment_text(alone, color=False)
