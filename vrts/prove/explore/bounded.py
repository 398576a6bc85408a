"""What programs do with what is typed at PROMPT: compare it, use it within bounds, or more.

What is only compared with constants is told apart by these. A number with which more is done has to
come between two of them first, on every way that leads there: what lies outside never gets further
then. Where neither can be shown, nothing is claimed.
"""

import math
from collections.abc import Iterator
from typing import NamedTuple

from vrts.engine.futures.regions import number
from vrts.engine.machine.forever.nodes import all_nodes, tops
from vrts.ir import instructions as ir
from vrts.ir.expressions import (
    Binary,
    BinaryOperator,
    Constant,
    Expression,
    Global,
    Load,
    Place,
    Slot,
    Unary,
    UnaryOperator,
)
from vrts.ir.instructions import jumps_of
from vrts.ir.module import Module, Program
from vrts.ir.values import Type

ENDING = (ir.Jump, ir.Return, ir.ReturnError, ir.Stop, ir.Halt)
_MIRRORED = {
    BinaryOperator.LESS: BinaryOperator.GREATER,
    BinaryOperator.LESS_EQUAL: BinaryOperator.GREATER_EQUAL,
    BinaryOperator.GREATER: BinaryOperator.LESS,
    BinaryOperator.GREATER_EQUAL: BinaryOperator.LESS_EQUAL,
    BinaryOperator.EQUAL: BinaryOperator.EQUAL,
    BinaryOperator.NOT_EQUAL: BinaryOperator.NOT_EQUAL,
}
_DENIED = {
    BinaryOperator.LESS: BinaryOperator.GREATER_EQUAL,
    BinaryOperator.LESS_EQUAL: BinaryOperator.GREATER,
    BinaryOperator.GREATER: BinaryOperator.LESS_EQUAL,
    BinaryOperator.GREATER_EQUAL: BinaryOperator.LESS,
    BinaryOperator.EQUAL: BinaryOperator.NOT_EQUAL,
    BinaryOperator.NOT_EQUAL: BinaryOperator.EQUAL,
}
_SAME = (BinaryOperator.EQUAL, BinaryOperator.NOT_EQUAL)  # all that is followed of texts


class Within(NamedTuple):
    """Between which numbers a variable lies."""

    least: float = -math.inf
    most: float = math.inf

    def joined(self, other: "Within") -> "Within":
        """Return the least span that holds both."""
        return Within(min(self.least, other.least), max(self.most, other.most))

    @property
    def has_bounds(self) -> bool:
        """Whether it has a bound on both sides."""
        return math.isfinite(self.least) and math.isfinite(self.most)


class Usage(NamedTuple):
    """What becomes of what is typed into one variable."""

    compared: frozenset[float | str]  # that it is compared with
    within: Within | None  # where more is done with it; None: it is only compared


def usage(module: Module, program: Program, place: Place) -> Usage | None:
    """Return what becomes of what is typed; None: nobody can say, or a number has no bounds.

    Args:
        module: All programs.
        program: The program that asks.
        place: The variable that is read.
    """
    variable = place.variable
    if place.subscripts or _is_formal(program, variable):
        return None
    known: set[float | str] = set()
    within: Within | None = None
    for other in module.programs.values():
        if isinstance(variable, Slot) and other is not program:
            continue
        known.update(_compared(other, variable))
        more = [k for k, each in enumerate(other.instructions) if _does_more(other, each, variable)]
        if not more:
            continue
        if variable.type is not Type.REAL or other is not program:
            return None
        if _may_change_under_way(module, program, variable):
            return None
        after = _ranges(program, variable)
        for k in more:
            if k in after:
                if not after[k].has_bounds:
                    return None
                within = after[k] if within is None else within.joined(after[k])
    return Usage(frozenset(known), within)


def _is_formal(program: Program, variable: Global | Slot) -> bool:
    return isinstance(variable, Slot) and variable.number < len(program.formals)


def _may_change_under_way(module: Module, program: Program, variable: Global | Slot) -> bool:
    """Return whether something else may give a new number to a variable that was looked at."""
    if isinstance(variable, Slot):
        return False
    for other in module.programs.values():
        for each in other.instructions:
            match each:
                case ir.Call(program=name) | ir.React(program=name) | ir.StartProcess(program=name):
                    if name == program.name:
                        return True
                case ir.ReactError(program=name) if name == program.name:
                    return True
                case ir.CallNamed():
                    return True
                case ir.Prompt(places=places) if other is not program:
                    if any(place.variable == variable for place in places):
                        return True
                case _:
                    pass
    return False


def _ranges(program: Program, variable: Global | Slot) -> dict[int, Within]:
    """Return where a variable lies before each instruction that is come to after a PROMPT."""
    found: dict[int, Within] = {}
    left = [
        (k + 1, Within()) for k, each in enumerate(program.instructions) if _asks(each, variable)
    ]
    if isinstance(variable, Global):
        left.append((0, Within()))  # what was typed in the execution before is still there
    while left:
        k, came = left.pop()
        if k >= len(program.instructions):
            continue
        known = found.get(k)
        now = came if known is None else known.joined(came)
        if now == known:
            continue
        found[k] = now
        left += _onward(program, k, variable, now)
    return found


def _asks(instruction: ir.Instruction, variable: Global | Slot) -> bool:
    return isinstance(instruction, ir.Prompt) and any(
        place.variable == variable for place in instruction.places
    )


