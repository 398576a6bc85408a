"""Expressions without names and spelling: what is the same by arithmetic is the same."""

from collections.abc import Mapping
from typing import NamedTuple, cast

from vrts.ir.expressions import (
    Apply,
    Argument,
    Binary,
    BinaryOperator,
    Compose,
    Constant,
    Format,
    Load,
    Place,
    Slot,
    Unary,
    UnaryOperator,
    Variable,
    WholeArray,
)
from vrts.ir.values import Type

EXPRESSIONS = (Constant, Load, Unary, Binary, Apply, Compose)
DEEPEST = 24  # expressions in expressions that are told apart
LARGEST = 1e30  # of a number that is worked out
LONGEST = 80  # characters of an argument of a call
NUMBER = "#"  # in place of a number, where numbers do not count

_EITHER_WAY = frozenset(
    {
        *(BinaryOperator.ADD, BinaryOperator.MULTIPLY, BinaryOperator.EQUAL),
        *(BinaryOperator.NOT_EQUAL, BinaryOperator.AND, BinaryOperator.OR, BinaryOperator.XOR),
    }
)
_TURNED = {
    BinaryOperator.GREATER: BinaryOperator.LESS,
    BinaryOperator.GREATER_EQUAL: BinaryOperator.LESS_EQUAL,
}
_OPPOSITE = {
    BinaryOperator.LESS: BinaryOperator.GREATER_EQUAL,
    BinaryOperator.LESS_EQUAL: BinaryOperator.GREATER,
    BinaryOperator.GREATER: BinaryOperator.LESS_EQUAL,
    BinaryOperator.GREATER_EQUAL: BinaryOperator.LESS,
    BinaryOperator.EQUAL: BinaryOperator.NOT_EQUAL,
    BinaryOperator.NOT_EQUAL: BinaryOperator.EQUAL,
}
_LETTERS = {
    Type.REAL: "r",
    Type.STRING: "s",
    Type.POSE: "p",
    Type.JOINTS: "j",
    Type.DYNAMIC: "d",
}


class Given(NamedTuple):
    """An argument of a call, as the caller has it."""

    shape: str  # without numbers
    exact: str
    value: float | None  # None: it is not known


class Known(NamedTuple):
    """What stands for variables: constants that never change, and arguments of calls."""

    constants: Mapping[str, float]  # by name
    arguments: tuple[Given | None, ...] = ()  # of the call, by number of the formal


def given_of(argument: Argument, known: Known) -> Given | None:
    """Return an argument as its caller has it; a long one is cut, so that calls do not pile up."""
    if argument is None:
        return None
    shape = spelled(argument, known, numbers=False)[:LONGEST]
    exact = spelled(argument, known, numbers=True)[:LONGEST]
    return Given(shape, exact, constant_of(argument, known))


def spelled(found: Argument, known: Known, *, numbers: bool, depth: int = 0) -> str:
    """Return an expression as text.

    Args:
        found: The expression.
        known: What stands for its variables.
        numbers: Whether numbers are told; otherwise each is the same.
        depth: How deep it stands in another.
    """
    if depth > DEEPEST:
        return "..."

    def inner(one: Argument) -> str:
        return spelled(one, known, numbers=numbers, depth=depth + 1)

    match found:
        case None:
            return "-"
        case Constant(value):
            return _constant(value, numbers=numbers)
        case Load(place) | (Place() as place):
            return _variable(place, known, numbers=numbers, depth=depth)
        case Unary(UnaryOperator.NOT, Binary(operator, left, right)) if operator in _OPPOSITE:
            return inner(Binary(_OPPOSITE[operator], left, right))
        case Unary(operator, operand):
            value = constant_of(found, known)
            if value is not None:
                return _constant(value, numbers=numbers)
            return f"{operator.value}({inner(operand)})"
        case Binary(operator, left, right):
            value = constant_of(found, known)
            if value is not None:
                return _constant(value, numbers=numbers)
            parts = [inner(left), inner(right)]
            if operator in _TURNED:
                operator = _TURNED[operator]
                parts.reverse()
            if operator in _EITHER_WAY:
                parts.sort()
            return f"({parts[0]}{operator.value}{parts[1]})"
        case Apply(function, arguments):
            return f"{function.value}({','.join(inner(one) for one in arguments)})"
        case Compose(parts):
            return ":".join(inner(one) for one in parts)
        case WholeArray(variable):
            return f"{_letter(variable)}[]"
        case Format():
            return f"/{found.kind.value}"


