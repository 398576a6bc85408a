"""Whether inputs may go as a shorter story says: what cannot come is no counterexample."""

from collections.abc import Sequence

from vrts.prove.environment.automata import (
    AnsweringTicks,
    Automaton,
    States,
    after,
    automaton,
    first,
)
from vrts.prove.environment.environment import Environment
from vrts.prove.proof import Decided, What

Changes = list[tuple[int, bool]]  # at ticks


def allowed(
    environment: Environment,
    story: Sequence[Decided],
    whole: Sequence[Decided],
    until_s: float,
    tick_s: float,
) -> bool:
    """Return whether what is left of a story may come: what is as before may, as it was explored.

    Args:
        environment: What may come from outside.
        story: What is left.
        whole: What was explored.
        until_s: Up to when it matters [s].
        tick_s: How often the controller looks [s].
    """
    if any(_reads_nothing(story, whole, channel) for channel in _never_zero(environment)):
        return False
    for number, behaviour in environment.inputs.items():
        left = _changes(story, number, tick_s)
        if left == _changes(whole, number, tick_s):
            continue
        last = round(until_s / tick_s)
        if not _is_path(automaton(behaviour, tick_s), left, last):
            return False
    return True


def _never_zero(environment: Environment) -> list[int]:
    """Return the analog inputs that may not read 0, as they do where nobody says anything."""
    return [
        channel
        for channel, may in environment.analog.items()
        if (0 not in may.values if may.values else not may.least <= 0 <= may.most)
    ]


def _reads_nothing(story: Sequence[Decided], whole: Sequence[Decided], channel: int) -> bool:
    """Return whether an analog input that was told when it was read first is so no more."""
    mine, all_of_it = (
        next((d.time_s for d in of if d.what is What.ANALOG and d.number == channel), None)
        for of in (story, whole)
    )
    return mine != all_of_it


def _changes(story: Sequence[Decided], number: int, tick_s: float) -> Changes:
    return [
        (round(one.time_s / tick_s), one.value is True)
        for one in story
        if one.what is What.INPUT and one.number == number
    ]


def _is_path(it: Automaton, changes: Changes, last: int) -> bool:
    """Return whether an input may be off, and change so and no more up to a tick."""
    if isinstance(it, AnsweringTicks):
        return False  # when its output goes on is another thing in another story
    states, level, tick = first(it), False, 0
    for at, value in (*changes, (last + 1, False)):
        left = _stayed(it, states, level, min(at, last + 1) - tick)
        if not left:
            return False
        states, level, tick = left, value, at
    return True


def _stayed(it: Automaton, states: States, level: bool, ticks: int) -> States:
    """Return the states after so many ticks at a level, before it is looked at again."""
    for _ in range(ticks):
        kept = frozenset(state for state in states if state[0] is level)
        following = after(it, kept, 1, False) if kept else kept
        if not following or following == states:
            return following
        states = following
    return states
