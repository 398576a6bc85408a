"""Locations, TOOL and BASE as programs see them. Numbers are those of VAL-II's manuals."""

import pytest

from tests.support_programs import codes, ran, run_body
from vrts.base.oat import components
from vrts.base.pose import IDENTITY, Pose, distance
from vrts.engine.run import Run
from vrts.robots.kinematics.kinematics import forward


def value(run: Run, name: str) -> Pose:
    """Return a location that a program has assigned."""
    found = run.at(run.horizon_s).variables[name]
    assert isinstance(found, Pose)
    return found


PLACES = (
    ".LOCATIONS\npick 500 200 100 90 90 0\nfr 300 100 50 120 -90 0\n"
    "o1 300 100 50 90 90 0\nx1 400 100 50 90 90 0\ny1 350 180 50 90 90 0\n.END\n"
)

LOCATIONS = [
    ("SET p = NULL", (0, 0, 0, 90, -90, 0)),
    ("SET p = fr:TRANS(100,0,0,90,-90,0)", (386.603, 150, 50, 120, -90, 0)),
    ("SET p = INVERSE(fr)", (-309.808, 63.397, -50, 60, -90, 0)),
    ("SET p = fr:INVERSE(fr):pick", (500, 200, 100, 90, 90, 0)),
    ("SET p = SHIFT(pick BY 10,-20,5)", (510, 180, 105, 90, 90, 0)),
    ("SET p = FRAME(o1,x1,y1,o1)", (300, 100, 50, 90, -90, 0)),
    ("SET p = RX(90)", (0, 0, 0, 0, 0, 90)),
]


@pytest.mark.parametrize(("body", "expected"), LOCATIONS)
def test_location(body: str, expected: tuple[float, ...]) -> None:
    run = ran(f".PROGRAM main\n{body}\n.END\n{PLACES}")
    assert codes(run) == []
    assert components(value(run, "p")) == pytest.approx(expected, abs=2e-3)


def test_distance() -> None:
    run = run_body("TYPE DISTANCE(TRANS(0,0,0,90,-90,0), TRANS(100,200,50,90,-90,0))")
    assert float(run.output) == pytest.approx(229.129, abs=1e-3)


def test_appro_stays_back_along_the_tool_and_depart_goes_back() -> None:
    run = run_body("APPRO a, 50\nMOVES a\nDEPART 75\nDEPARTS 25")
    ends = [components(motion.X_WT) for motion in run.motions]
    expected = [(900, 200, z, 90, 90, 0) for z in (150, 100, 175, 200)]
    for end, place in zip(ends, expected, strict=True):
        assert end[:3] == pytest.approx(place[:3], abs=1e-6)
    assert run.motions[3].X_WT.approach == pytest.approx((0.0, 0.0, -1.0), abs=1e-9)


def test_approach_of_a_level_hand_is_level() -> None:
    run = ran(".PROGRAM main\nAPPRO p, 50\n.END\n.LOCATIONS\np 900 200 100 90 0 0\n.END\n")
    place = run.at(run.horizon_s).X_WT
    approach = place.approach
    expected = [c - 0.05 * a for c, a in zip((0.9, 0.2, 0.1), approach, strict=True)]
    assert abs(approach[2]) < 1e-9
    assert place.translation == pytest.approx(expected, abs=1e-9)


TOOL = "TOOL TRANS(0,0,150,90,-90,0)\n"


def test_a_tool_moves_what_here_says_and_not_the_arm() -> None:
    run = run_body(f"HERE p\nTYPE DZ(p)\n{TOOL}HERE p\nTYPE DZ(p)")
    before, after = (float(word) for word in run.output.split())
    assert after == pytest.approx(before + 150.0, abs=1e-2)
    assert not run.motions


def test_a_tool_puts_its_end_at_the_location() -> None:
    run = run_body(f"{TOOL}MOVE a")
    state = run.at(run.horizon_s)
    assert components(state.X_WT)[:3] == pytest.approx((900, 200, 100), abs=1e-6)
    assert components(state.X_WF)[:3] == pytest.approx((900, 200, 250), abs=1e-6)


def test_base_moves_locations_against_the_robot() -> None:
    plain, based = run_body("MOVE a"), run_body("BASE 30, -50, 20, 0\nMOVE a")
    a, b = (run.motions[0].X_WT.translation for run in (plain, based))
    assert [abs(p - q) for p, q in zip(a, b, strict=True)] == pytest.approx((0.03, 0.05, 0.02))


def test_base_changes_what_ready_is_called() -> None:
    """The manual's example: READY after BASE 300, -50, 30, 30."""
    run = run_body("READY\nBASE 300, -50, 30, 30\nHERE p")
    arm = run.scene.robot.arm
    shifted = forward(arm, arm.ready)
    x, y, z, o, a, t = components(value(run, "p"))
    assert z == pytest.approx(1e3 * shifted.translation[2] + 30.0, abs=1e-2)
    c, s = 0.8660254, 0.5
    px, py = (1e3 * v for v in shifted.translation[:2])
    assert (x, y) == pytest.approx((300 + c * px - s * py, -50 + s * px + c * py), abs=1e-2)
    assert (o, a, t) == pytest.approx((120.0, -90.0, 0.0), abs=1e-3)


def test_base_without_numbers_returns_to_the_robot() -> None:
    run = run_body("BASE 300, -50, 30, 30\nBASE\nMOVE a")
    assert components(run.motions[0].X_WT)[:3] == pytest.approx((900, 200, 100), abs=1e-6)


def test_compound_destination() -> None:
    text = (
        ".PROGRAM main\nMOVE tray:hole\n.END\n"
        ".LOCATIONS\ntray 800 100 100 90 -90 0\nhole 50 20 0 90 90 0\n.END\n"
    )
    end = ran(text).motions[0].X_WT
    assert distance(end.translation, (0.85, 0.12, 0.1)) < 1e-9


def test_ready_is_straight_up() -> None:
    run = run_body("MOVE a\nREADY")
    assert run.at(run.horizon_s).configuration == pytest.approx(run.scene.robot.arm.ready)
    assert run.scene.X_FT == IDENTITY


@pytest.mark.parametrize("word", ["FLIP", "NOFLIP"])
def test_a_wrist_asked_for_is_taken(word: str) -> None:
    run = run_body(f"MOVE a\n{word}\nMOVE b")
    joint5 = run.motions[1].goal[4]
    assert (joint5 < 0.0) is (word == "FLIP")


def test_precision_points_are_configurations() -> None:
    run = run_body("MOVE a\nBREAK\nHERE #p\nMOVE b\nMOVE #p")
    assert run.motions[2].goal == pytest.approx(run.motions[0].goal, abs=1e-9)