def _onward(
    program: Program, k: int, variable: Global | Slot, now: Within
) -> Iterator[tuple[int, Within]]:
    """Yield where an instruction leads, and where the variable lies there."""
    each = program.instructions[k]
    if _asks(each, variable):
        return  # what is typed there is followed from there
    match each:
        case ir.JumpIf(condition=condition, when=when, target=target):
            for truth, to in ((when, target), (not when, k + 1)):
                part = _where(condition, truth, variable, now)
                if part is not None:
                    yield to, part
        case ir.TestCase(case=case, values=values, otherwise=otherwise):
            numbers = [_known(value) for value in values]
            if _selects(program, case, variable) and None not in numbers:
                known = [n for n in numbers if isinstance(n, float) and now.least <= n <= now.most]
                if known:
                    yield k + 1, Within(min(known), max(known))
            else:
                yield k + 1, now
            yield otherwise, now
        case _:
            yield from ((to, now) for to in jumps_of(each))
            if not isinstance(each, ENDING):
                yield k + 1, now


def _selects(program: Program, case: int, variable: Global | Slot) -> bool:
    return any(
        isinstance(each, ir.BeginCase) and each.case == case and _loads(each.selector, variable)
        for each in program.instructions
    )


def _where(
    condition: Expression, truth: bool, variable: Global | Slot, now: Within
) -> Within | None:
    """Return where a variable lies if a condition holds, or does not; None: that cannot be."""
    match condition:
        case Unary(operator=UnaryOperator.NOT, operand=operand):
            return _where(operand, not truth, variable, now)
        case Binary(operator=BinaryOperator.AND | BinaryOperator.OR as word, left=a, right=b):
            if (word is BinaryOperator.AND) is truth:  # both parts are as the whole
                first = _where(a, truth, variable, now)
                return None if first is None else _where(b, truth, variable, first)
            ways = [_where(part, truth, variable, now) for part in (a, b)]
            some = [way for way in ways if way is not None]
            return some[0].joined(some[-1]) if some else None
        case Binary(operator=operator, left=a, right=b) if operator in _DENIED:
            for one, other, meant in ((a, b, operator), (b, a, _MIRRORED[operator])):
                border = _known(other)
                if isinstance(border, float) and _loads(one, variable):
                    return _cut(meant if truth else _DENIED[meant], border, now)
            return now
        case _:
            return now


def _cut(operator: BinaryOperator, border: float, now: Within) -> Within | None:
    match operator:
        case BinaryOperator.LESS | BinaryOperator.LESS_EQUAL:
            part = Within(now.least, min(now.most, border))
        case BinaryOperator.GREATER | BinaryOperator.GREATER_EQUAL:
            part = Within(max(now.least, border), now.most)
        case BinaryOperator.EQUAL:
            part = Within(max(now.least, border), min(now.most, border))
        case _:
            part = now
    return part if part.least <= part.most else None


def _compared(program: Program, variable: Global | Slot) -> Iterator[float | str]:
    """Yield what a program compares a variable with."""
    for each in program.instructions:
        for node in (node for top in tops(each) for node in all_nodes(top)):
            beside = _beside(node, variable)
            if beside is not None:
                yield beside
        if isinstance(each, ir.TestCase) and _selects(program, each.case, variable):
            yield from (n for n in map(_known, each.values) if n is not None)


def _does_more(program: Program, instruction: ir.Instruction, variable: Global | Slot) -> bool:
    """Return whether an instruction does more with a variable than to compare, print or set it."""
    nodes = [node for top in tops(instruction) for node in all_nodes(top)]
    reads = sum(isinstance(node, Load) and node.place.variable == variable for node in nodes)
    names = sum(isinstance(node, Place) and node.variable == variable for node in nodes) - reads
    match instruction:
        case ir.Type():
            return False
        case ir.BeginCase(selector=selector, case=case) if _loads(selector, variable):
            return not _by_constants(program, case)
        case ir.Prompt(places=places):
            names -= sum(place.variable == variable for place in places)  # it is given a value
        case (
            ir.Assign(place=place)
            | ir.BeginFor(place=place)
            | ir.TestFor(place=place)
            | ir.NextFor(place=place)
        ):
            names -= place.variable == variable
        case _:
            pass
    reads -= sum(_beside(node, variable) is not None for node in nodes)
    return reads > 0 or names > 0


def _by_constants(program: Program, case: int) -> bool:
    """Return whether a CASE has no other values than constants."""
    return all(
        _known(value) is not None
        for each in program.instructions
        if isinstance(each, ir.TestCase) and each.case == case
        for value in each.values
    )


def _beside(node: object, variable: Global | Slot) -> float | str | None:
    """Return the constant that a node compares a variable with."""
    if isinstance(node, Binary) and node.operator in _DENIED:
        for one, other in ((node.left, node.right), (node.right, node.left)):
            known = _known(other)
            if _loads(one, variable) and (isinstance(known, float) or node.operator in _SAME):
                return known
    return None


def _loads(node: object, variable: Global | Slot) -> bool:
    return isinstance(node, Load) and node.place.variable == variable and not node.place.subscripts


def _known(node: object) -> float | str | None:
    match node:
        case Constant(value=str(text)):
            return text
        case _:
            return number(node)
