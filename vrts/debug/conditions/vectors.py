"""Expressions of the IR at many instants at once: operators and reals, in single precision.

Each closure gives a column, one real for each instant of a block, to the last digit what the
engine's own closure gives alone. Where that would fail, the instant is marked: whoever asks takes
the engine's own way there. What is not known here is `NotAtOnce`, and asked alone everywhere.
"""

from collections.abc import Callable, Mapping
from typing import TypeAlias

import numpy as np

from vrts.base.pose import Pose
from vrts.debug.conditions.block import Block, reals_of
from vrts.debug.conditions.columns import Reals
from vrts.engine.code.values.arithmetic import FALSE, TRUE, binary, rounded, unary
from vrts.engine.code.values.static_types import static_type
from vrts.engine.faults import RuntimeFault
from vrts.ir.expressions import (
    Binary,
    BinaryOperator,
    Constant,
    Expression,
    Load,
    Place,
    Unary,
    UnaryOperator,
)
from vrts.ir.values import Type

Columns: TypeAlias = Callable[[Block], Reals]
Poses: TypeAlias = Callable[[Block], Pose]

_COMPARISONS: Mapping[BinaryOperator, Callable[[Reals, Reals], object]] = {
    BinaryOperator.EQUAL: np.equal,
    BinaryOperator.NOT_EQUAL: np.not_equal,
    BinaryOperator.LESS: np.less,
    BinaryOperator.LESS_EQUAL: np.less_equal,
    BinaryOperator.GREATER: np.greater,
    BinaryOperator.GREATER_EQUAL: np.greater_equal,
}
_SUMS: Mapping[BinaryOperator, Callable[[Reals, Reals], Reals]] = {
    BinaryOperator.ADD: np.add,
    BinaryOperator.SUBTRACT: np.subtract,
    BinaryOperator.MULTIPLY: np.multiply,
}
_QUOTIENTS: Mapping[BinaryOperator, Callable[[Reals, Reals], Reals]] = {
    BinaryOperator.DIVIDE: np.divide,
    BinaryOperator.MOD: np.fmod,
}


class NotAtOnce(Exception):  # noqa: N818 -- names the situation
    """An expression that has to be asked at each instant alone."""


def single(block: Block, values: Reals) -> Reals:
    """Return results in single precision; those beyond it are marked."""
    found = np.asarray(values).astype(np.float32).astype(np.float64)
    block.mark(~np.isfinite(found))
    return found


def logical(truth: object) -> Reals:
    """Return VAL's numbers for truth values."""
    return np.where(truth, TRUE, FALSE)  # type: ignore[arg-type]


def real(expression: Expression, names: Mapping[str, int], function: "Compile") -> Columns:
    """Return a closure for an expression that is known to give reals.

    Args:
        expression: The expression.
        names: Which of the sources of a block each name is.
        function: What compiles functions.

    Raises:
        NotAtOnce: It has to be asked alone.
    """
    if static_type(expression) is not Type.REAL:
        raise NotAtOnce
    match expression:
        case Constant(value=float(value), span=span):
            try:
                constant = np.float64(rounded(value, span))
            except RuntimeFault:
                raise NotAtOnce from None
            return lambda b: constant  # type: ignore[return-value] -- it stands for a column
        case Load(place=place):
            return _load(place, names, function)
        case Unary(operator=operator, operand=operand):
            return _unary(operator, real(operand, names, function))
        case Binary(operator=operator, left=left, right=right):
            return _binary(operator, real(left, names, function), real(right, names, function))
        case _:
            return function(expression, names)


Compile: TypeAlias = Callable[[Expression, Mapping[str, int]], Columns]


def _load(place: Place, names: Mapping[str, int], function: Compile) -> Columns:
    k = names.get(place.variable.name)
    if k is None:
        raise NotAtOnce
    if not place.subscripts:
        return lambda b: b.reals(k)
    subscripts = tuple(real(subscript, names, function) for subscript in place.subscripts)
    return lambda b: b.elements(k, [s(b) for s in subscripts])


def _unary(operator: UnaryOperator, inner: Columns) -> Columns:
    match operator:
        case UnaryOperator.MINUS:
            return lambda b: -inner(b)
        case UnaryOperator.NOT:
            return lambda b: logical(inner(b) == 0.0)
        case UnaryOperator.COM:
            complement = unary(UnaryOperator.COM, None)
            return lambda b: each(b, complement, inner(b))


def _binary(operator: BinaryOperator, left: Columns, right: Columns) -> Columns:
    compare, sum_ = _COMPARISONS.get(operator), _SUMS.get(operator)
    if compare is not None:
        return lambda b: logical(compare(left(b), right(b)))
    if sum_ is not None:
        return lambda b: single(b, sum_(left(b), right(b)))
    quotient = _QUOTIENTS.get(operator)
    if quotient is not None:

        def divided(b: Block) -> Reals:
            dividend, divisor = left(b), right(b)
            b.mark(divisor == 0.0)
            return single(b, quotient(dividend, divisor))

        return divided
    match operator:
        case BinaryOperator.AND:
            return lambda b: logical((left(b) != 0.0) & (right(b) != 0.0))
        case BinaryOperator.OR:
            return lambda b: logical((left(b) != 0.0) | (right(b) != 0.0))
        case BinaryOperator.XOR:
            return lambda b: logical((left(b) != 0.0) != (right(b) != 0.0))
        case _:
            apply = binary(operator, None)
            return lambda b: each(b, apply, left(b), right(b))


def each(block: Block, apply: Callable[..., float], *operands: Reals) -> Reals:
    """Return what a function gives at each instant that is still sure; marked where it fails."""
    rows = zip(*(reals_of(operand, block.count).tolist() for operand in operands), strict=True)
    found = np.zeros(block.count)
    for k, (row, unsure) in enumerate(zip(rows, block.unsure.tolist(), strict=True)):
        if unsure:
            continue
        try:
            found[k] = apply(*row)
        except RuntimeFault:
            block.unsure[k] = True
    return found
