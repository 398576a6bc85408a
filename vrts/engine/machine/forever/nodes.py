"""What stands in an instruction: its expressions, all the way down, and its places."""

from collections.abc import Iterator
from typing import cast

from vrts.ir import instructions as ir
from vrts.ir.expressions import (
    Apply,
    Binary,
    Compose,
    Constant,
    Load,
    Place,
    Unary,
    WholeArray,
)

Node = Apply | Binary | Compose | Constant | Load | Place | Unary | WholeArray
NODES = (Apply, Binary, Compose, Constant, Load, Place, Unary, WholeArray)


def tops(instruction: ir.Instruction) -> Iterator[Node]:
    """Yield the expressions and places that an instruction names itself."""
    yield from _within(instruction)


def all_nodes(node: Node) -> Iterator[Node]:
    """Yield a node and everything below it."""
    yield node
    for child in children(node):
        yield from all_nodes(child)


def children(node: Node) -> Iterator[Node]:
    """Yield the nodes right below a node."""
    match node:
        case Apply(arguments=parts) | Compose(parts=parts) | Place(subscripts=parts):
            yield from _within(parts)
        case Binary(left=left, right=right):
            yield from _within((left, right))
        case Unary(operand=operand):
            yield from _within((operand,))
        case Load(place=place):
            yield place
        case Constant() | WholeArray():
            return


def _within(parts: tuple[object, ...]) -> Iterator[Node]:
    """Yield the outermost nodes of a tuple, which may hold tuples."""
    for part in parts:
        if isinstance(part, NODES):
            yield part
        elif isinstance(part, tuple):
            yield from _within(cast("tuple[object, ...]", part))
