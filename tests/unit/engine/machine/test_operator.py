"""What an operator does in a scenario: stop, go on, execute again; what is drawn and missing."""

import pytest

from tests.support_programs import cans, happened, ran, run_body, typed
from vrts.base.pose import distance
from vrts.engine.memory.events import Grasped, MotionStarted
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.scene.model import Act, Deed, FaultKind, Parts, PlannedFault, Scenario

SCENE = cans()
LOCATIONS = ".LOCATIONS\ngrip 800 -450 -225 90 90 0\nput 950 -130 -75 90 90 0\n.END\n"
PICK = "OPENI\nAPPRO grip, 120\nMOVES grip\nCLOSEI\nDEPARTS 200\n"
PUT = "APPRO put, 120\nMOVES put\nOPENI\nDEPARTS 120\n"


def carried(
    body: str, operator: tuple[Act, ...] = (), faults: tuple[PlannedFault, ...] = ()
) -> Run:
    text = f".PROGRAM main\n{body}\n.END\n{LOCATIONS}"
    return ran(text, SCENE, Scenario(operator=operator, faults=faults))


def test_a_stop_gives_the_motion_up_and_proceed_goes_on_with_the_next_step() -> None:
    acts = (Act(0.5, Deed.STOP), Act(3.0, Deed.PROCEED))
    run = run_body("MOVE a\nMOVE b\nBREAK\n", scenario=Scenario(operator=acts))
    assert run.ending is Ending.COMPLETED
    motions = [event.time_s for event in happened(run, MotionStarted)]
    assert motions[-1] >= 3.0
    assert run.motions[0].cut


def test_retry_goes_on_with_the_motion_that_was_given_up() -> None:
    acts = (Act(0.5, Deed.STOP), Act(3.0, Deed.RETRY))
    run = run_body("MOVE a\nBREAK\n", scenario=Scenario(operator=acts))
    plain = run_body("MOVE a\nBREAK\n")
    ends = [each.at(each.horizon_s).configuration for each in (run, plain)]
    assert ends[0] == pytest.approx(ends[1])
    assert len(run.motions) == 2


def test_a_program_is_executed_again_with_the_memory_that_it_left() -> None:
    body = "IF NOT DEFINED(n) THEN\nn = 0\nEND\nn = n+1\nTYPE n\n"
    acts = (Act(1.0, Deed.EXECUTE), Act(2.0, Deed.EXECUTE))
    run = run_body(body, scenario=Scenario(operator=acts))
    assert typed(run) == ["1", "2", "3"]
    assert run.ending is Ending.COMPLETED


def test_a_run_lasts_as_long_after_the_last_execution_as_after_the_first() -> None:
    acts = (Act(700.0, Deed.EXECUTE),)
    run = run_body("MOVE a\nBREAK\nTYPE 1\n", scenario=Scenario(operator=acts))
    assert typed(run) == ["1", "1"]


def test_parts_are_put_back_before_a_program_is_executed_again() -> None:
    acts = (Act(20.0, Deed.EXECUTE, Parts.PUT_BACK),)
    run = carried(PICK + PUT, operator=acts)
    assert [event.body for event in happened(run, Grasped)] == ["can1", "can1"]  # type: ignore[attr-defined]
    start = SCENE.body("can1").X_WO.translation
    assert distance(run.at(20.1).poses["can1"].translation, start) == pytest.approx(0.0, abs=1e-9)
    assert distance(run.at(19.9).poses["can1"].translation, start) > 0.1


def test_a_part_in_the_hand_is_put_back_too() -> None:
    run = carried(PICK, operator=(Act(20.0, Deed.EXECUTE, Parts.PUT_BACK),))
    state = run.at(20.1)
    assert state.held is None
    start = SCENE.body("can1").X_WO.translation
    assert distance(state.poses["can1"].translation, start) == pytest.approx(0.0, abs=1e-9)
    assert len(happened(run, Grasped)) == 2


def test_what_was_moved_elsewhere_is_taken_and_the_rest_is_not() -> None:
    run = carried(PICK + PUT, operator=(Act(20.0, Deed.EXECUTE, Parts.TAKEN),))
    assert len(happened(run, Grasped)) == 1
    poses = run.at(21.0).poses
    assert poses["can1"].translation[2] < -50.0
    assert poses["can2"] == SCENE.body("can2").X_WO


def test_what_is_left_stays_where_it_is() -> None:
    run = carried(PICK + PUT, operator=(Act(20.0, Deed.EXECUTE),))
    assert len(happened(run, Grasped)) == 1


def test_a_part_that_is_missing_lets_the_hand_close_entirely() -> None:
    body = "OPENI\nAPPRO grip, 120\nMOVES grip\nGRASP 20, 10\nTYPE 1\nHALT\n10 TYPE 2"
    assert typed(carried(body)) == ["1"]
    run = carried(body, faults=(PlannedFault(0.0, FaultKind.PART_MISSING),))
    assert typed(run) == ["2"]
    assert not happened(run, Grasped)
    assert run.at(run.horizon_s).poses["can1"].translation[2] < -50.0


def test_a_part_may_be_missing_while_the_hand_is_closing() -> None:
    plain = carried(PICK)
    (grasp,) = happened(plain, Grasped)
    late = carried(PICK, faults=(PlannedFault(grasp.time_s - 0.02, FaultKind.PART_MISSING),))
    assert not happened(late, Grasped)
    assert late.at(late.horizon_s).hand_opening == SCENE.robot.gripper.opening_min


def test_random_numbers_are_drawn_as_a_scenario_says_and_then_by_the_seed() -> None:
    body = "TYPE RANDOM, RANDOM\nTYPE RANDOM"
    run = run_body(body, scenario=Scenario(draws=(0.25, 0.5)))
    first = run_body("TYPE RANDOM")
    assert typed(run) == ["0.25 0.5", *typed(first)]
