"""A program that waits for ever does not hold the arm up: it goes on to where it was sent."""

import pytest

from tests.support_programs import compiled, program
from vrts.base.units import MM
from vrts.engine.controller import advance, commands_of, start
from vrts.engine.faults import WAIT_NEVER_ENDS
from vrts.engine.memory.events import Found
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.scene.default import robot_alone
from vrts.scene.model import Scenario

WAITS = "MOVE a\nWAIT SIG(1001)\n"


def run_of(body: str) -> Run:
    run = start(compiled(program(body)), robot_alone(), Scenario())
    return advance(run, 60.0, commands_of(Scenario(), "main"), closed=True)


def test_the_motion_under_way_goes_on_to_its_end() -> None:
    run, whole = run_of(WAITS), run_of("MOVE a\n")
    assert run.ending is Ending.LIMIT
    assert [m.end_s for m in run.motions] == [m.end_s for m in whole.motions]
    tool = run.at(run.horizon_s)
    reached = (tool.X_WF @ tool.X_FT).translation
    assert reached == pytest.approx([900 * MM, 200 * MM, 100 * MM], abs=1e-6)


def test_it_is_told_once_the_arm_stands_still() -> None:
    run = run_of(WAITS)
    (found,) = (each for each in run.events if isinstance(each, Found))
    assert found.diagnostic.rule == WAIT_NEVER_ENDS
    assert found.time_s >= run.motions[-1].end_s
