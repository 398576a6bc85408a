"""How a motion goes from 0 to 1: closed forms of time, speed and acceleration."""

import math
from itertools import pairwise

import pytest

from vrts.engine.motion.profile import Phase, Profile, at
from vrts.engine.motion.profile import profile as with_least

TICK = 0.028
TACC = 8 * TICK
SHORTEST = (0.0, 0.1, 2 * TACC, 0.6, 2.0)


def profile(
    shortest: float, acceleration: float, deceleration: float, tick: float, least: float = 0.0
) -> Profile:
    """Return the profile of a motion that takes at least twice its acceleration."""
    return with_least(shortest, acceleration, deceleration, tick, least, least_accelerations=2.0)


def slope(phase: Phase, x: float) -> float:
    t = x - phase.start
    return sum(k * (k - 1) * c * t ** (k - 2) for k, c in enumerate(phase.coefficients) if k > 1)


def corner(duration: float, half: float) -> Profile:
    """Return a profile that joins neighbours at both ends."""
    return Profile(duration, half, half, from_rest=False, to_rest=False)


def test_a_motion_takes_the_time_at_full_speed_and_one_acceleration() -> None:
    found = profile(1.0, TACC, TACC, TICK)
    assert found.duration == pytest.approx(math.ceil(1.0 / TICK) * TICK)
    assert found.total == pytest.approx(found.duration + TACC)


def test_a_motion_lasts_at_least_two_accelerations() -> None:
    assert profile(0.0, TACC, TACC, TICK).duration == pytest.approx(2 * TACC)
    assert profile(0.0, TACC, 2 * TACC, TICK).duration == pytest.approx(4 * TACC)


def test_duration_is_a_least_time() -> None:
    assert profile(1.0, TACC, TACC, TICK, 3.0).duration >= 3.0
    assert profile(1.0, TACC, TACC, TICK, 0.5) == profile(1.0, TACC, TACC, TICK)


def test_a_whole_number_of_ticks_is_not_rounded_up() -> None:
    for count in range(20, 400):
        assert round(profile(count * TICK, TACC, TACC, TICK).duration / TICK) == count


@pytest.mark.parametrize("shortest", SHORTEST)
def test_it_starts_and_ends_at_rest(shortest: float) -> None:
    found = profile(shortest, TACC, TACC, TICK)
    assert at(found.head(), found.begin) == (0.0, 0.0)
    assert at(found.tail(), found.end) == pytest.approx((1.0, 0.0), abs=1e-12)


@pytest.mark.parametrize("shortest", SHORTEST)
@pytest.mark.parametrize("rounded", [False, True])
def test_phases_join_in_place_and_speed(shortest: float, rounded: bool) -> None:
    found = profile(shortest, TACC, TACC, TICK)
    if rounded:
        found = corner(found.duration, TACC)
    for before, after in pairwise(found.phases()):
        assert before.start + before.length == pytest.approx(after.start)
        assert at(before, after.start) == pytest.approx(at(after, after.start), abs=1e-12)


@pytest.mark.parametrize("shortest", SHORTEST)
def test_between_the_ends_the_speed_is_the_least_that_arrives_in_time(shortest: float) -> None:
    found = profile(shortest, TACC, TACC, TICK)
    x = 0.5 * found.duration
    body = found.body() or found.tail()
    assert at(body, x) == pytest.approx((0.5, 1.0 / found.duration))


def test_from_rest_the_acceleration_is_the_speed_over_the_time_of_it() -> None:
    found = profile(2.0, TACC, TACC, TICK)
    for x in (-0.1, 0.0, 0.1):
        assert slope(found.head(), x) == pytest.approx(1.0 / found.duration / TACC)


def test_in_a_corner_the_acceleration_is_at_most_half_more() -> None:
    found = corner(2.0, TACC)
    head = found.head()
    steepest = max(slope(head, head.start + k * head.length / 200) for k in range(201))
    assert steepest == pytest.approx(1.5 * (1.0 / 2.0) / (2.0 * TACC), rel=1e-3)
    assert slope(head, head.start) == pytest.approx(0.0, abs=1e-9)
    assert slope(head, head.start + head.length) == pytest.approx(0.0, abs=1e-9)


def test_a_corner_is_pauls_transition() -> None:
    """The two zones added are the polynomial of the reference, for motions of other durations."""
    first, second = 1.4, 2.1  # [s]
    out, into = corner(first, TACC).tail(), corner(second, TACC).head()
    change_in, change_out = 0.7, -0.4  # from A' to B, from B to C
    start = -change_in * TACC / first  # A - B
    for k in range(21):
        h = k / 20
        t = 2 * TACC * h - TACC
        pull = change_out * TACC / second + start
        expected = (pull * (2 - h) * h * h - 2 * start) * h + start
        added = change_in * (at(out, first + t)[0] - 1.0) + change_out * at(into, t)[0]
        assert added == pytest.approx(expected, abs=1e-12)
