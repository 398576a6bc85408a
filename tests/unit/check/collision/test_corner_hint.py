"""The hint at a missing stop: said where stopping avoids the contact, and nowhere else."""

import pytest

from tests.support_programs import cans, ran
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.corner_hint import corner_hints
from vrts.check.judge import judge
from vrts.engine.run import Run
from vrts.pipeline.files import CHECKOUT

SUBMISSIONS = CHECKOUT / "examples" / "01-cans-on-bases" / "submissions"

AROUND = """.PROGRAM main
 OPENI
 MOVE beside
 BREAK
 MOVES corner
{stop} MOVES behind
.END
.LOCATIONS
beside   950 -260 -270 90 90 0
corner   950 -260 {height} 90 90 0
behind   950   30 {height} 90 90 0
.END
"""  # up beside the base, and over it


def submitted(name: str) -> Run:
    return ran((SUBMISSIONS / name).read_text("utf-8"), cans())


def hints(run: Run) -> dict[int, str]:
    return dict(corner_hints(run, check_collisions(run.scene, run), None))


def test_a_hand_that_closes_on_the_way_is_named() -> None:
    run = submitted("missing-break.v2")
    first = "the arm does not stop at the end of line 6 `MOVES can1_grip`"
    assert hints(run)[0] == f"{first}, and the hand closes on the way: compare CLOSE with CLOSEI"
    judgement = judge(run.scene, run, None)
    (collision,) = [v for v in judgement.verdicts if v.check == "collision"]
    assert collision.findings[0].help == (hints(run)[0],)


@pytest.mark.parametrize("name", ["hits-base.v2", "forgets-openi.v2", "negative-approach.v2"])
def test_contacts_that_stopping_does_not_avoid_have_other_hints(name: str) -> None:
    assert hints(submitted(name)) == {}


def around(height: int, stop: str = "") -> Run:
    return ran(AROUND.format(height=height, stop=stop), cans())


def test_a_corner_that_cuts_into_the_base_is_named_with_its_line() -> None:
    place = "the arm does not stop at the end of line 5 `MOVES corner`"
    assert hints(around(-120)) == {0: f"{place}, but rounds the corner: look at what BREAK does"}
    stopped = around(-120, " BREAK\n")
    assert check_collisions(stopped.scene, stopped).contacts == ()


def test_a_way_that_is_too_low_is_not_put_down_to_its_corner() -> None:
    run = around(-140)
    assert len(check_collisions(run.scene, run).contacts) == 1
    assert hints(run) == {}


def test_a_contact_after_the_corner_is_not_put_down_to_it() -> None:
    """It lies on the way itself: with a stop at the corner it is there all the same."""
    run = around(-140, " BREAK\n")
    assert len(check_collisions(run.scene, run).contacts) == 1
    assert hints(run) == {}
