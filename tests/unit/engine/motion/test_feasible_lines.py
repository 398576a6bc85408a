"""What a line asks of the arm, told apart: its reach, joint limits, joint speeds, singularities."""

import math

import pytest

from tests.support_engine import runs
from tests.support_programs import codes
from vrts.base.diagnostic import Diagnostic
from vrts.check.verdicts.limits import check_limits
from vrts.engine.run import Run
from vrts.scene.default import robot_alone
from vrts.scene.model import Scenario, Scene

UR5 = robot_alone("ur5")
ACROSS = "MOVE TRANS(250,-300,400,0,180,0)\nBREAK\n{}MOVES TRANS(250,300,400,0,180,0)"
CORNER = (
    "MOVE TRANS(250,-300,500,0,180,0)\nBREAK\nMOVES TRANS(250,-300,400,0,180,0)\n{}"
    "MOVES TRANS(250,300,400,0,180,0)"
)
BENT = "DRIVE 2, 45, 100\nDRIVE 3, 30, 100\nDRIVE 5, {}, 100\nHERE p\nBREAK\n{}MOVES SHIFT(p BY {})"


def the(run: Run, code: str) -> Diagnostic:
    (found,) = [d for d in (*run.findings, *check_limits(run).findings) if d.rule.code == code]
    return found


def too_fast(run: Run) -> list[Diagnostic]:
    return [d for d in check_limits(run).findings if d.rule.code == "V302"]


STOPPED = (
    "SET #a = #PPOINT(60.1,-126.8,51,25.4,37.1,0)\nMOVE #a\nHERE p\nBREAK\n"
    "SPEED {}\nMOVES SHIFT(p BY 497,532,-579)"
)


def test_of_a_line_that_is_stopped_anyway_it_is_told_what_would_do_up_to_there() -> None:
    run = runs(STOPPED.format("1000 MMPS"), scene=robot_alone())
    assert "V301" in codes(run)
    (found,) = too_fast(run)
    percent = found.data["speed_percent"]
    assert isinstance(percent, int)
    wanted = f"first look at what stops this motion; up to there SPEED {percent} would do"
    assert found.help == (wanted,)
    slow = runs(STOPPED.format(percent), scene=robot_alone())
    assert "V301" in codes(slow), "it is stopped all the same"
    assert not too_fast(slow)
    assert too_fast(runs(STOPPED.format(percent + 1), scene=robot_alone()))


# --- joint speeds -------------------------------------------------------------------------------


def test_a_line_that_is_merely_too_fast_is_followed_to_its_end() -> None:
    run = runs(ACROSS.format(""), scene=UR5)
    assert "V302" in codes(run)
    assert run.ending.value == "completed"
    assert run.motions[-1].X_WT.translation == pytest.approx((0.25, 0.3, 0.4), abs=1e-6)


@pytest.mark.parametrize(
    ("body", "scene"),
    [
        (ACROSS, UR5),
        (CORNER, UR5),
        (BENT.format(6, "{}", "0,-400,0"), robot_alone()),
        ("MOVE a\nBREAK\n{}MOVE #PPOINT(150,-60,120,0,30,0)", robot_alone()),
    ],
)
def test_the_speed_that_is_told_does_and_one_more_does_not(body: str, scene: Scene) -> None:
    scenario = Scenario(parameters={"SPEED.MAX": 400.0})
    fast = "SPEED 300\n" if "{}MOVE #" in body else ""
    run = runs(body.format(fast), scene=scene, scenario=scenario)
    (found,) = too_fast(run)
    percent = found.data["speed_percent"]
    assert isinstance(percent, int)
    assert f"SPEED {percent} would do" in found.help[0]
    before = "BREAK\n" if found.data["after_break"] else ""

    def again(percent: int) -> Run:
        return runs(body.format(f"{before}SPEED {percent}\n"), scene=scene, scenario=scenario)

    assert too_fast(again(percent)) == []
    assert too_fast(again(percent + 1)) != []


def test_the_operators_speed_counts() -> None:
    slow = Scenario(monitor_speed=50.0)
    assert "V302" not in codes(runs(ACROSS.format(""), scene=UR5, scenario=slow))


def test_no_speed_is_told_where_none_would_do() -> None:
    """The hand would have to turn round within less than a tick, however slow."""
    run = runs(BENT.format("0.0001", "SPEED 1\n", "0,-20,0"))
    (found,) = [d for d in run.findings if d.is_error]
    assert found.rule.code == "V306"
    assert "SPEED" not in found.help[0]