def constant_of(found: Argument, known: Known, depth: int = 0) -> float | None:
    """Return the number that an expression surely is; None: it may be others."""
    if depth > DEEPEST:
        return None
    match found:
        case Constant(float(value)):
            return value
        case Unary(UnaryOperator.MINUS, operand):
            value = constant_of(operand, known, depth + 1)
            return None if value is None else -value
        case Binary(operator, left, right):
            one = constant_of(left, known, depth + 1)
            other = constant_of(right, known, depth + 1)
            if one is None or other is None:
                return None
            return _computed(operator, one, other)
        case Load(place) | (Place() as place) if not place.subscripts:
            variable = place.variable
            if isinstance(variable, Slot):
                given = _given(variable, known)
                return None if given is None else given.value
            return known.constants.get(variable.name)
        case _:
            return None


def _computed(operator: BinaryOperator, one: float, other: float) -> float | None:
    """Return what an operator makes of two numbers; None: it is not worked out here."""
    found = _result(operator, one, other)
    return found if found is not None and abs(found) < LARGEST else None


def _result(operator: BinaryOperator, one: float, other: float) -> float | None:
    match operator:
        case BinaryOperator.ADD:
            return one + other
        case BinaryOperator.SUBTRACT:
            return one - other
        case BinaryOperator.MULTIPLY:
            return one * other
        case BinaryOperator.DIVIDE:
            return one / other if other else None
        case BinaryOperator.EQUAL:
            return float(one == other)
        case BinaryOperator.NOT_EQUAL:
            return float(one != other)
        case BinaryOperator.LESS:
            return float(one < other)
        case BinaryOperator.LESS_EQUAL:
            return float(one <= other)
        case BinaryOperator.GREATER:
            return float(one > other)
        case BinaryOperator.GREATER_EQUAL:
            return float(one >= other)
        case _:
            return None


def variables_in(found: object) -> frozenset[str]:
    """Return the names of variables whose values an expression reads."""
    names: set[str] = set()
    left: list[object] = [found]
    while left:
        one = left.pop()
        if isinstance(one, Place):
            if not isinstance(one.variable, Slot):
                names.add(one.variable.name)
            left.extend(one.subscripts)
        elif isinstance(one, WholeArray):
            if not isinstance(one.variable, Slot):
                names.add(one.variable.name)
        elif isinstance(one, tuple):  # an expression, or several
            left.extend(cast("tuple[object, ...]", one))
    return frozenset(names)


def _given(slot: Slot, known: Known) -> Given | None:
    return known.arguments[slot.number] if slot.number < len(known.arguments) else None


def _constant(value: object, *, numbers: bool) -> str:
    if isinstance(value, float):
        return f"{value:.6g}" if numbers else NUMBER
    if isinstance(value, str):
        return "text"
    return "pose"


def _letter(variable: Variable) -> str:
    return _LETTERS[variable.type]


def _variable(place: Place, known: Known, *, numbers: bool, depth: int) -> str:
    variable = place.variable
    if isinstance(variable, Slot) and not place.subscripts:
        given = _given(variable, known)
        if given is not None:
            return given.exact if numbers else given.shape
    if not place.subscripts and not isinstance(variable, Slot):
        value = known.constants.get(variable.name)
        if value is not None:
            return _constant(value, numbers=numbers)
    inside = ",".join(
        spelled(one, known, numbers=numbers, depth=depth + 1) for one in place.subscripts
    )
    return f"{_letter(variable)}[{inside}]" if inside else _letter(variable)
