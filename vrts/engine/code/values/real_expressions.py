"""Expressions known to give reals, as closures without checks of types.

Programs compute mostly with numbers, and the compiler knows which names are numbers. What it does
not know, or what may be a string, is left to `evaluate`.
"""

import struct
from collections.abc import Callable
from typing import TYPE_CHECKING

from vrts.base.source import Span
from vrts.engine.code.values.arithmetic import FALSE, TRUE, binary, overflow, unary
from vrts.engine.faults import RuntimeFault
from vrts.engine.machine.context import Context
from vrts.ir.expressions import (
    Apply,
    Binary,
    BinaryOperator,
    Compose,
    Constant,
    Expression,
    Function,
    Load,
    Unary,
    UnaryOperator,
)
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.values import Type, type_of_value

if TYPE_CHECKING:
    from vrts.engine.code.values.evaluate import Compiler

Real = Callable[[Context], float]

_pack = struct.Struct("<f").pack  # standard layout: packing what is too large raises
_unpack = struct.Struct("<f").unpack

LOCATIONS = frozenset(
    {
        Function.TRANS,
        Function.TRANS_ZYZ,
        Function.NULL,
        Function.INVERSE,
        Function.FRAME,
        Function.SHIFT,
        Function.SCALE,
        Function.RX,
        Function.RY,
        Function.RZ,
        Function.HERE,
        Function.DEST,
        Function.BASE,
        Function.TOOL,
    }
)
NOT_KNOWN = frozenset({Function.OPAQUE, Function.TAS})
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


def static_type(expression: Expression) -> Type | None:
    """Return the type that an expression has whenever it has a value; None when that is open."""
    match expression:
        case Constant(value=value):
            return type_of_value(value)
        case Load(place=place):
            known = place.variable.type
            return None if known is Type.DYNAMIC else known
        case Unary():
            return Type.REAL
        case Binary(operator=BinaryOperator.ADD, left=left, right=right):
            found = {static_type(left), static_type(right)} - {None}
            return found.pop() if len(found) == 1 else None
        case Binary():
            return Type.REAL
        case Compose():
            return Type.POSE
        case Apply(function=function):
            if function in NOT_KNOWN:
                return None
            if function in LOCATIONS:
                return Type.POSE
            if function.value.startswith("#"):
                return Type.JOINTS
            return Type.STRING if function.value.startswith("$") else Type.REAL


def of_reals(expression: Binary) -> bool:
    """Return whether both operands are known to be reals."""
    return static_type(expression.left) is Type.REAL and static_type(expression.right) is Type.REAL


def real_unary(compiler: "Compiler", expression: Unary) -> Real:
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


def real_binary(compiler: "Compiler", expression: Binary) -> Real:
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


def truth(compiler: "Compiler", expression: Expression) -> Callable[[Context], bool]:
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
    value = compiler.real(expression)
    return lambda c: value(c) != 0.0


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