# --- reach --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("body", "scene", "excess_mm"),
    [
        ("MOVE a\nBREAK\nMOVES TRANS(1700,200,100,90,90,0)", robot_alone(), 216),
        ("MOVE TRANS(400,-300,400,0,180,0)\nBREAK\nMOVES TRANS(5000,300,400,0,180,0)", UR5, 4099),
    ],
)
def test_a_line_whose_end_is_out_of_reach_does_not_begin(
    body: str, scene: Scene, excess_mm: float
) -> None:
    run = runs(body, scene=scene)
    found = the(run, "V301")
    assert found.headline == f"the end of the straight line is {excess_mm} mm beyond reach"
    assert len(run.motions) == 1


def test_reach_that_is_lost_on_the_way_is_told_with_its_place() -> None:
    start, end = "1052,61,1185,-176,-80,-177", "1010,-58,928,-48,71,25"
    run = runs(f"MOVE TRANS({start})\nBREAK\nMOVES TRANS({end})")
    found = the(run, "V301")
    assert found.headline == "the straight line, after 167 of 286 mm, is 42 mm beyond reach"
    assert found.notes[0] == "its end is within reach, but after 51 of 286 mm it is not"
    there = run.motions[-1].X_WT.translation
    gone = math.dist(there, run.motions[0].X_WT.translation)
    assert 0.0 < gone <= 0.051


# --- limits -------------------------------------------------------------------------------------


def test_a_joint_limit_on_the_way_is_told_with_the_place_and_how_far_it_would_go() -> None:
    run = runs("MOVE a\nBREAK\nSPEED 20\nMOVES TRANS(300,100,900,90,90,0)")
    found = the(run, "V303")
    assert found.headline == (
        "joint 5 would be at 128.2 degrees for the straight line after 1005 of 1005 mm;"
        " its limits are -100 and 100"
    )
    assert found.notes[0] == "the joint passes its limit after 614 of 1005 mm"


def test_a_joint_does_not_come_round_from_the_other_side_within_a_line() -> None:
    """Joint 6 at 250 degrees cannot turn on by 160; before, it jumped back by a whole turn."""
    run = runs("MOVE a\nDRIVE 6, 250, 100\nBREAK\nMOVES HERE:TRANS(0,0,0,90,-90,160)")
    found = the(run, "V303")
    assert found.data["joint"] == 6
    assert "of 160 degrees" in found.headline
    assert too_fast(run) == []


# --- singularities ------------------------------------------------------------------------------


def test_a_singularity_between_two_set_points_stops_the_line() -> None:
    """Both set points are degrees away from it, and joint 4 would turn half round between them."""
    run = runs(BENT.format(1.2, "", "0,-200,0"))
    found = the(run, "V306")
    assert "meets the wrist singularity after 11 of 326 mm" in found.headline
    assert run.motions[-1].deviation_m < 1e-3


def test_a_speed_that_gets_past_a_singularity_is_told_and_does() -> None:
    body = BENT.format(1.2, "{}", "0,-200,0")
    percent = the(runs(body.format("")), "V306").data["speed_percent"]
    assert "V306" not in codes(runs(body.format(f"SPEED {percent}\n")))


def test_too_fast_beside_a_singularity_that_is_not_the_cause() -> None:
    """Joint 1 is too fast while the wrist is almost singular: no reason to stop."""
    run = runs(ACROSS.format(""), scene=UR5)
    assert [d.rule.code for d in check_limits(run).findings] == ["V302"]
    assert codes(run) == ["V302", "V331"]


@pytest.mark.parametrize(
    ("robot", "start", "by", "way"),
    [
        (
            "puma761",
            "130.38,-58.61,-11.97,37.19,17.72,-19.09",
            "-440.5,333.7,172.4",
            "meets the wrist singularity after 269 of 579 mm",
        ),
        (
            "ur5",
            "-45,3.5,-121.44,119.49,-54.2,26.13",
            "-287.3,437.5,259.4",
            "meets a singularity after 292 of 584 mm",
        ),
    ],
)
def test_a_wrist_that_turns_round_between_two_set_points_is_noticed(
    robot: str, start: str, by: str, way: str
) -> None:
    """No set point is singular: only halves of the way between two of them come near enough.

    Followed from set point to set point the hand would leave the line there, of the UR by 52 mm.
    """
    body = f"MOVE #PPOINT({start})\nBREAK\nHERE p\nMOVES SHIFT(p BY {by})"
    run = runs(body, scene=robot_alone(robot))
    assert way in the(run, "V306").headline
    assert run.motions[-1].deviation_m < 1e-5
