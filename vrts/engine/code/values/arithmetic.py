"""Operators on the language's values: single precision, logical values -1 and 0."""

import math
from collections.abc import Callable
from typing import TypeAlias

from vrts.base.numbers import LARGEST_EXACT_INTEGER, round_half_away, single
from vrts.base.source import Span
from vrts.engine.faults import RuntimeFault
from vrts.ir.expressions import BinaryOperator, UnaryOperator
from vrts.ir.runtime_errors import RuntimeErrorKind

TRUE = -1.0
FALSE = 0.0

LONGEST_STRING = 128

RealOperator: TypeAlias = Callable[[float, float], float]

COMPARISONS: dict[BinaryOperator, Callable[[object, object], bool]] = {
    BinaryOperator.EQUAL: lambda a, b: a == b,
    BinaryOperator.NOT_EQUAL: lambda a, b: a != b,
    BinaryOperator.LESS: lambda a, b: a < b,  # type: ignore[operator]
    BinaryOperator.LESS_EQUAL: lambda a, b: a <= b,  # type: ignore[operator]
    BinaryOperator.GREATER: lambda a, b: a > b,  # type: ignore[operator]
    BinaryOperator.GREATER_EQUAL: lambda a, b: a >= b,  # type: ignore[operator]
}


def rounded(value: float, span: Span | None) -> float:
    """Return a result in single precision.

    Raises:
        RuntimeFault: The result is beyond it.
    """
    try:
        return single(value)
    except OverflowError:
        raise overflow(span) from None


def overflow(span: Span | None) -> RuntimeFault:
    """Return the fault of a result beyond single precision."""
    return RuntimeFault(
        RuntimeErrorKind.ARITHMETIC_OVERFLOW,
        "result is beyond the largest real number",
        span,
        label="larger than 3.4E38",
    )


def logical(truth: bool) -> float:
    """Return VAL's number for a truth value."""
    return TRUE if truth else FALSE


def integer(value: float, span: Span | None, lowest: int, highest: int, what: str) -> int:
    """Return a real as the integer it rounds to.

    Raises:
        RuntimeFault: It is outside a range.
    """
    number = round_half_away(value)
    if not lowest <= number <= highest:
        raise RuntimeFault(
            RuntimeErrorKind.ILLEGAL_VALUE,
            f"{what} {number} is outside {lowest} to {highest}",
            span,
        )
    return number


def bits(value: float, span: Span | None) -> int:
    """Return the operand of a bit operator as a 24-bit two's complement integer [assumed]."""
    return integer(value, span, -LARGEST_EXACT_INTEGER - 1, LARGEST_EXACT_INTEGER, "operand")


def unary(operator: UnaryOperator, span: Span | None) -> Callable[[float], float]:
    """Return an operator with one operand."""
    match operator:
        case UnaryOperator.MINUS:
            return lambda a: -a
        case UnaryOperator.NOT:
            return lambda a: FALSE if a else TRUE
        case UnaryOperator.COM:
            return lambda a: float(~bits(a, span))


def _power(base: float, exponent: float, span: Span | None) -> float:
    """Return a power; that of a negative number only to a whole exponent."""
    if base < 0.0 and exponent != int(exponent):
        raise RuntimeFault(
            RuntimeErrorKind.ILLEGAL_VALUE, "a power of a negative number is not real", span
        )
    try:
        return rounded(base**exponent if base or exponent >= 0.0 else _divisor(0.0, span), span)
    except OverflowError:
        return rounded(math.inf, span)


def binary(operator: BinaryOperator, span: Span | None) -> RealOperator:
    """Return an operator on two reals."""
    match operator:
        case BinaryOperator.ADD:
            return lambda a, b: rounded(a + b, span)
        case BinaryOperator.SUBTRACT:
            return lambda a, b: rounded(a - b, span)
        case BinaryOperator.MULTIPLY:
            return lambda a, b: rounded(a * b, span)
        case BinaryOperator.DIVIDE:
            return lambda a, b: rounded(a / _divisor(b, span), span)
        case BinaryOperator.MOD:
            return lambda a, b: rounded(math.fmod(a, _divisor(b, span)), span)
        case BinaryOperator.POWER:
            return lambda a, b: _power(a, b, span)
        case BinaryOperator.AND:
            return lambda a, b: logical(bool(a) and bool(b))
        case BinaryOperator.OR:
            return lambda a, b: logical(bool(a) or bool(b))
        case BinaryOperator.XOR:
            return lambda a, b: logical(bool(a) != bool(b))
        case BinaryOperator.BAND:
            return lambda a, b: float(bits(a, span) & bits(b, span))
        case BinaryOperator.BOR:
            return lambda a, b: float(bits(a, span) | bits(b, span))
        case BinaryOperator.BXOR:
            return lambda a, b: float(bits(a, span) ^ bits(b, span))
        case _:
            compare = COMPARISONS[operator]
            return lambda a, b: logical(compare(a, b))


def joined(a: str, b: str, span: Span | None) -> str:
    """Return two strings as one.

    Raises:
        RuntimeFault: The result is too long.
    """
    return checked_string(a + b, span)


def checked_string(text: str, span: Span | None) -> str:
    """Return a string that a variable can hold.

    Raises:
        RuntimeFault: It is too long.
    """
    if len(text) > LONGEST_STRING:
        raise RuntimeFault(
            RuntimeErrorKind.STRING_OVERFLOW,
            f"string has {len(text)} characters; the longest has {LONGEST_STRING}",
            span,
        )
    return text


def _divisor(value: float, span: Span | None) -> float:
    if value == 0.0:
        raise RuntimeFault(
            RuntimeErrorKind.DIVISION_BY_ZERO,
            "division by zero",
            span,
            label="the divisor is 0 here",
        )
    return value
