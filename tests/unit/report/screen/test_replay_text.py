"""A run told line by line, in both directions."""

import re
from itertools import pairwise

import pytest

from tests.support_programs import program, ran
from tests.support_saved import busy
from vrts.engine.run import Run
from vrts.engine.statements import statements
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.report.screen.replay_text import MOST_STEPS, replay
from vrts.run_files.simulated import simulate
from vrts.scene.model import Scenario


@pytest.fixture(scope="module")
def run() -> Run:
    found = busy().run
    assert found is not None
    return found


def words(run: Run, from_s: float, to_s: float) -> list[str]:
    return [told.text[13:] for told in replay(run, from_s, to_s)]


def test_statements_are_numbered_through_both_programs(run: Run) -> None:
    found = statements(run.history, 0, run.statements)
    numbers = [statement.number for statement in found]
    assert numbers == list(range(2, run.statements + 1))  # the first is EXECUTE
    assert {statement.process for statement in found} == {False, True}
    for statement in found:
        before = run.at_statement(statement.number - 1)
        stack = before.process_stack if statement.process else before.call_stack
        assert statement.cause == stack[-1]


@pytest.mark.parametrize(("first", "last"), [(0, 0), (3, 9), (10, 10), (20, 1000)])
def test_some_of_the_statements(run: Run, first: int, last: int) -> None:
    whole = statements(run.history, 0, run.statements)
    wanted = [statement for statement in whole if first < statement.number <= last]
    assert statements(run.history, first, last) == wanted


def test_a_motion_that_takes_no_time_starts_before_it_arrives() -> None:
    text = b".PROGRAM main\nENABLE DRY.RUN\nMOVE #PPOINT(10,-90,90)\nREADY\n.END\n"
    found = simulate(Request(ProgramFile(text, "main.v2"), robot_alone())).run
    assert found is not None
    still = [motion for motion in found.motions if motion.start_s == motion.end_s]
    told = [
        line.split("the arm ")[1] for line in words(found, 0.0, found.horizon_s) if "arm" in line
    ]
    goes = ["starts", "arrives"] * len(found.motions)
    assert still
    assert [line.split(":")[0] for line in told] == goes


def arm_words(text: str, scenario: Scenario | None = None) -> list[str]:
    run = ran(text, scenario=scenario)
    told = words(run, 0.0, run.horizon_s)
    return [line.split("the arm ")[1].split(":")[0] for line in told if "the arm " in line]


@pytest.mark.parametrize(
    "line",
    [
        "TRANS(0,-900,100,90,90,0)",  # a joint limit on the way
        "TRANS(300,100,900,90,90,0)",
    ],
)
def test_a_line_that_a_fault_stops_does_not_arrive(line: str) -> None:
    assert arm_words(program(f"MOVE a\nBREAK\nMOVES {line}")) == [
        *("starts", "arrives"),
        *("starts", "is stopped"),
    ]


def test_a_line_that_a_reaction_stops_does_not_arrive() -> None:
    text = program("REACTI 1001, note\nMOVE a\nBREAK\nSPEED 10\nMOVES b\nMOVE a")
    text += ".PROGRAM note\nTYPE 1\n.END\n"
    told = arm_words(text, Scenario(inputs=((2.0, 1001, True),)))
    assert told == ["starts", "arrives", "starts", "is stopped", "starts", "arrives"]


def test_parts_make_the_whole(run: Run) -> None:
    end = run.horizon_s
    cuts = [0.0, 0.3 * end, 0.61 * end, end]
    whole = list(replay(run, 0.0, end))
    parts = [told for a, b in pairwise(cuts) for told in replay(run, a, b)]
    assert parts == whole
    assert all(a.time_s <= b.time_s + 1e-9 for a, b in pairwise(whole))


def test_backward_is_the_whole_from_behind(run: Run) -> None:
    forward = words(run, 0.0, run.horizon_s)
    backward = words(run, run.horizon_s, 0.0)
    assert [line.replace("  - ", "  + ") for line in backward[::-1]] == forward


def test_the_process_control_program_is_told_apart(run: Run) -> None:
    told = words(run, 0.0, run.horizon_s)
    assert any(line.endswith("p seen = seen+1") for line in told)
    assert any("* signal 2001 on" in line for line in told)
    assert any("* program blink reacts to signal 1001" in line for line in told)


def test_of_a_loop_only_the_first_steps_of_an_instant_are_told() -> None:
    text = b".PROGRAM main\n  FOR i = 1 TO 30\n    n = i\n    m = i\n  END\n.END\n"
    found = simulate(Request(ProgramFile(text, "main.v2"), robot_alone()))
    assert found.run is not None
    told = [line.text for line in replay(found.run, 0.0, 0.0)]
    assert len(told) == 1 + MOST_STEPS + 1
    assert re.search(r" and \d\d more steps$", told[-1])
