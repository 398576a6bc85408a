"""What the way to a pose touches, before anybody goes it."""

import math
from pathlib import Path

import pytest

from tests.unit.live.session.support import Driven
from vrts.base.oat import components
from vrts.live import actions as do
from vrts.live.session.channel.messages import AskReach
from vrts.live.session.ways.way import POINTS, Found, asked_of, find

DOWN = (0.0, math.pi / 2, 0.0)
ABOVE = (0.85, 0.1, 0.0)


@pytest.fixture
def driven(tmp_path: Path) -> Driven:
    return Driven(tmp_path)


def way(
    driven: Driven, to: tuple[float, float, float], straight: bool = False, oat: object = DOWN
) -> Found | None:
    order = AskReach(1, to, oat, straight)  # type: ignore[arg-type]
    session = driven.session
    stance = session.growing.machine.system.planner.stance
    return find(session.setting.scene, stance, asked_of(session.growing, order))


def found(driven: Driven, to: tuple[float, float, float], *, straight: bool = False) -> Found:
    answer = way(driven, to, straight)
    assert answer is not None
    return answer


def test_a_free_way_is_free_and_shows_its_path(driven: Driven) -> None:
    free = found(driven, ABOVE)
    assert (free.touches, free.sure) == ((), True)
    assert len(free.path_m) == 3 * POINTS
    assert free.path_m[-3:] == pytest.approx(ABOVE, abs=1e-4)


def test_a_goal_inside_of_a_base_is_told_with_what_touches_and_where(driven: Driven) -> None:
    inside = found(driven, (0.95, -0.13, -0.2))
    touch = inside.touches[0]
    assert "touches base1" in touch.text
    assert touch.parts[1] == "base1"
    assert touch.at_goal
    assert 0.5 < touch.start < touch.end == 1.0
    assert math.dist(touch.point, (0.95, -0.13, -0.2)) < 0.2
    assert inside.sure


def test_something_in_the_way_of_a_free_goal_is_told(driven: Driven) -> None:
    driven.act(do.Go((0.95, -0.4, -0.22), DOWN))
    driven.run(6.0)
    beyond = found(driven, (0.95, 0.1, -0.22), straight=True)
    (touch,) = beyond.touches
    assert touch.parts[1] == "base1"
    assert not touch.at_goal
    assert 0.1 < touch.start < touch.end < 0.9
    assert found(driven, (0.95, -0.4, 0.1), straight=True).touches == ()


def test_where_the_arm_is_it_is_looked_at_too(driven: Driven) -> None:
    driven.act(do.Go((0.95, -0.13, -0.2), DOWN))
    driven.run(6.0)
    here = found(driven, (0.95, -0.13, -0.2))
    assert here.touches[0].at_goal
    assert here.path_m[:3] == pytest.approx(here.path_m[-3:], abs=1e-6)


def test_what_the_hand_holds_comes_along(driven: Driven) -> None:
    driven.typed("DO OPENI", seconds=2.0)
    grip = driven.session.setting.scene.locations["can1_grip"]
    turn = math.radians(components(grip)[3])
    driven.act(do.Go(grip.translation, (turn, math.pi / 2, 0.0)))
    driven.run(6.0)
    driven.typed("DO CLOSEI", seconds=2.0)
    assert driven.session.showing.snapshot(0).status.held == "can1"
    # fingers may touch what they hold, and it what it stands on
    lifted = way(driven, (0.8, -0.45, 0.0), straight=True, oat=(turn, math.pi / 2, 0.0))
    assert lifted is not None
    assert lifted.touches == ()
    driven.act(do.Go((0.95, -0.13, 0.0), DOWN))
    driven.run(6.0)
    # the hand alone would stay clear of the base
    (touch,) = found(driven, (0.95, -0.13, -0.12), straight=True).touches
    assert touch.parts == ("can1", "base1")


def test_where_the_arm_cannot_go_there_is_no_way(driven: Driven) -> None:
    assert way(driven, (3.0, 0.0, 0.0)) is None
