"""Changes of random programs, there and back; between two of them states stay as they are."""

from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import cast

import pytest

from tests.support_goals import Move, run_of
from tests.support_saved import with_scenario
from tests.whole_programs.drawing import drawn
from tests.whole_programs.settings import setting
from vrts.debug.history.subjects import tracks
from vrts.debug.history.track import APART, Track
from vrts.debug.passages import at_time, first_instant, last_instant
from vrts.engine.memory.events import SignalChanged
from vrts.engine.run import Run, State
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.request import Request
from vrts.run_files.simulated import simulate

NUMBERS = (0, 2, 4, 9)
CLOSE = 1e-7


def drawn_run(number: int) -> Run:
    given = drawn(number)
    place = with_scenario(setting(given.scene), given.scenario)
    program = ProgramFile(given.text.encode(), "main.v2")
    run = simulate(Request(program, place, Reading(given.dialect))).run
    assert run is not None
    return run


def subjects(run: Run) -> Iterator[tuple[str, Callable[[State], object]]]:
    """Yield names with what states say of them."""
    for name in run.at(run.horizon_s).variables:
        if "[" not in name:
            yield name, lambda state, n=name: state.variables.get(n)
    for number in sorted({e.signal for e in run.events if isinstance(e, SignalChanged)}):
        yield f"SIG({number})", lambda state, n=number: n in state.signals
    for body in run.placements:
        yield body, lambda state, b=body: (state.placements[b].lie, state.poses[b])
    yield "holds", lambda state: state.held
    yield "opening", lambda state: state.hand_opening
    yield "arm", lambda state: state.configuration
    yield "HERE", lambda state: state.base @ state.X_WT


def alike(one: object, other: object) -> bool:
    if isinstance(one, float) and isinstance(other, float):
        return abs(one - other) <= CLOSE
    if not (isinstance(one, tuple) and isinstance(other, tuple)):
        return one == other
    ours, theirs = cast("tuple[object, ...]", one), cast("tuple[object, ...]", other)
    return len(ours) == len(theirs) and all(map(alike, ours, theirs))


def there_and_back(track: Track) -> None:
    for k, moment in enumerate(track.moments):
        if moment.number == 0 or moment.instant <= first_instant(track.run):
            continue
        assert track.last(track.after(k)) == k, (track.name, k)
        assert track.following(track.before(k)) == k, (track.name, k)
        assert track.before(k) < moment.instant


def constant_between(run: Run, track: Track, seen: Callable[[State], object], name: str) -> None:
    spells = [(-1.0, 0.0), *((m.instant.time_s, m.settled_s) for m in track.moments)]
    ends = [*(start for start, _ in spells[1:]), run.horizon_s]
    for (_, settled), begins in zip(spells, ends, strict=True):
        if begins - settled < 4 * APART:
            continue
        times = [settled + APART, (settled + begins) / 2, begins - APART]
        values = [seen(run.at(min(time_s, run.horizon_s))) for time_s in times]
        assert all(alike(a, b) for a, b in pairwise(values)), (name, times, values)


def looked_at(run: Run) -> int:
    """Try the laws on everything that changes; return how many changes there were."""
    changed = 0
    for name, seen in subjects(run):
        for track in tracks(run, name, last_instant(run)):
            if name in run.placements and not track.name.startswith("the place"):
                continue
            changed += len(track.moments)
            there_and_back(track)
            constant_between(run, track, seen, name)
    return changed


def test_what_is_carried_goes_there_and_back() -> None:
    assert looked_at(run_of(Move("can1", 850, 200, -300))) > 20


@pytest.mark.parametrize("number", NUMBERS)
def test_who_and_next_give_the_same_change_and_nothing_changes_between(number: int) -> None:
    run = drawn_run(number)
    assert looked_at(run) > 5


@pytest.mark.parametrize("number", NUMBERS)
def test_no_write_of_a_variable_is_left_out(number: int) -> None:
    run = drawn_run(number)
    count = min(run.statements, 400)
    states = [run.at_statement(n).variables for n in range(count + 1)]
    for name in run.at(run.horizon_s).variables:
        if "[" in name:
            continue
        seen = [n for n in range(1, count + 1) if states[n].get(name) != states[n - 1].get(name)]
        (track, *_) = tracks(run, name, at_time(run, run.horizon_s))
        assert [m.number for m in track.moments if m.number and m.number <= count] == seen, name
