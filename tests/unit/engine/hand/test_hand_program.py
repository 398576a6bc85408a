"""The hand in programs: GRASP, MOVET, RELAX, HAND, and which motion takes the hand along."""

import pytest

from tests.support_engine import TICK, of_kind, runs, words
from tests.support_programs import cans, codes, ended, ran, started, typed
from vrts.engine.memory.events import HandCommanded
from vrts.engine.run import Run

SCENE = cans()
PICK = ".LOCATIONS\ngrip 800 -450 -225 90 90 0\nair 900 -300 0 90 90 0\n.END\n"


def at_can(body: str) -> Run:
    start = "OPENI\nAPPRO grip, 120\nMOVES grip\n"
    return ran(f".PROGRAM main\n{start}{body}\n.END\n{PICK}", SCENE)


def actions(run: Run) -> list[tuple[float, str]]:
    return [(event.time_s, event.action) for event in of_kind(run, HandCommanded)]


def test_grasp_goes_on_when_the_part_is_there() -> None:
    run = at_can('GRASP 55, 10\nTYPE "held"\nSTOP\n10 TYPE "missing"')
    assert typed(run) == ["held"]
    assert run.at(run.horizon_s).held == "can1"
    assert run.at(run.horizon_s).hand_opening == pytest.approx(0.06, abs=1e-6)


def test_grasp_goes_to_its_label_when_the_hand_closes_too_far() -> None:
    run = at_can('GRASP 65, 10\nTYPE "held"\nSTOP\n10 TYPE "missing"')
    assert typed(run) == ["missing"]
    run = runs('GRASP 5, 10\nTYPE "held"\nSTOP\n10 TYPE "missing"')
    assert typed(run) == ["missing"]


def test_grasp_without_label_stops() -> None:
    assert words(runs("GRASP 5")) == ["Hand closed too far"]


def test_grasp_waits_for_the_arm_and_for_the_hand() -> None:
    run = runs("OPENI\nMOVE a\nGRASP 0\nSIGNAL 1")
    (_, opens), (closes, _) = actions(run)
    assert opens == "open"
    assert closes == pytest.approx(ended(run)[0] + 3 * TICK)
    (on,) = [e.time_s for e in run.events if type(e).__name__ == "SignalChanged"]
    assert on == pytest.approx(closes + run.scene.robot.gripper.stroke_time, abs=TICK)


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("MOVET a, 50\nMOVET b, 0", ["open", "close"]),
        ("MOVE a\nMOVEST b, 30\nMOVEST c, -1", ["open", "close"]),
        ("OPEN\nMOVE a\nCLOSE\nMOVE b", ["open", "close"]),
    ],
)
def test_the_hand_acts_when_its_motion_starts(body: str, expected: list[str]) -> None:
    run = runs(body)
    found = actions(run)
    assert [action for _, action in found] == expected
    assert [time for time, _ in found] == started(run)[-2:]
    assert codes(run) in ([], ["V310"])


def test_of_two_settings_for_one_motion_both_are_done_in_order() -> None:
    run = runs("OPEN\nCLOSE\nMOVE a")
    assert [action for _, action in actions(run)] == ["open", "close"]
    assert run.at(run.horizon_s).hand_opening == 0.0


def test_hand_is_one_when_open() -> None:
    run = runs("TYPE HAND\nOPENI\nTYPE HAND\nCLOSEI\nTYPE HAND")
    assert typed(run) == ["0", "1", "0"]


@pytest.mark.parametrize("step", ["RELAXI", "RELAX\nREADY"])
def test_relax_lets_the_hand_go_limp(step: str) -> None:
    run = at_can(f"CLOSEI\nDEPARTS 100\nBREAK\n{step}")
    assert run.at(run.horizon_s).held is None
    assert actions(run)[-1][1] == "relax"


def test_the_opening_changes_at_the_grippers_speed() -> None:
    run = runs("OPENI")
    gripper = run.scene.robot.gripper
    half = run.at(0.5 * gripper.stroke_time).hand_opening
    assert half == pytest.approx(0.5 * gripper.opening_max)
    assert run.at(run.horizon_s).hand_opening == pytest.approx(gripper.opening_max)


@pytest.mark.parametrize(
    "body", ["CLOSE\nREADY", "OPEN\nREADY\nCLOSE\nREADY", "CLOSE\nREADY\nCLOSEI"]
)
def test_strokes_are_in_order_to_the_last_digit(body: str) -> None:
    """What begins with a motion at the next tick begins when that tick has come."""
    run = ran(f".PROGRAM main\nFOR i = 1 TO 60\n{body}\nEND\n.END\n", SCENE)
    starts = [stroke.start_s for stroke in run.history.hand.strokes]
    assert len(starts) >= 60
    assert starts == sorted(starts)
    commanded = [time_s for time_s, _ in actions(run)]
    assert commanded == sorted(commanded)
    ticks = {round(time_s / TICK) * TICK for time_s in commanded}
    assert set(commanded) <= ticks, "as the clock counts"
