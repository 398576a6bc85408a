"""Expressions known to give reals, as closures without checks of types.

Programs compute mostly with numbers, and the compiler knows which names are numbers. What it does
not know, or what may be a string, is left to `evaluate`.
"""

import struct
from collections.abc import Callable

from vrts.base.source import Span
from vrts.engine.code.closures import Real
from vrts.engine.code.values.arithmetic import FALSE, TRUE, binary, overflow, unary
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.code.values.operands import number_of
from vrts.engine.code.values.static_types import of_reals
from vrts.engine.faults import RuntimeFault
from vrts.engine.programs.context import Context
from vrts.ir.expressions import (
    Apply,
    Binary,
    BinaryOperator,
    Constant,
    Expression,
    Function,
    Unary,
    UnaryOperator,
)
from vrts.ir.ranges import INPUTS, INTERNAL, OUTPUTS
from vrts.ir.runtime_errors import RuntimeErrorKind

_pack = struct.Struct("<f").pack  # standard layout: packing what is too large raises
_unpack = struct.Struct("<f").unpack

SIGNALS = (INPUTS, OUTPUTS, INTERNAL)
ARITHMETIC = {
    BinaryOperator.ADD,
    BinaryOperator.SUBTRACT,
    BinaryOperator.MULTIPLY,
    BinaryOperator.DIVIDE,
}
COMPARISONS = {
    BinaryOperator.EQUAL,
    BinaryOperator.NOT_EQUAL,
    BinaryOperator.LESS,
    BinaryOperator.LESS_EQUAL,
    BinaryOperator.GREATER,
    BinaryOperator.GREATER_EQUAL,
}


def real_unary(compiler: Compiler, expression: Unary) -> Real:
    """Return a closure for an operator with one operand."""
    inner = compiler.real(expression.operand)
    match expression.operator:
        case UnaryOperator.MINUS:
            return lambda c: -inner(c)
        case UnaryOperator.NOT:
            return lambda c: FALSE if inner(c) else TRUE
        case UnaryOperator.COM:
            apply = unary(UnaryOperator.COM, expression.span)
            return lambda c: apply(inner(c))


def real_binary(compiler: Compiler, expression: Binary) -> Real:
    """Return a closure for an operator on two reals."""
    operator, span = expression.operator, expression.span
    if operator in COMPARISONS:
        holds = truth(compiler, expression)
        return lambda c: TRUE if holds(c) else FALSE
    left, right = compiler.real(expression.left), compiler.real(expression.right)
    if operator not in ARITHMETIC:
        apply = binary(operator, span)
        return lambda c: apply(left(c), right(c))
    if isinstance(expression.right, Constant) and operator is not BinaryOperator.DIVIDE:
        return _with_constant(operator, left, right, span)
    return _arithmetic(operator, left, right, span)


def truth(compiler: Compiler, expression: Expression) -> Callable[[Context], bool]:
    """Return a closure that gives whether a condition holds."""
    if (
        isinstance(expression, Binary)
        and expression.operator in COMPARISONS
        and of_reals(expression)
    ):
        left, right = compiler.real(expression.left), compiler.real(expression.right)
        match expression.operator:
            case BinaryOperator.EQUAL:
                return lambda c: left(c) == right(c)
            case BinaryOperator.NOT_EQUAL:
                return lambda c: left(c) != right(c)
            case BinaryOperator.LESS:
                return lambda c: left(c) < right(c)
            case BinaryOperator.LESS_EQUAL:
                return lambda c: left(c) <= right(c)
            case BinaryOperator.GREATER:
                return lambda c: left(c) > right(c)
            case _:
                return lambda c: left(c) >= right(c)
    signal = one_signal(expression)
    if signal is not None:
        number, wanted = abs(signal), signal > 0
        return lambda c: (number in c.signals.on) is wanted
    value = compiler.real(expression)
    return lambda c: value(c) != 0.0


def one_signal(expression: Expression) -> int | None:
    """Return the signal that SIG looks at, where that is all and there is such a signal."""
    match expression:
        case Apply(function=Function.SIG, arguments=(argument,)):
            number = number_of(argument)
            is_one = number is not None and any(abs(number) in known for known in SIGNALS)
            return number if is_one else None
        case _:
            return None


def _with_constant(operator: BinaryOperator, left: Real, right: Real, span: Span | None) -> Real:
    constant: float = right(None)  # type: ignore[arg-type] -- a constant asks nothing
    match operator:
        case BinaryOperator.ADD:

            def add(c: Context) -> float:
                try:
                    return _unpack(_pack(left(c) + constant))[0]
                except OverflowError:
                    raise overflow(span) from None

            return add
        case BinaryOperator.SUBTRACT:

            def subtract(c: Context) -> float:
                try:
                    return _unpack(_pack(left(c) - constant))[0]
                except OverflowError:
                    raise overflow(span) from None

            return subtract
        case _:

            def multiply(c: Context) -> float:
                try:
                    return _unpack(_pack(left(c) * constant))[0]
                except OverflowError:
                    raise overflow(span) from None

            return multiply


def _arithmetic(operator: BinaryOperator, left: Real, right: Real, span: Span | None) -> Real:
    match operator:
        case BinaryOperator.ADD:

            def add(c: Context) -> float:
                try:
                    return _unpack(_pack(left(c) + right(c)))[0]
                except OverflowError:
                    raise overflow(span) from None

            return add
        case BinaryOperator.SUBTRACT:

            def subtract(c: Context) -> float:
                try:
                    return _unpack(_pack(left(c) - right(c)))[0]
                except OverflowError:
                    raise overflow(span) from None

            return subtract
        case BinaryOperator.MULTIPLY:

            def multiply(c: Context) -> float:
                try:
                    return _unpack(_pack(left(c) * right(c)))[0]
                except OverflowError:
                    raise overflow(span) from None

            return multiply
        case _:

            def divide(c: Context) -> float:
                try:
                    return _unpack(_pack(left(c) / right(c)))[0]
                except OverflowError:
                    raise overflow(span) from None
                except ZeroDivisionError:
                    raise RuntimeFault(
                        RuntimeErrorKind.DIVISION_BY_ZERO,
                        "division by zero",
                        span,
                        label="the divisor is 0 here",
                    ) from None

            return divide
