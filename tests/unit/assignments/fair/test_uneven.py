"""Variants are as hard as each other within stated bounds; what is not is named with why."""

import pytest

from vrts.assignments.fair.trial import Room, Trial
from vrts.assignments.fair.uneven import fits, measures, problems_of, shown
from vrts.check.variants.even import Even


def trial(
    number: int,
    time: float | None = 10.0,
    clearance: float | None = 0.03,
    room: float | None = 10.0,
    turned: float = 5.0,
) -> Trial:
    """Return a variant with a goal whose room may vary, and a narrow via point that does not."""
    goal = () if room is None else (Room("goal 1", "mm", room),)
    rooms = (Room("via 1", "mm", 5.0), *goal, Room("goal 1, turned", "deg", turned))
    return Trial((number,), (), time, clearance, rooms, b"x")


EVEN = Even(time=0.15, clearance=0.010, accuracy=0.2)
USUAL = [trial(k) for k in range(5)]


@pytest.mark.parametrize(
    ("odd", "words"),
    [
        (trial(9, time=11.6), ["time 11.6 s, and the median is 10.0 s"]),
        (trial(9, time=11.5), []),
        (trial(9, time=8.4), ["time 8.4 s, and the median is 10.0 s"]),
        (trial(9, clearance=0.0195), ["clearance 19.5 mm, and the median is 30.0 mm"]),
        (trial(9, clearance=0.020), []),
        (trial(9, room=7.9), ["accuracy of goal 1: 7.9 mm, and the median is 10.0 mm"]),
        (trial(9, turned=3.9), ["accuracy of goal 1, turned: 3.9 deg, and the median is 5.0 deg"]),
        (trial(9, room=None), ["accuracy of goal 1 cannot be measured"]),
        (trial(9, clearance=None), ["clearance cannot be measured, and 30.0 mm is the median"]),
        (trial(9, time=None), ["time cannot be measured"]),
        (trial(9, 12.0, 0.05), ["time 12.0 s, and", "clearance 50.0 mm, and"]),
    ],
)
def test_what_is_harder_or_easier_falls_out(odd: Trial, words: list[str]) -> None:
    trials = [*USUAL, odd]
    found = measures(trials, EVEN)
    out = dict(problems_of(trials, found))
    assert set(out) == ({(9,)} if words else set())
    assert all(told in why for told, why in zip(words, out.get((9,), ()), strict=True))
    assert fits(odd, found) == (not words)
    assert all(fits(one, found) for one in USUAL)


def test_median_and_extremes_are_told() -> None:
    found = measures([trial(0, 9.0), trial(1, 10.0), trial(2, 11.0, room=10.5)], EVEN)
    time, clearance, accuracy = shown(found)
    assert (accuracy.of, accuracy.most) == ("goal 1", (10.5, (2,)))
    assert (time.median, time.least, time.most) == (10.0, (9.0, (0,)), (11.0, (2,)))
    assert time.allowed == pytest.approx((8.5, 11.5))
    assert (time.bound, clearance.bound, accuracy.bound) == ("15 %", "10 mm", "20 %")


def test_what_cannot_be_measured_is_not_compared() -> None:
    unknown = Trial((7,), ("the robot cannot reach `can1`",))
    found = measures([unknown], EVEN)
    assert found == ()
    no_clearance = [trial(k, clearance=None) for k in range(3)]
    assert not dict(problems_of(no_clearance, measures(no_clearance, EVEN)))
    assert dict(problems_of([unknown], found)) == {(7,): unknown.problems}
