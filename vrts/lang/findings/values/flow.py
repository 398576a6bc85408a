"""The numbers of a program on every way through it.

An abstract interpretation: what a variable may be is followed over the jumps of the IR, step by
step, from the start of a program, of which nothing is known. Where ways meet, both values are
possible; what still grows after some passes of a loop may be anything on that side. A variable that
something else may change while the program runs is not followed.
"""

import heapq
import math
from collections.abc import Mapping
from typing import NamedTuple, TypeAlias

from vrts.ir import instructions as i
from vrts.ir.instructions import jumps_of
from vrts.ir.module import Program
from vrts.lang.findings.values import intervals
from vrts.lang.findings.values.evaluate import evaluate
from vrts.lang.findings.values.intervals import ANY, Interval, point
from vrts.lang.names import key
from vrts.lang.syntax.expressions import (
    Element,
    Expression,
    Infix,
    Item,
    Name,
    Parenthesised,
    Prefix,
)
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import (
    Assignment,
    CallStatement,
    For,
    Give,
    Goto,
    If,
    Simple,
    Statement,
    Until,
    ValueGroup,
    While,
)

PATIENCE = 3  # visits of a place until what grows may be anything

State: TypeAlias = dict[str, Interval]  # of the variables of which something is known


class Followed(NamedTuple):
    """What is followed through one program."""

    names: frozenset[str]  # keys of variables
    changed_by: Mapping[str, frozenset[str] | None]  # by a call of a program; None: anything
    alone: bool  # whether no program of another file may run meanwhile


def states(
    text: ProgramText, program: Program, followed: Followed, start: State
) -> dict[int, State]:
    """Return what is known where each step begins, by its number; steps never reached have none."""
    return _Flow(text, program, followed).run(start)


