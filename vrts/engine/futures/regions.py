"""Variables that are only compared with numbers: all of a value that matters is where it lies.

`late = TIMER(1)` holds another number in every tick. Where programs ask of it no more than whether
it is past 2 and past 5, two values between these numbers go on alike, for ever.
"""

from bisect import bisect_left
from collections import Counter
from collections.abc import Iterator
from typing import TypeAlias

from vrts.engine.code.values.arithmetic import rounded
from vrts.engine.machine.forever.nodes import all_nodes, tops
from vrts.ir import instructions as ir
from vrts.ir.expressions import (
    Binary,
    BinaryOperator,
    Constant,
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


def compared_only(module: Module, *, shown: bool = False) -> dict[str, Numbers]:
    """Return the variables that programs assign and compare with numbers, and do nothing else with.

    Beside each stand the numbers, in ascending order.

    Args:
        module: The programs.
        shown: Whether those count, too, that are written to the terminal as they are.
    """
    met, known = Counter[str](), Counter[str]()
    numbers: dict[str, set[float]] = {}
    for instruction in _instructions(module):
        if isinstance(instruction, ir.Assign):
            known.update(variable(instruction.place))
        if shown and isinstance(instruction, ir.Type):
            known.update(name for one in instruction.items for name in _written(one))
        for top in tops(instruction):
            for node in all_nodes(top):
                if isinstance(node, Place):
                    met.update(variable(node))
                elif isinstance(node, Binary):
                    for name, border in _compares(node):
                        known[name] += 1
                        numbers.setdefault(name, set()).add(border)
    if shown:
        numbers = {name: numbers.get(name, set()) for name in known}
    return {name: tuple(sorted(numbers[name])) for name in numbers if met[name] == known[name]}


def _instructions(module: Module) -> Iterator[ir.Instruction]:
    for program in module.programs.values():
        yield from program.instructions


def variable(node: object) -> tuple[str, ...]:
    """Return the name of a real variable; nothing for what is none."""
    match node:
        case Place(variable=Global(name=name, type=Type.REAL), subscripts=()):
            return (name,)
        case _:
            return ()


def _written(item: object) -> tuple[str, ...]:
    return variable(item.place) if isinstance(item, Load) else ()


def _compares(node: Binary) -> Iterator[tuple[str, float]]:
    """Yield the variable that is compared, and with which number."""
    if node.operator not in COMPARISONS:
        return
    for one, other in ((node.left, node.right), (node.right, node.left)):
        border = number(other)
        if isinstance(one, Load) and border is not None:
            yield from ((name, border) for name in variable(one.place))


def number(node: object) -> float | None:
    """Return the number that is written there; None: it is none."""
    match node:
        case Constant(value=float(value)):
            return rounded(value, None)
        case Unary(operator=UnaryOperator.MINUS, operand=Constant(value=float(value))):
            return -rounded(value, None)
        case _:
            return None
