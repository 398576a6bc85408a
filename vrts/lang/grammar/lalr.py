"""Runs the tables of the grammar over tokens.

A step with a sequence of token kinds seen before is not parsed again: the reductions are replayed
on its own tokens. Most steps of a program share their shape with another.
"""

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any, NamedTuple, TypeAlias

from vrts.lang.grammar.tables import ACTIONS, ENDS, RULES, STARTS
from vrts.lang.syntax.token import Token

END = "$END"

Build: TypeAlias = Callable[[list[Any]], Any]
_Tape: TypeAlias = tuple[tuple[int, Build | None], ...]  # from how many values to build what
_SHIFT = -1  # no rule: a token is taken
_FIRST = RULES.index(("chain", 1, "first"))
_EXPRESSION = RULES.index(("expression", 1, "expression"))


class Failure(NamedTuple):
    """Where a step stopped making sense."""

    at: int  # index of the token in the way; the number of tokens at the end of the step
    states: tuple[int, ...]  # the parser's stack then
    values: tuple[Any, ...]  # what had been understood


class TableParser:
    """Parses token sequences; `builders` make the nodes, by alias of the rule."""

    def __init__(self, builders: dict[str, Build]) -> None:
        self._builds: list[tuple[int, Build | None]] = [
            (length, None if alias == "same" else builders[alias]) for _, length, alias in RULES
        ]
        self._builds.append((0, None))  # stands at _SHIFT: a token is taken
        self._tapes: dict[tuple[str, tuple[str, ...]], _Tape] = {}

    def parse(self, start: str, tokens: Sequence[Token]) -> Any | Failure:
        """Return the node of a start symbol, or where the tokens stop making sense."""
        shape = (start, tuple([token.kind for token in tokens]))
        tape = self._tapes.get(shape)
        if tape is None:
            recorded = _record(start, shape[1])
            if isinstance(recorded, _Stuck):
                values = _replay(self._tape(recorded.tape), tokens)
                return Failure(recorded.at, recorded.states, tuple(values))
            tape = self._tapes[shape] = self._tape(recorded)
        return _replay(tape, tokens)[0]

    def _tape(self, recorded: Sequence[int]) -> _Tape:
        return tuple(map(self._builds.__getitem__, recorded))


def _replay(tape: _Tape, tokens: Sequence[Token]) -> list[Any]:
    values: list[Any] = []
    following = iter(tokens)
    for length, build in tape:
        if build is None:
            values.append(next(following))
        elif length == 1:
            values[-1] = build(values[-1:])
        elif length:
            values[-length:] = [build(values[-length:])]
        else:
            values.append(build([]))
    return values


class _Stuck(NamedTuple):
    at: int
    states: tuple[int, ...]
    tape: Sequence[int]


def _record(start: str, kinds: Sequence[str]) -> list[int] | _Stuck:
    """Return what a token sequence takes: shifts and the rules that build; or where it sticks."""
    states = [STARTS[start]]
    tape: list[int] = []
    for index, kind in enumerate((*kinds, END)):
        taped = len(tape)  # before what this token makes complete
        while True:
            if len(states) > 1:
                states[-1], single = _renamed(states[-2], states[-1], kind)
                tape += single
            if kind == END and states[-1] in ENDS:
                return tape
            action = ACTIONS[states[-1]].get(kind)
            if action is None:
                return _Stuck(index, _states(start, kinds[:index]), tape[:taped])
            if action >= 0:
                states.append(action)
                tape.append(_SHIFT)
                break
            origin, length, alias = RULES[-1 - action]
            if length:
                del states[-length:]
            states.append(ACTIONS[states[-1]][origin])
            if alias != "same":
                tape.append(-1 - action)
    raise AssertionError("the end of the tokens is always accepted or refused")


def _states(start: str, kinds: Sequence[str]) -> tuple[int, ...]:
    """Return the parser's stack behind tokens that make sense."""
    states = [STARTS[start]]
    for kind in kinds:
        while (action := ACTIONS[states[-1]][kind]) < 0:
            _reduce(states, -1 - action)
        states.append(action)
    return tuple(states)


@cache
def _renamed(below: int, state: int, kind: str) -> tuple[int, tuple[int, ...]]:
    """Return the state after all reductions of one symbol to one, and those that build something.

    A name is an operand, which is a chain, which is an expression: they come in a row, and which
    they are depends on the state below and on what comes next alone.
    """
    single: list[int] = []
    while not (kind == END and state in ENDS):
        action = ACTIONS[state].get(kind)
        if action is None or action >= 0:
            break
        origin, length, alias = RULES[-1 - action]
        if length != 1:
            break
        state = ACTIONS[below][origin]
        if -1 - action == _EXPRESSION and single[-1:] == [_FIRST]:
            single.pop()  # a chain of one operand is that operand
        elif alias != "same":
            single.append(-1 - action)
    return state, tuple(single)


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
