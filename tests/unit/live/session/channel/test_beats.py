"""When the next pose frame is due."""

import pytest

from vrts.live import actions as do
from vrts.live.session.channel.beats import Beats, shows
from vrts.live.session.channel.messages import Act, AskSnapshot, Halt


def test_beats_follow_one_another_by_twenty_milliseconds() -> None:
    beats = Beats(10.0)
    for count in range(5):
        assert beats.due_s == pytest.approx(10.0 + 0.020 * count)
        beats.kept(beats.due_s + 0.002)


def test_a_late_beat_is_followed_by_one_at_once_and_not_by_all_that_were_missed() -> None:
    beats = Beats(10.0)
    beats.kept(10.5)
    assert beats.due_s == 10.5
    beats.kept(10.502)
    assert beats.due_s == pytest.approx(10.52)


def test_a_beat_comes_sooner_once_and_the_others_follow_from_there() -> None:
    beats = Beats(10.0)
    beats.kept(10.001)
    beats.bring_forward(10.012)
    beats.bring_forward(10.015)
    assert beats.due_s == 10.012
    beats.kept(10.013)
    assert beats.due_s == pytest.approx(10.032)


def test_a_beat_for_after_the_next_one_delays_nothing() -> None:
    beats = Beats(10.0)
    beats.bring_forward(10.03)
    assert beats.due_s == 10.0
    beats.kept(10.001)
    assert beats.due_s == pytest.approx(10.02)
    beats.kept(10.021)
    assert beats.due_s == pytest.approx(10.03)
    beats.kept(10.031)
    assert beats.due_s == pytest.approx(10.05)


def test_beats_are_seldom_at_rest_where_that_will_do() -> None:
    beats = Beats(10.0)
    beats.kept(10.001, at_rest=True)
    assert beats.due_s == pytest.approx(10.02), "somebody watches"
    beats.seldom = True
    beats.kept(10.021, at_rest=True)
    assert beats.due_s == pytest.approx(10.82), "five in four seconds, not fifty in one"
    beats.bring_forward(10.05)  # by a command
    beats.kept(10.051)
    assert beats.due_s == pytest.approx(10.07)


def test_only_what_may_move_something_brings_a_beat_forward() -> None:
    assert shows(Halt(1, 0.0))
    assert shows(Act(1, 0.0, "ada", do.Ready()))
    assert not shows(Act(1, 0.0, "ada", do.Keep()))
    assert not shows(AskSnapshot(1))
