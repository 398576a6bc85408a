"""Operands of functions, as the IR has them."""

from vrts.base.source import Span
from vrts.ir.expressions import Argument, Expression, Format, Load, Place, WholeArray


def span_of(expression: Expression) -> Span | None:
    """Return where an expression stands."""
    return expression.place.span if isinstance(expression, Load) else expression.span


def expression_of(argument: Argument) -> Expression:
    """Return the expression of an operand that must be there."""
    if isinstance(argument, Place):
        return Load(argument)
    if argument is None or isinstance(argument, WholeArray | Format):
        raise ValueError("an operand that must be there is missing")
    return argument
