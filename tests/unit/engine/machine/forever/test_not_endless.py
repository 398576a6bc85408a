"""Loops whose state is not in variables: in the controller itself."""

import pytest

from tests.support_engine import runs
from vrts.engine.memory.records import Ending
from vrts.scene.model import Scenario

LOOPS = [
    (
        "PARAMETER HAND.TIME = 1\nDO\nPARAMETER HAND.TIME = PARAMETER(HAND.TIME)+1\nWAIT\n"
        "UNTIL PARAMETER(HAND.TIME) > 300"
    ),
    "TOOL NULL\nDO\nTOOL TOOL:TRANS(0,0,1,90,-90,0)\nWAIT\nUNTIL DZ(TOOL) > 200",
    "DO\nBASE 0,0,DZ(BASE)+1\nWAIT\nUNTIL DZ(BASE) > 200",
    'DO\nPROMPT $s\nWAIT\nUNTIL $s == "yes"',
    "SPEED 100 ALWAYS\nDO\nSPEED SPEED(2)-1 ALWAYS\nWAIT\nUNTIL SPEED(2) < 3",
]


@pytest.mark.parametrize("body", LOOPS)
def test_a_loop_that_changes_the_controller_may_end(body: str) -> None:
    answers = ("no",) * 150 + ("yes",)
    run = runs(body, scenario=Scenario(answers=answers))
    assert [finding.headline for finding in run.findings] == []
    assert run.ending is Ending.COMPLETED


def test_the_operators_speed_may_end_a_loop() -> None:
    body = "DO\nSPEED SPEED(1)-0.5 MONITOR\nWAIT\nUNTIL SPEED(1) < 20"
    assert runs(body, dialect="vplus").ending is Ending.COMPLETED
