"""Operands of functions, as the IR has them, and names of the controller's numbers."""

from vrts.base.numbers import round_half_away
from vrts.base.source import Span
from vrts.engine.faults import RuntimeFault
from vrts.ir.expressions import (
    Argument,
    Constant,
    Expression,
    Format,
    Load,
    Place,
    Unary,
    UnaryOperator,
    WholeArray,
)
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.system import PARAMETERS
from vrts.ir.taken import TAKEN_PARAMETERS


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


def number_of(node: object) -> int | None:
    """Return the whole number that is written there, or None for what is not a plain number."""
    match node:
        case Constant(value=float(value)):
            return round_half_away(value)
        case Unary(operator=UnaryOperator.MINUS, operand=Constant(value=float(value))):
            return -round_half_away(value)
        case _:
            return None


def parameter_cell(name: str, index: float | None, span: Span | None) -> str:
    """Return the name of one number: "SPEED.MAX", "NEST.POS[2]".

    Raises:
        RuntimeFault: There is no such parameter, or it has no such number.
    """
    known = PARAMETERS.get(name)
    if name in TAKEN_PARAMETERS:
        return name if index is None else f"{name}[{round_half_away(index)}]"
    if known is None:
        raise RuntimeFault(
            RuntimeErrorKind.INVALID_ARGUMENT, f"there is no parameter `{name}`", span
        )
    which = None if index is None else round_half_away(index)
    if which is None and known.numbers == 1:
        return name
    if which is not None and known.numbers > 1 and 1 <= which <= known.numbers:
        return f"{name}[{which}]"
    if known.numbers == 1:
        problem, remedy = f"`{name}` is one number and has no index", f"write `{name}`"
    else:
        problem = f"`{name}` has {known.numbers} numbers, with an index from 1 to {known.numbers}"
        remedy = f"write `{name}[1]` to `{name}[{known.numbers}]`"
    raise RuntimeFault(RuntimeErrorKind.ILLEGAL_ARRAY_INDEX, problem, span, help=(remedy,))
