"""A gripper that slips before it holds anything slips when it does."""

from tests.support_engine import of_kind
from tests.unit.engine.machine.test_scenario import picked
from vrts.engine.memory.events import Grasped, Released
from vrts.scene.model import FaultKind, PlannedFault, Scenario


def test_what_is_grasped_next_drops_out_of_the_hand() -> None:
    run = picked(Scenario(faults=(PlannedFault(0.5, FaultKind.GRIPPER_SLIPS),)))
    (grasp,), (release,) = of_kind(run, Grasped), of_kind(run, Released)
    assert grasp.body == release.body == "can1"
    assert 0.0 <= release.time_s - grasp.time_s < 0.1
    assert run.at(run.horizon_s).held is None