class _Flow:
    def __init__(self, text: ProgramText, program: Program, followed: Followed) -> None:
        self.program = program
        self.followed = followed
        self.statements = {step.number: step.statement for step in text.steps}
        self.entries: dict[int, State] = {}  # of instructions that jumps or joins lead to
        self.visits: dict[int, int] = {}
        self.waiting: list[int] = [0]
        jumps = [(t, at) for at, c in enumerate(program.instructions) for t in jumps_of(c)]
        self.joins = {0} | {target for target, _ in jumps}
        self.heads = {target for target, at in jumps if target <= at}  # of loops
        code = program.instructions
        waits = {at for at in self.heads if not isinstance(code[at], i.TestFor)}
        self.forgetting: set[int] = (
            set() if followed.alone else waits
        )  # who waits there is told anything
        self.loops: dict[int, For] = {}

    def run(self, start: State) -> dict[int, State]:
        self.entries[0] = dict(start)
        while self.waiting:
            self._stretch(heapq.heappop(self.waiting), None)
        found: dict[int, State] = {}
        for at in sorted(self.entries):
            self._stretch(at, found)
        return found

    def _stretch(self, at: int, found: dict[int, State] | None) -> None:
        """Follow a straight row of instructions; only record where nothing is to be spread."""
        state = dict(self.entries[at])
        code, origins = self.program.instructions, self.program.origins
        while at < len(code):
            number = origins[at].step
            if found is not None and number not in found:
                found[number] = dict(state)
            following = self._instruction(code[at], self.statements.get(number), state, at)
            if found is None:
                for target, known in following[1:]:
                    self._reach(target, known)
            if not following or following[0][0] != at + 1:
                if following and found is None:
                    self._reach(*following[0])
                return
            at, state = following[0]
            if at in self.joins:
                if found is None:
                    self._reach(at, state)
                return

    def _reach(self, at: int, state: State) -> None:
        if at in self.forgetting:
            state = {name: value for name, value in state.items() if " " in name}
        before = self.entries.get(at)
        if before is None:
            self.entries[at] = dict(state)
            heapq.heappush(self.waiting, at)
            return
        self.visits[at] = visits = self.visits.get(at, 0) + 1
        joined: State = {}
        for name, old in before.items():
            new = state.get(name)
            if new is None:
                continue
            both = intervals.hull(old, new)
            wide = visits > PATIENCE and at in self.heads
            joined[name] = intervals.widened(old, both) if wide else both
        joined = {name: value for name, value in joined.items() if value != ANY}
        if joined != before:
            self.entries[at] = joined
            heapq.heappush(self.waiting, at)

    def _instruction(
        self, code: i.Instruction, node: Statement | None, state: State, at: int
    ) -> list[tuple[int, State]]:
        """Return where an instruction leads to, and what is known there; the next one first."""
        match code:
            case i.Jump(target):
                return [(target, state)]
            case i.JumpIf(_, when, target):
                return self._condition(_condition_of(node), state, at, target, when=when)
            case i.BeginFor(_, _, _, _, loop):
                assert isinstance(node, For)
                self.loops[loop] = node
                first, last = self._value(node.first, state), self._value(node.last, state)
                by = self._value(node.increment, state) if node.increment else point(1.0)
                self._give(node.target, first, state)
                state[f"limit {loop}"], state[f"step {loop}"] = last, by
                return [(at + 1, state)]
            case i.TestFor(_, loop, leave):
                return self._test(loop, state, at, leave)
            case i.NextFor(_, loop, test):
                node = self.loops.get(loop)
                if node is not None:
                    by = state.get(f"step {loop}", ANY)
                    now = self._value(node.target, state)
                    self._give(node.target, intervals.added(now, by), state)
                else:
                    _forget_all(state, self.followed.names)  # jumped into
                return [(test, state)]
            case i.BeginCase(_, case):
                selector = getattr(node, "selector", None)
                state[f"case {case}"] = self._value(selector, state)
                return [(at + 1, state)]
            case i.TestCase(case, _, otherwise):
                return self._group(code.case, node, state, at, otherwise)
            case i.Return() | i.ReturnError() | i.Stop() | i.Halt():
                return []
            case i.Grasp(_, int(missing)):
                return [(at + 1, state), (missing, dict(state))]
            case _:
                self._change(code, node, state)
                return [(at + 1, state)]

    def _condition(
        self, node: Expression | None, state: State, at: int, target: int, *, when: bool
    ) -> list[tuple[int, State]]:
        holds = intervals.truth(self._value(node, state))
        ways: list[tuple[int, State]] = []
        for jumps in (False, True):
            wanted = when if jumps else not when
            if holds is (not wanted):
                continue
            known = dict(state)
            if node is not None and self._refine(node, known, holds=wanted):
                ways.append((target if jumps else at + 1, known))
        return ways

    def _test(self, loop: int, state: State, at: int, leave: int) -> list[tuple[int, State]]:
        node = self.loops.get(loop)
        if node is None:
            return [(at + 1, state), (leave, dict(state))]
        now, last = self._value(node.target, state), state.get(f"limit {loop}", ANY)
        by = state.get(f"step {loop}", ANY)
        within, past = dict(state), dict(state)
        if by[0] > 0.0:
            goes_on = self._narrow(node.target, (-math.inf, last[1]), within)
            ends = now[1] > last[0] and self._narrow(node.target, (last[0], math.inf), past)
        elif by[1] < 0.0:
            goes_on = self._narrow(node.target, (last[0], math.inf), within)
            ends = now[0] < last[1] and self._narrow(node.target, (-math.inf, last[1]), past)
        else:
            goes_on = ends = True
        ways: list[tuple[int, State]] = []
        if goes_on:
            ways.append((at + 1, within))
        if ends:
            ways.append((leave, past))
        return ways

    def _group(
        self, case: int, node: Statement | None, state: State, at: int, otherwise: int
    ) -> list[tuple[int, State]]:
        selector = state.get(f"case {case}", ANY)
        values = node.values if isinstance(node, ValueGroup) else ()
        equal = [intervals.equal(selector, self._value(v, state)) for v in values]
        ways: list[tuple[int, State]] = []
        if not equal or any(known is not False for known in equal):
            ways.append((at + 1, state))
        if True not in equal:
            ways.append((otherwise, dict(state)))
        return ways

    # --- what changes ---------------------------------------------------------------------------

    def _change(self, code: i.Instruction, node: Statement | None, state: State) -> None:
        match node:
            case Assignment(target, value) if isinstance(code, i.Assign):
                self._give(target, self._value(value, state), state)
            case CallStatement(program, arguments):
                changed = self.followed.changed_by.get(key(program.text))
                if changed is None or program.text == "":
                    _forget_all(state, self.followed.names)
                else:
                    for name in changed:
                        state.pop(name, None)
                for argument in arguments:
                    self._forget(argument, state)
            case Give(_, target):
                self._forget(target, state)
            case Simple("PROMPT", operands):
                for operand in operands:
                    self._forget(operand, state)
            case _:
                if isinstance(code, i.CallNamed | i.Opaque):
                    _forget_all(state, self.followed.names)

    def _give(self, target: Expression, value: Interval, state: State) -> None:
        if not isinstance(target, Name):
            return
        name = key(target.text)
        if name in self.followed.names and value != ANY:
            state[name] = value
        else:
            state.pop(name, None)

    def _forget(self, node: Item | None, state: State) -> None:
        name = node.name if isinstance(node, Element) else node
        if isinstance(name, Name):
            state.pop(key(name.text), None)

    def _value(self, node: Item | None, state: State) -> Interval:
        return evaluate(node, lambda name: state.get(name, ANY))

    # --- what conditions tell -------------------------------------------------------------------

    def _refine(self, node: Expression, state: State, *, holds: bool) -> bool:
        """Take over what a condition tells; False where it cannot be."""
        match node:
            case Parenthesised(inner):
                return self._refine(inner, state, holds=holds)
            case Prefix("NOT", operand):
                return self._refine(operand, state, holds=not holds)
            case Infix("AND", left, right) if holds:
                return self._refine(left, state, holds=True) and self._refine(
                    right, state, holds=True
                )
            case Infix("OR", left, right) if not holds:
                return self._refine(left, state, holds=False) and self._refine(
                    right, state, holds=False
                )
            case Infix(operator, left, right) if operator in _NEGATED:
                known = _NEGATED[operator] if not holds else operator
                a, b = self._value(left, state), self._value(right, state)
                if known == "<>":
                    return True
                return self._narrow(left, _bounds(known, b), state) and self._narrow(
                    right, _bounds(_MIRRORED[known], a), state
                )
            case _:
                return True

    def _narrow(self, node: Expression, bounds: Interval, state: State) -> bool:
        """Take over the bounds of a variable; False where it cannot lie within them."""
        while isinstance(node, Parenthesised):
            node = node.inner
        if not isinstance(node, Name) or key(node.text) not in self.followed.names:
            return True
        name = key(node.text)
        low, high = state.get(name, ANY)
        low, high = max(low, bounds[0]), min(high, bounds[1])
        if low > high:
            return False
        if (low, high) != ANY:
            state[name] = (low, high)
        return True


def _bounds(operator: str, other: Interval) -> Interval:
    """Return what a number may be that compares so with another."""
    if operator == "==":
        return other
    if operator in ("<", "<="):
        return -math.inf, other[1]
    return other[0], math.inf


_NEGATED = {"==": "<>", "<>": "==", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}
_MIRRORED = {"==": "==", "<": ">", ">": "<", "<=": ">=", ">=": "<="}


def _forget_all(state: State, names: frozenset[str]) -> None:
    for name in names:
        state.pop(name, None)


def _condition_of(node: Statement | None) -> Expression | None:
    return node.condition if isinstance(node, If | While | Until | Goto) else None
