"""The first screen says in what a program is ready for the real robot, or why it is not."""

from pathlib import Path

import pytest

from tests.unit.pipeline.test_proof_of_task import WAITS, assessed, written
from vrts.pipeline.files import CHECKOUT
from vrts.pipeline.settings import load_task
from vrts.report.assessment import Assessment
from vrts.report.first_screen import FINE, first_screen
from vrts.report.formats.json_form import assessment_json
from vrts.report.page.page import page
from vrts.report.screen.assessment_text import assessment_text

CANS = CHECKOUT / "examples" / "01-cans-on-bases"
SOLUTION = (CANS / "solution.v2").read_text("utf-8")


def told(a: Assessment) -> str:
    """Return what the terminal says of it; the page has to say the same."""
    (line,) = (
        row.removeprefix("ready for the real robot: ")
        for row in assessment_text(a, color=False).split("\n")
        if row.startswith("ready for the real robot: ")
    )
    return line


def test_a_run_speaks_of_its_scenario_alone() -> None:
    a = assessed(load_task(CANS), SOLUTION)
    assert told(a) == "yes, in this scenario"
    assert "</b>, in this scenario" in page(a, {})
    assert assessment_json(a)["ready_in"] == "this scenario"


@pytest.mark.thorough
def test_a_proof_speaks_of_every_future(tmp_path: Path) -> None:
    a = assessed(load_task(written(tmp_path)), WAITS)
    assert told(a) == "yes, in every future"
    assert assessment_json(a)["ready_in"] == "every future"


def test_a_step_behind_a_semicolon_is_told_although_nothing_was_lost() -> None:
    text = SOLUTION.replace(
        '        TYPE "Both', '        MOVE safe ; MOVES safe\n        TYPE "Both'
    )
    a = assessed(load_task(CANS), text)
    screen = first_screen(a)
    assert screen.cause in FINE
    assert not screen.ready
    assert told(a).startswith("no: line 9, what stands behind `;` is a remark")
    assert "is a remark" in page(a, {})
    assert a.grade is not None
    assert a.grade.mark == a.grade.total


def test_a_cause_that_was_told_is_not_told_twice() -> None:
    a = assessed(load_task(CANS), SOLUTION.replace("        MOVES goal\n", ""))
    assert told(a) == "no"
    assert assessment_json(a)["ready_in"] is None
