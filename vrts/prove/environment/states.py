"""What inputs may be now, as a plain state that goes with a future; only this file reads it."""

from typing import TypeAlias, cast

from vrts.prove.environment.automata import AnsweringTicks as Follows
from vrts.prove.environment.automata import States, after, automaton, first
from vrts.prove.environment.environment import Environment

# of every input that is not free, by number; hashable, and alike where futures go on alike
Inputs: TypeAlias = tuple[tuple[int, States], ...]
BOTH = (False, True)


class Behaviours:
    """What an environment says of inputs. It keeps no state: that goes with each future."""

    def __init__(self, environment: Environment, tick_s: float) -> None:
        """Take the behaviours of inputs for a controller with so long a tick [s]."""
        self._automata = {
            signal: automaton(behaviour, tick_s)
            for signal, behaviour in sorted(environment.inputs.items())
        }

    def begin(self) -> Inputs:
        """Return the state in the first tick."""
        return tuple((signal, first(it)) for signal, it in self._automata.items())

    def may(self, states: object, signal: int) -> tuple[bool, ...]:
        """Return what an input may be now."""
        for number, own in cast("Inputs", states):
            if number == signal:
                return tuple(sorted({level for level, *_ in own}))
        return BOTH

    def says(self, signal: int) -> bool:
        """Return whether an environment says anything of an input."""
        return signal in self._automata

    def told(self, states: object, signal: int, *, value: bool) -> Inputs:
        """Return the state once an input was looked at, and what it was."""
        if not states:
            return ()
        return tuple(
            (number, frozenset(s for s in own if s[0] is value) if number == signal else own)
            for number, own in cast("Inputs", states)
        )

    def advance(self, states: object, ticks: int, outputs_on: frozenset[int]) -> Inputs:
        """Return the state some ticks later; `outputs_on` are on from now on and all the time."""
        if not states:
            return ()
        found: list[tuple[int, States]] = []
        for number, own in cast("Inputs", states):
            it = self._automata[number]
            on = isinstance(it, Follows) and it.output in outputs_on
            found.append((number, after(it, own, ticks, on)))
        return tuple(found)
