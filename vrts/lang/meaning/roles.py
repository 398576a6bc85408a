"""What an expression stands for in its step: a distance, one side of a comparison ..."""

from bisect import bisect_right
from collections.abc import Iterable
from typing import Any, NamedTuple, cast

from vrts.lang.syntax.expressions import Element, Expression, Infix, Parenthesised
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Statement

COMPARISONS = frozenset({"==", "<>", "<", "<=", ">", ">="})


class Role(NamedTuple):
    """An expression in its step, or in the operator or function around it."""

    program: str
    step: Statement
    around: Any  # the innermost expression that it is an operand of, or the step itself
    node: Expression  # of a name: with its index, where it has one
    place: int  # among the operands or arguments of `around`

    @property
    def other(self) -> Expression | None:
        """The other operand of an operator between two."""
        if not isinstance(self.around, Infix):
            return None
        return self.around.left if self.place else self.around.right


def role_of(programs: Iterable[ProgramText], place: tuple[int, int]) -> Role | None:
    """Return what stands at a range of offsets, and in what; None where it is in no step."""
    start = place[0]
    for program in programs:
        if not program.start <= start < program.finish[1]:
            continue
        steps = [step.statement for step in program.steps if step.statement is not None]
        at = bisect_right(steps, start, key=lambda step: step.start) - 1
        return _inside(program.name, steps[at], place) if at >= 0 else None
    return None


def _inside(program: str, step: Statement, wanted: tuple[int, int]) -> Role | None:
    around: Any = step
    inner = _part(step, wanted[0])
    while inner is not None:
        node, place = inner
        name = node.name if isinstance(node, Element) else node
        if wanted in ((node.start, node.end), (name.start, name.end)):
            return Role(program, step, around, node, place)
        if not isinstance(node, Parenthesised):
            around = node
        inner = _part(node, wanted[0])
    return None


def _part(node: Any, start: int) -> tuple[Any, int] | None:
    """Return the part of a node that holds an offset, and its place among its like."""
    for field in node:
        many = cast("tuple[Any, ...]", field) if type(field) is tuple else (field,)
        for place, part in enumerate(many):
            if hasattr(part, "start") and part.start <= start < part.end:
                right = isinstance(node, Infix) and part is node.right
                return part, place + right
    return None
