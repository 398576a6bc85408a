"""The switch DRY.RUN: programs run, the arm stands still."""

import pytest

from tests.support_engine import TICK, runs
from tests.support_programs import codes, ended, started


def test_in_a_dry_run_the_arm_stands_still_and_all_else_happens() -> None:
    body = 'MOVE a\nSIGNAL 1\nMOVES b\nSET x = DEST\nTYPE /F0.0, DY(x)\nOPENI\nBREAK\nTYPE "end"'
    dry = runs("ENABLE DRY.RUN\n" + body)
    start = dry.at(0.0).configuration
    for k in range(50):
        assert dry.at(dry.horizon_s * k / 50).configuration == start
    assert dry.output.split() == ["-200", "end"]
    assert dry.at(dry.horizon_s).signals == {1}
    assert dry.timeline.configuration(dry.horizon_s) == start
    assert dry.at(dry.horizon_s).hand_opening > 0.0


def test_a_dry_run_finds_what_cannot_be_reached() -> None:
    assert codes(runs("ENABLE DRY.RUN\nMOVE TRANS(3000,0,0,90,90,0)")) == ["V301"]


def test_after_a_dry_run_the_arm_goes_from_where_it_is() -> None:
    run = runs("ENABLE DRY.RUN\nMOVE a\nDISABLE DRY.RUN\nMOVE b\nDRIVE 1, 5")
    assert run.motions[-1].start[1:] == pytest.approx(run.motions[-1].goal[1:])
    assert run.at(ended(run)[0]).configuration == run.at(0.0).configuration
    for before, after in zip(ended(run), started(run)[1:], strict=False):
        assert after >= before - TICK
