"""Motions that are given up: the arm slows down along its path, and DEST stays."""

import pytest

from tests.support_engine import SETTLING, TACC, driven, lines, main, of_kind, runs
from tests.support_programs import codes, ended, started, switched
from vrts.base.pose import distance
from vrts.engine.memory.events import Found
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.ir.commands import Abort, Panic, Proceed, Retry

LONG = "MOVE #PPOINT(150,-90,90,0,0,0)"


def slows_down_on(run: Run, whole: Run, from_s: float) -> None:
    """Check that the arm stays on the path of another run and stops within its time."""
    stop = run.motions[0].end_s
    assert run.motions[0].cut
    assert stop == pytest.approx(from_s + TACC, abs=1e-6)
    speeds = [abs(run.at(from_s + k * TACC / 20).velocity[0]) for k in range(21)]
    assert speeds == sorted(speeds, reverse=True)
    assert speeds[0] > 0.0
    assert speeds[-1] == pytest.approx(0.0, abs=1e-6)
    for k in range(21):
        q = run.at(from_s + k * TACC / 20).configuration
        share = q[0] / whole.motions[0].goal[0]
        on_path = [a + share * (b - a) for a, b in zip(*whole.motions[0][3:5], strict=True)]
        assert q == pytest.approx(on_path, abs=1e-9)


def test_brake_stops_the_arm_on_its_path_and_the_program_goes_on_at_once() -> None:
    run = runs(f"{LONG}\nWAIT TIMER(0) >= 1\nSIGNAL 1\nBRAKE\nSIGNAL 2")
    on = switched(run)
    assert on[1] == on[2]
    slows_down_on(run, runs(LONG), on[1])
    assert run.ending is Ending.COMPLETED


def test_dest_is_still_where_the_motion_was_to_go() -> None:
    run = runs(
        "MOVE a\nBREAK\nMOVES b\nTIMER 1 = 0\nWAIT TIMER(1) > 0.3\nBRAKE\n"
        "SET goal = DEST\nBREAK\nTYPE DY(goal)\nTYPE DY(HERE)\nMOVES goal\nBREAK\nTYPE DY(HERE)"
    )
    goal, stopped, after = (float(text) for _, text in lines(run))
    assert goal == pytest.approx(-200.0, abs=1e-3)
    assert -150.0 < stopped < 190.0
    assert after == pytest.approx(-200.0, abs=1e-3)


def test_a_motion_after_brake_waits_until_the_arm_rests() -> None:
    run = runs(f"{LONG}\nWAIT TIMER(0) >= 1\nBRAKE\nMOVE a\nSIGNAL 1")
    assert not run.motions[0].blended
    assert started(run)[1] >= ended(run)[0] - 1e-9
    assert run.at(ended(run)[0]).velocity == pytest.approx((0.0,) * 6, abs=1e-6)
    assert run.motions[1].start == pytest.approx(run.motions[0].goal, abs=1e-9)


def test_brake_at_rest_does_nothing() -> None:
    run = runs("BRAKE\nMOVE a\nBREAK\nBRAKE\nMOVE b")
    assert [motion.cut for motion in run.motions] == [False, False]


def test_brake_near_the_end_lets_the_motion_end() -> None:
    whole = runs("DRIVE 1, 60, 100")
    late = ended(whole)[0] - 0.05
    run = runs(f"DRIVE 1, 60, 100\nWAIT TIMER(0) >= {late}\nBRAKE")
    assert run.motions[0].goal == pytest.approx(whole.motions[0].goal, abs=0.02)
    assert run.motions[0].end_s == pytest.approx(ended(whole)[0], abs=0.1)


def test_brake_ends_a_delay() -> None:
    text = main("DELAY 5\nSIGNAL 1\nWAIT TIMER(0) > 1\nBRAKE\nBREAK\nSIGNAL 2")
    assert switched(driven(text, 6.0))[2] == pytest.approx(1.0, abs=0.1)


def test_a_waiting_motion_is_not_joined_after_brake() -> None:
    """The process control program brakes while a second motion waits its turn."""
    run = runs(
        f"PCEXECUTE stop\n{LONG}\nDRIVE 2, 20\nSIGNAL 1",
        ".PROGRAM stop\nWAIT TIMER(0) > 0.5\nBRAKE\n.END\n",
    )
    first, second = run.motions
    assert first.cut
    assert first.end_s == pytest.approx(0.5 + TACC, abs=0.03)
    assert second.start == pytest.approx(first.goal, abs=1e-9)
    assert second.start_s == pytest.approx(first.end_s, abs=0.1)
    assert switched(run)[1] < 1.0


def test_an_error_slows_the_arm_down_too() -> None:
    run = runs(f"{LONG}\nWAIT TIMER(0) >= 1\nTYPE nothing")
    assert codes(run) == ["V250"]
    slows_down_on(run, runs(LONG), of_kind(run, Found)[0].time_s)
    assert run.ended_s == pytest.approx(run.motions[0].end_s + SETTLING, abs=0.09)


def test_abort_slows_down_and_retry_gives_the_motion_again() -> None:
    text = main(f"{LONG}\nSIGNAL 1\nDRIVE 2, 10")
    run = driven(text, 20.0, (1.0, Abort()), (5.0, Retry()))
    first, again = run.motions[0], run.motions[1]
    assert first.cut
    assert again.start == pytest.approx(first.goal, abs=1e-9)
    assert again.goal == pytest.approx(runs(LONG).motions[0].goal, abs=1e-9)
    assert started(run)[1] == pytest.approx(5.0, abs=0.06)
    assert run.ending is Ending.COMPLETED


def test_proceed_leaves_the_motion_out() -> None:
    text = main(f"{LONG}\nSIGNAL 1\nDRIVE 2, 10")
    run = driven(text, 20.0, (1.0, Abort()), (5.0, Proceed()))
    assert len(run.motions) == 2
    assert run.motions[1].goal[0] == pytest.approx(run.motions[0].goal[0], abs=1e-9)
    assert run.ending is Ending.COMPLETED


def test_panic_stops_arm_and_both_programs() -> None:
    run = driven(
        main(f"PCEXECUTE blink, -1\n{LONG}\nBREAK", ".PROGRAM blink\nSIGNAL 1\nWAIT\n.END\n"),
        5.0,
        (1.0, Panic()),
    )
    assert run.motions[0].cut
    assert run.at(5.0).velocity == (0.0,) * 6
    for program in (run.at(5.0).robot, run.at(5.0).process):
        assert program is not None
        assert program.status.value == "stopped"


@pytest.mark.parametrize("speed", [100, 30])
def test_a_line_that_is_cut_stays_straight(speed: int) -> None:
    run = runs(
        f"MOVE a\nBREAK\nSPEED {speed}\nMOVES b\nTIMER 1 = 0\nWAIT TIMER(1) > 0.3\nBRAKE\nBREAK"
    )
    for k in range(50):
        t = started(run)[1] + k * (run.horizon_s - started(run)[1]) / 50
        x, y, z = run.at(t).X_WT.translation
        assert distance((x, 0.0, z), (0.9, 0.0, 0.1)) < 1e-6
        assert -0.2 < y <= 0.2 + 1e-9
