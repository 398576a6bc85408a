"""What leads out of a loop that never ends is told, not just what is asked in it."""

import pytest

from tests.support_programs import compiled
from vrts.engine.controller import execute
from vrts.pipeline.scenes import load_scene
from vrts.scene.model import Scenario
from vrts.why.chain import line
from vrts.why.loops.endless import endless
from vrts.why.slicing.executed import Steps


def told(body: str) -> list[str]:
    text = f".PROGRAM main()\n{body}.END\n"
    run = execute(compiled(text), load_scene("cans-on-bases").scene, Scenario())
    return [line(link) for link in endless(Steps(run))]


def test_the_condition_of_the_loop_is_told_and_that_nothing_changes_it() -> None:
    found = told("n = 1\nWHILE n <= 2 DO\n  IF n == 1 THEN\n    m = n+1\n  END\nEND\n")
    assert found[0] == (
        "line 3 `WHILE n <= 2 DO`: `n` is 1 here each time, and no step of the loop changes `n`"
    )
    assert found[1].endswith("line 2 `n = 1`: `n` is set to 1")


@pytest.mark.thorough
def test_what_is_changed_and_back_is_not_called_unchanged() -> None:
    found = told("n = 1\nWHILE n <= 2 DO\n  n = n+1\n  n = n-1\nEND\n")
    assert "no step of the loop changes" not in found[0]


@pytest.mark.thorough
def test_a_loop_that_nothing_leads_out_of_says_so() -> None:
    found = told("10 m = 1\nIF m == 2 THEN\n  m = 3\nEND\nGOTO 10\n")
    assert found == ["line 6 `GOTO 10`: no step leads out of this loop"]


@pytest.mark.thorough
def test_an_output_that_was_switched_is_told_with_the_step() -> None:
    found = told("SIGNAL 5\n10 IF SIG(5) GOTO 10\n")
    assert found[0] == "line 3 `IF SIG(5) GOTO 10`: signal 5 is on each time"
    assert found[1].endswith("line 2 `SIGNAL 5`: it is switched on here last")


@pytest.mark.thorough
def test_a_condition_without_a_variable_is_told_as_such() -> None:
    found = told("WHILE TRUE DO\n  m = 1\nEND\n")
    (only,) = found
    assert only.startswith("line 2 `WHILE TRUE DO`: this is asked each time")
    assert only.endswith("it goes by no variable")
