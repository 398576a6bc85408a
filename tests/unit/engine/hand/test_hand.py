"""What the hand grasps, carries and lets go, in the scene of two cans and two bases."""

import pytest

from tests.support_programs import cans, codes, happened, ran
from vrts.base.pose import distance
from vrts.base.source import SourceFile
from vrts.engine.memory.events import Grasped, Landed, Released, Toppled
from vrts.engine.memory.records import Lie
from vrts.engine.run import Run
from vrts.scene.model import Scene
from vrts.scene.reading.scene_file import read_scene

SCENE = cans()
LOCATIONS = (
    ".LOCATIONS\n"
    "grip 800 -450 -225 90 90 0\n"
    "put 950 -130 -75 90 90 0\n"
    "edge 1015 -130 -75 90 90 0\n"
    "beside 800 -412 -225 90 90 0\n"
    "air 900 -300 0 90 90 0\n"
    ".END\n"
)
PICK = "OPENI\nAPPRO grip, 120\nMOVES grip\nCLOSEI\nDEPARTS 200\n"


def carried(body: str, scene: Scene = SCENE) -> Run:
    return ran(f".PROGRAM main\n{body}\n.END\n{LOCATIONS}", scene)


def test_a_can_is_grasped_where_it_stands() -> None:
    run = carried(PICK)
    (grasp,) = happened(run, Grasped)
    assert isinstance(grasp, Grasped)
    assert grasp.body == "can1"
    assert codes(run) == []
    state = run.at(run.horizon_s)
    assert state.held == "can1"
    assert state.hand_opening == pytest.approx(0.06, abs=1e-6)  # the can is 60 mm wide
    start = SCENE.body("can1").X_WO.translation
    assert distance(state.poses["can1"].translation, start) == pytest.approx(0.2, abs=1e-6)
    before = run.at(grasp.time_s - 1e-6)
    assert before.held is None
    assert distance(before.poses["can1"].translation, start) == 0.0


def test_a_can_that_is_set_down_stands() -> None:
    run = carried(PICK + "APPRO put, 120\nMOVES put\nOPENI\nDEPARTS 120")
    assert codes(run) == []
    (released,), (landed,) = happened(run, Released), happened(run, Landed)
    assert isinstance(released, Released)
    assert isinstance(landed, Landed)
    assert released.height_m < 1e-4
    assert landed.support == "base1"
    last = run.at(run.horizon_s)
    assert last.held is None
    assert last.placements["can1"].lie is Lie.RESTING
    assert last.poses["can1"].translation == pytest.approx((0.95, -0.13, -0.15), abs=1e-4)


def test_a_can_let_go_above_its_base_is_dropped() -> None:
    run = carried(PICK + "APPRO put, 60\nOPENI\nDEPARTS 60")
    assert codes(run) == ["V312"]
    (released,) = happened(run, Released)
    assert isinstance(released, Released)
    assert released.height_m == pytest.approx(0.06, abs=1e-4)
    (landed,) = happened(run, Landed)
    fall = (2 * 0.06 / 9.81) ** 0.5
    assert landed.time_s - released.time_s == pytest.approx(fall, abs=1e-3)
    middle = run.at(released.time_s + fall / 2)
    assert middle.placements["can1"].lie is Lie.FALLING
    fallen = 0.5 * 9.81 * (fall / 2) ** 2
    assert middle.poses["can1"].translation[2] == pytest.approx(-0.15 + 0.06 - fallen, abs=1e-4)


def test_a_can_over_the_edge_topples() -> None:
    over = carried(PICK + "APPRO edge, 120\nMOVES edge\nOPENI")
    assert happened(over, Toppled)
    assert codes(over)[-1] == "V313"
    assert over.at(over.horizon_s).placements["can1"].lie is Lie.TOPPLED


def test_closing_on_nothing_says_so() -> None:
    run = carried("OPENI\nMOVE air\nCLOSEI")
    assert codes(run) == ["V310"]
    assert happened(run, Grasped) == []


def test_closing_a_closed_hand_says_so() -> None:
    run = carried("MOVE air\nCLOSEI")
    (found,) = run.findings
    assert found.headline == "the hand is told to close but is closed already"


def test_closing_beside_a_can_grasps_nothing() -> None:
    run = carried("OPENI\nAPPRO beside, 120\nMOVES beside\nCLOSEI\nDEPARTS 120")
    assert codes(run) == ["V311"]
    assert run.at(run.horizon_s).held is None
    assert run.at(run.horizon_s).poses["can1"] == SCENE.body("can1").X_WO


def test_close_acts_before_the_arm_leaves_if_there_is_a_delay() -> None:
    run = carried("OPENI\nAPPRO grip, 120\nMOVES grip\nCLOSE\nDELAY 0.5\nDEPARTS 100")
    assert run.at(run.horizon_s).held == "can1"


STACK = """
[objects.table]
kind = "table"
at_mm = [1000, 0]
size_mm = [800, 1400]
top_z_mm = -300

[objects.low]
kind = "can"
at_mm = [900, -200]
on = "table"
radius_mm = 30
height_mm = 115

[objects.tag]
kind = "box"
at_mm = [900, -200]
on = "low"
size_mm = [30, 30, 10]
fixed = false

[locations]
safe = [900, 30, 200, 90, 90, 0]
"""


def test_what_stands_on_a_carried_can_is_carried_along() -> None:
    scene, problems = read_scene(SourceFile("stack.toml", STACK))
    assert scene is not None, problems
    body = (
        "OPENI\nAPPRO p, 120\nMOVES p\nCLOSEI\nDEPARTS 100\n"
        "APPRO q, 100\nMOVES q\nOPENI\nDEPARTS 100"
    )
    places = ".LOCATIONS\np 900 -200 -240 90 90 0\nq 900 100 -240 90 90 0\n.END\n"
    run = ran(f".PROGRAM main\n{body}\n.END\n{places}", scene)
    grasps = [event.body for event in happened(run, Grasped) if isinstance(event, Grasped)]
    assert grasps == ["low"]
    up = run.at(run.motions[2].end_s)
    assert up.held == "low"
    low, tag = up.poses["low"].translation, up.poses["tag"].translation
    assert distance(low, tag) == pytest.approx(0.115, abs=1e-6)
    last = run.at(run.horizon_s)
    assert last.poses["low"].translation == pytest.approx((0.9, 0.1, -0.3), abs=1e-4)
    assert last.poses["tag"].translation == pytest.approx((0.9, 0.1, -0.185), abs=1e-4)
    assert last.placements["tag"].support == "low"
