"""An object in the right place does not count while the hand holds it."""

from tests.places import ROOT
from vrts.check.goals.reached import reached
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"


def test_a_held_object_has_not_reached_its_goal() -> None:
    block = (EXAMPLE / "solution.v2").read_text().partition(".LOCATIONS")[2]
    program = (
        ".PROGRAM main\n OPENI\n MOVE safe\n APPRO can1_grip, 120\n MOVES can1_grip\n CLOSEI\n"
        " DEPARTS 200\n APPRO base2_put, 120\n SPEED 20\n MOVES base2_put\n.END\n.LOCATIONS"
    )
    found = assess(Request(ProgramFile((program + block).encode(), "program"), load_task(EXAMPLE)))
    assert found.run is not None
    assert found.task is not None
    assert found.grade is not None
    can = reached(found.run, found.task)[0]
    assert can.position_mm < 1
    assert can.share == 0
    assert "still in the hand" in found.grade.losses[0].sentence
