"""Runs the tables of the grammar over tokens.

A step with a sequence of token kinds seen before is not parsed again: the reductions are replayed
on its own tokens. Most steps of a program share their shape with another.
"""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, TypeAlias

from vrts.lang.grammar.tables import ACTIONS, ENDS, RULES, STARTS
from vrts.lang.syntax.token import Token

END = "$END"

Build: TypeAlias = Callable[[list[Any]], Any]
_SHIFT = -1  # in a tape; other numbers are rules


class Failure(NamedTuple):
    """Where a step stopped making sense."""

    at: int  # index of the token in the way; the number of tokens at the end of the step
    states: tuple[int, ...]  # the parser's stack then
    values: tuple[Any, ...]  # what had been understood


class TableParser:
    """Parses token sequences; `builders` make the nodes, by alias of the rule."""

    def __init__(self, builders: dict[str, Build]) -> None:
        self._builders: list[Build | None] = [
            None if alias == "same" else builders[alias] for _, _, alias in RULES
        ]
        self._tapes: dict[tuple[str, tuple[str, ...]], tuple[int, ...]] = {}

    def parse(self, start: str, tokens: Sequence[Token]) -> Any | Failure:
        """Return the node of a start symbol, or where the tokens stop making sense."""
        shape = (start, tuple([token.kind for token in tokens]))
        tape = self._tapes.get(shape)
        if tape is None:
            recorded = _record(start, shape[1])
            if isinstance(recorded, _Stuck):
                values = self._replay(recorded.tape, tokens)
                return Failure(recorded.at, recorded.states, tuple(values))
            tape = self._tapes[shape] = recorded
        return self._replay(tape, tokens)[0]

    def _replay(self, tape: Sequence[int], tokens: Sequence[Token]) -> list[Any]:
        values: list[Any] = []
        following = iter(tokens)
        builders = self._builders
        for rule in tape:
            if rule == _SHIFT:
                values.append(next(following))
                continue
            build = builders[rule]
            if build is None:
                continue
            length = RULES[rule][1]
            if length:
                values[-length:] = [build(values[-length:])]
            else:
                values.append(build([]))
        return values


class _Stuck(NamedTuple):
    at: int
    states: tuple[int, ...]
    tape: tuple[int, ...]


def _record(start: str, kinds: Sequence[str]) -> tuple[int, ...] | _Stuck:
    """Return the tape of a token sequence, or where it gets stuck."""
    states = [STARTS[start]]
    tape: list[int] = []
    for index, kind in enumerate((*kinds, END)):
        shifted, taped = tuple(states), len(tape)  # before what this token makes complete
        while True:
            if kind == END and states[-1] in ENDS:
                return tuple(tape)
            action = ACTIONS[states[-1]].get(kind)
            if action is None:
                return _Stuck(index, shifted, tuple(tape[:taped]))
            if action >= 0:
                states.append(action)
                tape.append(_SHIFT)
                break
            _reduce(states, -1 - action)
            tape.append(-1 - action)
    raise AssertionError("the end of the tokens is always accepted or refused")


def _reduce(states: list[int], rule: int) -> None:
    origin, length, _ = RULES[rule]
    if length:
        del states[-length:]
    states.append(ACTIONS[states[-1]][origin])


def expected(states: Sequence[int]) -> frozenset[str]:
    """Return the terminals that could have come next."""
    return frozenset(
        kind for kind in ACTIONS[states[-1]] if kind.isupper() and _accepts(states, kind)
    ) | frozenset([END] if _accepts(states, END) else [])


def _accepts(states: Sequence[int], kind: str) -> bool:
    stack = list(states)
    while True:
        if kind == END and stack[-1] in ENDS:
            return True
        action = ACTIONS[stack[-1]].get(kind)
        if action is None:
            return False
        if action >= 0:
            return True
        _reduce(stack, -1 - action)
