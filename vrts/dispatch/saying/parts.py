"""Everything that an instruction or an expression is made of, and what its text says at once."""

from collections.abc import Iterable, Iterator
from typing import cast

from vrts.ir import instructions as ir
from vrts.ir.expressions import Constant, Expression, Unary, UnaryOperator


def parts(part: object) -> Iterator[object]:
    """Return a part of the IR and all that is in it."""
    yield part
    if isinstance(part, tuple):
        for item in cast("tuple[object, ...]", part):
            yield from parts(item)


def constant(e: object) -> float | None:
    """Return a number that the text says; None: it is worked out in the run."""
    match e:
        case Constant(float(value)):
            return value
        case Unary(UnaryOperator.MINUS, Constant(float(value))):
            return -value
        case _:
            return None


def condition_of(found: Iterable[ir.Instruction]) -> Expression:
    """Return what the step of a structure word decides by."""
    return next(i.condition for i in found if isinstance(i, ir.JumpIf))
