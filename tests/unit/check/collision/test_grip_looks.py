"""When rules change is decided by what is proven at once, as by exact distances."""

import random
from collections.abc import Callable
from functools import partial

import pytest

from vrts.check.collision.pairs.grips import (
    Asking,
    Gap,
    Grip,
    Look,
    counted_from,
    counted_until,
    finger_windows,
)

END = 6.0  # [s]
Course = Callable[[float], float]  # a distance [m] at a time [s]


def course(chance: random.Random) -> Course:
    """Return a distance that grows, stays and falls, often near what it is compared with."""
    values = (0.0, 1e-4, 2e-4, 2.001e-4, 4.999e-3, 5e-3, 5.002e-3, 6e-3, 4.9e-2, 5.1e-2)
    steps = [chance.choice(values) for _ in range(12)]
    return lambda t: steps[min(int(max(t, 0.0) / END * len(steps)), len(steps) - 1)] - 1e-7 * t


def told(asking: Asking[object], distance: Course, loose: Callable[[], float]) -> object:
    """Answer every look: what is proven at once is off by `loose` to either side [m]."""
    found: list[Gap] | None = None
    while True:
        try:
            look: Look = next(asking) if found is None else asking.send(found)
        except StopIteration as end:
            return end.value
        found = []
        for t in look.times.tolist():
            low, high = (0.0, 0.0) if look.exact else (loose(), loose())
            found.append(Gap(distance(t) - low, distance(t) + high))


QUESTIONS: tuple[Callable[[], Asking[object]], ...] = (
    lambda: finger_windows([Grip("can", 0.5, 1.0), Grip("can", 3.0, 3.5)], 0.0, END),
    lambda: finger_windows([Grip("can", 0.5, 1.0)], 0.0, END, near_miss=None),
    lambda: counted_from(0.0, END),
    lambda: counted_until(0.0, END),
)


@pytest.mark.parametrize("ask", QUESTIONS)
def test_bounds_however_loose_change_no_answer(ask: Callable[[], Asking[object]]) -> None:
    for number in range(40):
        chance = random.Random(number)
        distance = course(chance)
        exactly = told(ask(), distance, lambda: 0.0)
        for most in (1e-6, 1e-4, 1.0):
            assert told(ask(), distance, partial(chance.uniform, 0.0, most)) == exactly


def test_nothing_is_asked_exactly_that_is_plain_at_once() -> None:
    looks: list[bool] = []
    asking = finger_windows([Grip("can", 0.5, 1.0)], 0.0, END)
    found: list[Gap] | None = None
    while True:
        try:
            look = next(asking) if found is None else asking.send(found)
        except StopIteration:
            break
        looks.append(look.exact)
        found = [Gap(0.03 * (t - 1.0) - 1e-6, 0.03 * (t - 1.0) + 1e-6) for t in look.times.tolist()]
    assert looks
    assert not any(looks)
