"""Variables that decide nothing: they are counted up, or given numbers, and nobody looks at them.

A loop that counts its rounds in such a variable repeats itself all the same. Adding a number to a
single-precision real for ever stops changing it at some time, and never overflows.
"""

from collections import Counter

from vrts.engine.code.executable import Executable
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
    WholeArray,
)
from vrts.ir.values import Type

MOST_ADDED = 1e30  # added for ever, it does not come near the largest real
COUNTING = (BinaryOperator.ADD, BinaryOperator.SUBTRACT)


def idle(executable: Executable, *, shown: bool = False) -> frozenset[int]:
    """Return the numbers of the global variables that decide nothing.

    Args:
        executable: The programs.
        shown: Whether those count, too, that are only written to the terminal as they are, or asked
            for whether they hold anything. What is worked out with them may go wrong.
    """
    seen: Counter[str] = Counter()
    counted: Counter[str] = Counter()
    for program in executable.module.programs.values():
        for instruction in program.instructions:
            written = shown and isinstance(instruction, ir.Type)
            for top in tops(instruction):
                if written and _is_plain(top):
                    continue
                for node in all_nodes(top):
                    if isinstance(node, Place | WholeArray):
                        seen[node.variable.name] += isinstance(node.variable, Global)
                    elif shown and isinstance(node, Apply) and node.function is Function.DEFINED:
                        for place in node.arguments:
                            if isinstance(place, Place):
                                seen[place.variable.name] -= isinstance(place.variable, Global)
            name = _counted(instruction)
            if name is not None:
                assert isinstance(instruction, ir.Assign)
                counted[name] += 1 + isinstance(instruction.value, Binary)
    numbers = executable.layout.numbers
    return frozenset(
        numbers[name] for name, count in counted.items() if count == seen[name] and name in numbers
    )


def _is_plain(node: object) -> bool:
    """Return whether an expression is a variable, and nothing else."""
    match node:
        case Load(place=Place(variable=Global(), subscripts=())):
            return True
        case _:
            return False


def _counted(instruction: ir.Instruction) -> str | None:
    """Return the variable of `n = n+1`, `n = n-1` or `n = 1`."""
    match instruction:
        case ir.Assign(
            place=Place(variable=Global(name=name, type=Type.REAL), subscripts=()), value=value
        ):
            match value:
                case Constant(value=float()):
                    return name
                case Binary(
                    operator=operator,
                    left=Load(place=Place(variable=Global(name=other), subscripts=())),
                    right=Constant(value=float(added)),
                ) if operator in COUNTING and other == name and abs(added) <= MOST_ADDED:
                    return name
                case _:
                    return None
        case _:
            return None
