"""Variables that are only compared with numbers: all of a value that matters is where it lies.

`late = TIMER(1)` holds another number in every tick. Where programs ask of it no more than whether
it is past 2 and past 5, two values between these numbers go on alike, for ever.
"""

import math
from bisect import bisect_left
from collections import Counter
from collections.abc import Iterator, Mapping
from typing import TypeAlias

from vrts.engine.code.values.arithmetic import rounded
from vrts.engine.machine.forever.nodes import all_nodes, tops
from vrts.ir import instructions as ir
from vrts.ir.expressions import (
    Apply,
    Binary,
    BinaryOperator,
    Constant,
    Function,
    Global,
    Load,
    Place,
    Unary,
    UnaryOperator,
)
from vrts.ir.module import Module
from vrts.ir.values import Type

Numbers: TypeAlias = tuple[float, ...]
COMPARISONS = frozenset(
    {
        BinaryOperator.EQUAL,
        BinaryOperator.NOT_EQUAL,
        BinaryOperator.LESS,
        BinaryOperator.LESS_EQUAL,
        BinaryOperator.GREATER,
        BinaryOperator.GREATER_EQUAL,
    }
)


def region(value: float, numbers: Numbers) -> int:
    """Return where a value lies: between which of some numbers, in ascending order, or on which."""
    k = bisect_left(numbers, value)
    return 2 * k + (k < len(numbers) and numbers[k] == value)


def compared_only(module: Module) -> dict[str, Numbers]:
    """Return the variables that programs assign and compare with numbers, and do nothing else with.

    Beside each stand the numbers, in ascending order.
    """
    met, known = Counter[str](), Counter[str]()
    numbers: dict[str, set[float]] = {}
    for instruction in _instructions(module):
        if isinstance(instruction, ir.Assign):
            known.update(_name(instruction.place))
        for top in tops(instruction):
            for node in all_nodes(top):
                if isinstance(node, Place):
                    met.update(_name(node))
                elif isinstance(node, Binary):
                    for name, number in _compares(node):
                        known[name] += 1
                        numbers.setdefault(name, set()).add(number)
    return {name: tuple(sorted(numbers[name])) for name in numbers if met[name] == known[name]}


def most_compared(module: Module) -> float:
    """Return what is more than all that timers are compared with; inf: more is done with them."""
    held = compared_only(module)
    asked: list[float] = []
    for instruction in _instructions(module):
        numbers = _asked_of_timers(instruction, held)
        if numbers is None:
            return math.inf
        asked += numbers
    return max((abs(number) for number in asked), default=0.0) + 1.0


def ever_new(module: Module) -> Iterator[tuple[str, int]]:
    """Yield program and step of what does more with a timer than to compare it with a number.

    Each of its readings makes another state, so futures that go on with it never meet.
    """
    held = compared_only(module)
    for program in module.programs.values():
        for instruction, origin in zip(program.instructions, program.origins, strict=True):
            if _asked_of_timers(instruction, held) is None:
                yield program.name, origin.step


def _asked_of_timers(
    instruction: ir.Instruction, held: Mapping[str, Numbers]
) -> list[float] | None:
    """Return the numbers that timers of an instruction are compared with, at once or later.

    None: more is done with one of them.
    """
    asked: list[float] = []
    nodes = [node for top in tops(instruction) for node in all_nodes(top)]
    timers = sum(isinstance(it, Apply) and it.function is Function.TIMER for it in nodes)
    for node in nodes:
        if isinstance(node, Binary) and node.operator in COMPARISONS:
            beside = list(_beside_timer(node))
            asked += beside
            timers -= len(beside)
    match instruction:
        case ir.Assign(
            place=Place(variable=Global(name=name), subscripts=()),
            value=Apply(function=Function.TIMER),
        ) if name in held:
            asked += held[name]
            timers -= 1
        case _:
            pass
    return asked if timers == 0 else None


def _instructions(module: Module) -> Iterator[ir.Instruction]:
    for program in module.programs.values():
        yield from program.instructions


def _name(place: Place) -> tuple[str, ...]:
    match place:
        case Place(variable=Global(name=name, type=Type.REAL), subscripts=()):
            return (name,)
        case _:
            return ()


def _compares(node: Binary) -> Iterator[tuple[str, float]]:
    """Yield the variable that is compared, and with which number."""
    if node.operator not in COMPARISONS:
        return
    for one, other in ((node.left, node.right), (node.right, node.left)):
        number = _number(other)
        if isinstance(one, Load) and number is not None:
            yield from ((name, number) for name in _name(one.place))


def _beside_timer(node: Binary) -> Iterator[float]:
    """Yield the number that a timer is compared with."""
    for one, other in ((node.left, node.right), (node.right, node.left)):
        number = _number(other)
        if isinstance(one, Apply) and one.function is Function.TIMER and number is not None:
            yield number


def _number(node: object) -> float | None:
    match node:
        case Constant(value=float(value)):
            return rounded(value, None)
        case Unary(operator=UnaryOperator.MINUS, operand=Constant(value=float(value))):
            return -rounded(value, None)
        case _:
            return None
