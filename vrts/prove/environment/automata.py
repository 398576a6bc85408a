"""Inputs as automata that go on a tick at a time: all states that one may be in, as a set.

Nobody may look at an input for a while, and it goes on all the same. So what is kept is the set of
states that fit what was seen; looking takes those away that do not fit. Durations are rounded
outward to whole ticks: a stay of 0.1 to 0.5 s lasts 3 to 18 ticks of 28 ms.
"""

import math
from functools import lru_cache
from typing import NamedTuple, TypeAlias

from vrts.prove.environment.environment import Answering, Held, Pulsed, Span

ROUNDING = 1e-6  # of a tick
FOR_EVER = -1  # ticks


class Ticks(NamedTuple):
    """How many ticks something lasts."""

    least: int
    most: int  # FOR_EVER: no bound

    @property
    def cap(self) -> int:
        """The age from which on nothing changes any more."""
        return self.least if self.most == FOR_EVER else self.most


class PulsedTicks(NamedTuple):
    """An input that goes on and off by itself."""

    on: Ticks
    off: Ticks

    def stay(self, level: bool) -> Ticks:
        """Return how long it stays at a level."""
        return self.on if level else self.off


class AnsweringTicks(NamedTuple):
    """An input that follows an output."""

    output: int
    on: Ticks
    off: Ticks


class HeldLevel(NamedTuple):
    """An input that stays as it is."""

    on: bool | None


Automaton: TypeAlias = PulsedTicks | AnsweringTicks | HeldLevel
# level, age in ticks, and whether the output that it follows is on
State: TypeAlias = tuple[bool, int, bool]
States: TypeAlias = frozenset[State]


def ticks(span: Span, tick_s: float) -> Ticks:
    """Return how many ticks of a controller a span may take, rounded outward."""
    most = FOR_EVER if math.isinf(span.most) else math.ceil(span.most / tick_s - ROUNDING)
    return Ticks(math.floor(span.least / tick_s + ROUNDING), most)


def automaton(behaviour: Held | Pulsed | Answering, tick_s: float) -> Automaton:
    """Return a behaviour in ticks of a controller."""
    match behaviour:
        case Held(on=on):
            return HeldLevel(on)
        case Pulsed(on_s=on, off_s=off):
            return PulsedTicks(ticks(on, tick_s), ticks(off, tick_s))
        case Answering(output=output, on_s=on, off_s=off):
            return AnsweringTicks(output, ticks(on, tick_s), ticks(off, tick_s))


def first(it: Automaton) -> States:
    """Return the states at the start: off, for nobody knows how long."""
    match it:
        case HeldLevel(on=on):
            levels = (False, True) if on is None else (on,)
            return frozenset((level, 0, False) for level in levels)
        case PulsedTicks(off=off):
            return frozenset((False, age, False) for age in range(1, max(off.cap, 1) + 1))
        case AnsweringTicks(off=off):
            return frozenset([(False, off.cap, False)])


@lru_cache(maxsize=65_536)
def after(it: Automaton, states: States, count: int, output_on: bool) -> States:
    """Return the states some ticks later.

    Args:
        it: The automaton.
        states: That it may be in.
        count: How many ticks later, 1 or more.
        output_on: Whether the output that it follows is on, from now on and in all of them.
    """
    for _ in range(count):
        following = frozenset(state for one in states for state in _next(it, one, output_on))
        if following == states:
            break
        states = following
    return states


def _next(it: Automaton, state: State, output_on: bool) -> list[State]:
    match it:
        case HeldLevel():
            return [state]
        case PulsedTicks():
            return _pulsed(it, state)
        case AnsweringTicks():
            return _answering(it, state, output_on)


def _pulsed(it: PulsedTicks, state: State) -> list[State]:
    level, age, _ = state
    stay, other = it.stay(level), it.stay(not level)
    found: list[State] = []
    if stay.most == FOR_EVER or age < stay.most:
        found.append((level, min(age + 1, max(stay.cap, 1)), False))
    if age >= stay.least:
        found.append((not level, 1, False))
        if other.least == 0:  # it may come and go between two ticks, and begin anew
            found.append((level, 1, False))
    return found


def _answering(it: AnsweringTicks, state: State, output_on: bool) -> list[State]:
    level, age, was_on = state
    span = it.on if output_on else it.off
    age = 1 if was_on is not output_on else min(age + 1, max(span.cap, 1))
    if level is output_on:
        return [(level, age, output_on)]
    found: list[State] = []
    if age >= span.least:
        found.append((output_on, age, output_on))
    if span.most == FOR_EVER or age < span.most:
        found.append((level, age, output_on))
    return found
