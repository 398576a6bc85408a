"""A track tells at every instant what held, also after it was cut at either end."""

import random
from array import array

import pytest

from vrts.engine.memory.shorter import Columns
from vrts.engine.memory.track import Track

TICK_S = 0.028
TICKS = 12
MOST = 6  # statements of a tick


def drawn(seed: int) -> tuple[Track[int], list[tuple[int, int, int]]]:
    """Return a track of a few ticks, and its changes: tick, statements with the one, value."""
    draw, track = random.Random(seed), Track[int](array("I"))
    changes: list[tuple[int, int, int]] = []
    for tick in range(TICKS):
        for place in sorted(draw.choices(range(MOST), k=draw.choice((0, 1, 3)))):
            changes.append((tick, tick * MOST + place, len(changes)))
            track.note(tick * TICK_S, *changes[-1][1:])
    return track, changes


def held(changes: list[tuple[int, int, int]], tick: float, finished: int) -> int | None:
    """Return what held at a tick: of its own changes only those of finished statements count."""
    last = None
    for at, number, value in changes:
        if at < tick or (at == tick and number <= finished):
            last = value
    return last


INSTANTS = [(tick, tick * MOST + place) for tick in range(TICKS) for place in range(-1, MOST)]


@pytest.mark.parametrize("seed", range(4))
def test_at_every_instant_it_tells_what_held_then(seed: int) -> None:
    track, changes = drawn(seed)
    assert len(changes) > TICKS / 2
    for tick, finished in INSTANTS:
        assert track.at(tick * TICK_S, finished) == held(changes, tick, finished)
        later = (tick + 0.5) * TICK_S  # the tick is over: all of it counts
        assert track.at(later, (tick + 1) * MOST) == held(changes, tick + 0.5, 0)


@pytest.mark.parametrize("seed", range(4))
def test_what_is_cut_tells_the_past_and_has_no_part_in_another_future(seed: int) -> None:
    track, changes = drawn(seed)
    for end in range(TICKS):
        other = track.cut(end * TICK_S)
        for tick, finished in INSTANTS:
            if tick <= end:
                assert other.at(tick * TICK_S, finished) == held(changes, tick, finished)
        kept = len(other.times)
        assert kept == sum(tick <= end for tick, _, _ in changes)
        other.note(end * TICK_S, (end + 1) * MOST, 99)
        assert len(track.times) == len(changes)
        track.note(TICKS * TICK_S, TICKS * MOST, 77)
        assert len(other.times) == kept + 1
        for column in (track.times, track.numbers, track.values):
            column.pop()


@pytest.mark.parametrize("seed", range(4))
def test_what_is_shorter_tells_the_same_from_then_on_and_what_is_shared_stays_so(
    seed: int,
) -> None:
    for begin in range(TICKS):
        track, changes = drawn(seed)
        columns = Columns()
        one, two = (track.shorter(begin * TICK_S, columns) for _ in range(2))
        for tick, finished in INSTANTS:
            if tick >= begin:
                assert one.at(tick * TICK_S, finished) == held(changes, tick, finished)
        assert len(one.times) <= 1 + sum(tick >= begin for tick, _, _ in changes)
        one.note(TICKS * TICK_S, TICKS * MOST, 77)
        assert two.values[-1] == 77, "copies of a machine share it until they are cut"
