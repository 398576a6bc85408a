"""REACTI: a reaction that gives the motion up [C92]."""

import pytest

from tests.support_engine import TACC, TICK, lines, reacted, runs
from tests.support_programs import codes, ended, started
from vrts.base.pose import distance
from vrts.scene.model import Scenario

LINE = 'MOVE a\nBREAK\nREACTI 1003, stopped\nMOVES b\nBREAK\nTYPE "end"\n'
STOPPED = (
    ".PROGRAM stopped\nSET goal = DEST\nSET spot = HERE\nTYPE DY(goal)\nTYPE DY(spot)\n{}\n.END\n"
)
AT = 1.9  # [s], while the line is under way
CUT = Scenario(inputs=((AT, 1003, True),))


def test_the_motion_stops_before_its_end_and_dest_stays() -> None:
    run = runs(LINE, STOPPED.format(""), CUT)
    assert started(run)[1] < AT < ended(run)[1]
    line = run.motions[1]
    assert line.cut
    assert line.end_s == pytest.approx(AT + TACC, abs=TICK)
    stop = run.at(line.end_s).X_WT.translation
    assert distance(stop, (0.9, -0.2, 0.1)) > 0.05
    goal, spot, _ = (text for _, text in lines(run))
    assert float(goal) == pytest.approx(-200.0, abs=1e-3)
    assert -200.0 < float(spot) < 200.0
    assert [r.program for r in reacted(run)] == ["stopped"]


def test_the_reaction_may_send_the_arm_on() -> None:
    run = runs(LINE, STOPPED.format("MOVES goal"), CUT)
    assert codes(run) == []
    last = run.at(run.horizon_s).X_WT.translation
    assert last == pytest.approx((0.9, -0.2, 0.1), abs=1e-6)
    assert run.motions[2].start == pytest.approx(run.motions[1].goal, abs=1e-9)


def test_without_a_program_it_only_stops_the_motion() -> None:
    run = runs(LINE.replace(", stopped", ""), scenario=CUT)
    assert run.motions[1].cut
    assert [text for _, text in lines(run)] == ["end"]
    assert reacted(run)[0].program == ""


def test_while_it_is_locked_the_motion_goes_on() -> None:
    run = runs("LOCK 5\n" + LINE + "LOCK 0", STOPPED.format(""), CUT)
    assert not run.motions[1].cut
    assert lines(run)[0][1] == "end"
    assert len(reacted(run)) == 1


def test_a_motion_that_waits_its_turn_is_given_from_where_the_arm_stopped() -> None:
    run = runs(
        "REACTI 1003, note\nMOVE a\nMOVE b\nBREAK",
        ".PROGRAM note\nTYPE 1\n.END\n",
        Scenario(inputs=((0.5, 1003, True),)),
    )
    first, second = run.motions
    assert first.cut
    assert second.start == pytest.approx(first.goal, abs=1e-9)
    assert second.start_s >= first.end_s - 1e-9
    assert run.at(run.horizon_s).X_WT.translation == pytest.approx((0.9, -0.2, 0.1), abs=1e-6)
    assert run.at(first.end_s).velocity == pytest.approx((0.0,) * 6, abs=1e-6)


def test_at_rest_nothing_is_cut() -> None:
    run = runs("REACTI 1003, note\nWAIT TIMER(0) > 2", ".PROGRAM note\nTYPE 1\n.END\n", CUT)
    assert run.motions == []
    assert len(reacted(run)) == 1


def test_a_delay_is_given_up_too() -> None:
    run = runs('REACTI 1003\nDELAY 10\nBREAK\nTYPE "end"', scenario=CUT)
    assert lines(run)[0][0] == pytest.approx(AT, abs=0.12)
