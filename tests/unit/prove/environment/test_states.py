"""What inputs may be: compared with every trace there is, written out one by one."""

from collections.abc import Iterator
from itertools import product
from math import inf
from types import MappingProxyType

import pytest

from vrts.prove.environment.environment import (
    Answering,
    Behaviour,
    Environment,
    Held,
    Pulsed,
    Span,
)
from vrts.prove.environment.states import Behaviours, Inputs

TICK = 0.1  # [s]
LONG = 9  # ticks of a trace
INPUT = 1001


def environment(behaviour: Behaviour) -> Behaviours:
    return Behaviours(Environment(inputs=MappingProxyType({INPUT: behaviour})), TICK)


def stays(trace: tuple[bool, ...]) -> list[tuple[bool, int]]:
    """Return the levels of a trace, and for how many ticks each stays."""
    found: list[tuple[bool, int]] = []
    for level in trace:
        if found and found[-1][0] is level:
            found[-1] = (level, found[-1][1] + 1)
        else:
            found.append((level, 1))
    return found


def is_pulsed(trace: tuple[bool, ...], on: tuple[int, float], off: tuple[int, float]) -> bool:
    """Return whether a trace is one of an input that goes on and off; no stay is hidden."""
    own = stays(trace)
    for k, (level, count) in enumerate(own):
        least, most = on if level else off
        if count > most or (0 < k < len(own) - 1 and count < least):
            return False  # the first may have begun before, the last may go on
    return not trace[0] or off[0] == 0


def agree(made: Behaviours, traces: list[tuple[bool, ...]], outputs: tuple[bool, ...]) -> None:
    """Compare what may follow each beginning of a trace with what the traces have."""
    for k in range(LONG):
        for seen in {trace[:k] for trace in traces}:
            states = told(made, seen, outputs)
            expected = {trace[k] for trace in traces if trace[:k] == seen}
            assert set(made.may(states, INPUT)) == expected, seen


def told(made: Behaviours, seen: tuple[bool, ...], outputs: tuple[bool, ...]) -> Inputs:
    """Return the state after an input was looked at in the first ticks."""
    states = made.begin()
    for k, value in enumerate(seen):
        states = made.told(states, INPUT, value=value)
        states = made.advance(states, 1, frozenset([1] if outputs[k] else []))
    return states


def all_traces() -> Iterator[tuple[bool, ...]]:
    return product((False, True), repeat=LONG)


@pytest.mark.parametrize("on", [(1, 2), (2, 2), (2, 4), (3, inf)])
@pytest.mark.parametrize("off", [(1, 1), (1, 3), (2, 3), (2, inf)])
def test_pulses_last_as_long_as_they_may(on: tuple[int, float], off: tuple[int, float]) -> None:
    spans = [Span(TICK * least, TICK * most) for least, most in (on, off)]
    made = environment(Pulsed(*spans))
    traces = [trace for trace in all_traces() if is_pulsed(trace, on, off)]
    agree(made, traces, (False,) * LONG)


def follows(
    trace: tuple[bool, ...],
    outputs: tuple[bool, ...],
    on: tuple[int, float],
    off: tuple[int, float],
) -> bool:
    """Return whether a trace follows an output, which is set at the end of each tick."""
    level, wanted, changed = False, False, -1000
    for k, value in enumerate(trace):
        if k > 0 and outputs[k - 1] is not wanted:
            wanted, changed = outputs[k - 1], k - 1
        least, most = on if wanted else off
        age = k - changed
        if value is not level:
            if value is not wanted or age < least:
                return False
            level = value
        if level is not wanted and age >= most:
            return False
    return True


OUTPUTS = [
    (False, True, True, True, True, True, True, True, True),
    (True, True, True, True, False, False, False, False, False),
    (False, True, False, True, True, True, False, False, False),
]


@pytest.mark.parametrize("outputs", OUTPUTS)
@pytest.mark.parametrize("on", [(1, 1), (1, 3), (2, 3), (2, inf)])
@pytest.mark.parametrize("off", [(1, 2), (3, inf)])
def test_answers_come_in_time(
    outputs: tuple[bool, ...], on: tuple[int, float], off: tuple[int, float]
) -> None:
    spans = [Span(TICK * least, TICK * most) for least, most in (on, off)]
    made = environment(Answering(1, *spans))
    traces = [trace for trace in all_traces() if follows(trace, outputs, on, off)]
    agree(made, traces, outputs)


def test_what_is_held_is_told_once() -> None:
    assert environment(Held(on=True)).may(environment(Held(on=True)).begin(), INPUT) == (True,)
    made = environment(Held(on=None))
    states = made.begin()
    assert made.may(states, INPUT) == (False, True)
    states = made.advance(made.told(states, INPUT, value=True), 100, frozenset())
    assert made.may(states, INPUT) == (True,)


def test_what_nobody_speaks_of_is_free_and_no_part_of_the_state() -> None:
    made = Behaviours(Environment(), TICK)
    assert made.begin() == ()
    states = made.advance(made.told((), INPUT, value=True), 3, frozenset())
    assert made.may(states, INPUT) == (False, True)


def test_many_ticks_at_once_are_as_many_single_ones() -> None:
    made = environment(Pulsed(Span(0.2, 0.4), Span(0.3, 0.6)))
    one = made.told(made.begin(), INPUT, value=False)
    single = one
    for _ in range(7):
        single = made.advance(single, 1, frozenset())
    assert made.advance(one, 7, frozenset()) == single


def test_at_rest_the_state_no_longer_changes() -> None:
    made = environment(Answering(1, Span(0.2, 1.0), Span(0.2, 1.0)))
    states = made.advance(made.begin(), 50, frozenset([1]))
    assert made.may(states, INPUT) == (True,)
    assert made.advance(states, 1, frozenset([1])) == states


def test_a_pulse_shorter_than_a_tick_may_be_missed() -> None:
    made = environment(Pulsed(Span(0.01, 0.05), Span(0.2, 0.3)))
    states = made.begin()
    for _ in range(20):  # longer than it may stay off: it was on between two ticks
        states = made.advance(made.told(states, INPUT, value=False), 1, frozenset())
        assert False in made.may(states, INPUT)
