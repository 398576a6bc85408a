"""What an executed step read: values as they were, looked up in the history."""

import math
from collections.abc import Iterator
from typing import NamedTuple, cast

from vrts.engine.memory.cells import UNDEFINED, Array, Bound, Cell, Content
from vrts.engine.memory.trace import Activation
from vrts.ir.control import NextFor, TestFor
from vrts.ir.expressions import (
    Apply,
    Binary,
    BinaryOperator,
    Compose,
    Constant,
    Function,
    Load,
    Place,
    Slot,
    Unary,
    UnaryOperator,
)
from vrts.ir.values import Value
from vrts.why.slicing.executed import Executed, Steps


class Reading(NamedTuple):
    """A value that a step read."""

    place: Place  # as the step names it
    cell: Cell | None  # None: it does not exist, or cannot be told
    value: Content
    before: int  # statements finished when it was read
    activation: Activation | None  # in which the place is meant

    @property
    def known(self) -> bool:
        """Whether there was a value."""
        return self.cell is not None and self.value is not UNDEFINED


def readings(steps: Steps, step: Executed) -> tuple[Reading, ...]:
    """Return what a step read, in the order of its text, subscripts after what they choose."""
    target = getattr(step.instruction, "place", None)
    fields = cast("tuple[object, ...]", tuple(step.instruction))
    skipped = target if not _counts(step) else None
    found = places_in(tuple(field for field in fields if field is not skipped))
    more = places_in(target.subscripts) if skipped is not None and target is not None else ()
    return tuple(
        reading(steps, place, step.number - 1, step.activation) for place in (*found, *more)
    )


def reading(steps: Steps, place: Place, before: int, activation: Activation | None) -> Reading:
    """Return the value that a place had."""
    cell = cell_of(steps, place, before, activation)
    return Reading(place, cell, UNDEFINED if cell is None else cell.at(before), before, activation)


def cell_of(steps: Steps, place: Place, before: int, activation: Activation | None) -> Cell | None:
    """Return the cell that a place meant after so many statements; None where it had none."""
    bound = bound_of(steps, place, activation)
    if not isinstance(bound, Array):
        return bound
    subscripts: list[int] = []
    for each in place.subscripts:
        value = number(steps, each, before, activation)
        if value is None:
            return None
        subscripts.append(round(value))
    return bound.elements.get(tuple(subscripts)) if subscripts else None


def bound_of(steps: Steps, place: Place, activation: Activation | None) -> Bound | None:
    """Return what the name of a place stood for."""
    variable = place.variable
    if isinstance(variable, Slot):
        slots = activation.slots if activation else []
        return slots[variable.number] if variable.number < len(slots) else None
    return steps.named.get(variable.name)


def element(steps: Steps, place: Place, before: int, activation: Activation | None) -> str:
    """Return the name of the cell that a place meant, whether it has a value or not."""
    bound = bound_of(steps, place, activation)
    name = place.variable.name if bound is None else bound.name
    if not place.subscripts:
        return name
    values = [number(steps, each, before, activation) for each in place.subscripts]
    if any(value is None for value in values):
        return f"{name}[]"
    return f"{name}[{','.join(str(round(v)) for v in values if v is not None)}]"


def number(
    steps: Steps, expression: object, before: int, activation: Activation | None
) -> float | None:
    """Return what a plain sum of numbers came to; None where it takes the controller to tell."""
    found: object = None
    if isinstance(expression, Constant):
        found = expression.value
    elif isinstance(expression, Load):
        cell = cell_of(steps, expression.place, before, activation)
        found = None if cell is None else cell.at(before)
    elif isinstance(expression, Unary) and expression.operator is UnaryOperator.MINUS:
        inner = number(steps, expression.operand, before, activation)
        found = None if inner is None else -inner
    elif isinstance(expression, Binary):
        left = number(steps, expression.left, before, activation)
        right = number(steps, expression.right, before, activation)
        found = None if left is None or right is None else _of_two(expression.operator, left, right)
    elif isinstance(expression, Apply) and expression.function in _PLAIN:
        (argument,) = expression.arguments[:1] or (None,)
        inner = number(steps, argument, before, activation)
        found = None if inner is None else float(_PLAIN[expression.function](inner))
    return found if isinstance(found, float) and math.isfinite(found) else None


def places_in(node: object) -> Iterator[Place]:
    """Yield every place that is named, those of subscripts after what they choose."""
    if isinstance(node, Place):
        yield node
        yield from places_in(node.subscripts)
    elif isinstance(node, tuple):
        for part in cast("tuple[object, ...]", node):
            yield from places_in(part)


def constants_in(node: object) -> Iterator[Value]:
    """Yield the numbers and locations that are written out."""
    if isinstance(node, Constant):
        yield node.value
    elif isinstance(node, tuple) and not isinstance(node, Place):
        for part in cast("tuple[object, ...]", node):
            yield from constants_in(part)


def only_place(expression: object) -> Place | None:
    """Return the place that an expression is nothing but a copy of."""
    if isinstance(expression, Load):
        return expression.place
    if isinstance(expression, Compose) and len(expression.parts) == 1:
        return only_place(expression.parts[0])
    return expression if isinstance(expression, Place) else None


_PLAIN = {Function.INT: math.trunc, Function.ABS: abs}


def _of_two(operator: BinaryOperator, left: float, right: float) -> float | None:
    match operator:
        case BinaryOperator.ADD:
            return left + right
        case BinaryOperator.SUBTRACT:
            return left - right
        case BinaryOperator.MULTIPLY:
            return left * right
        case BinaryOperator.DIVIDE if right != 0:
            return left / right
        case BinaryOperator.MOD if right != 0:
            return math.fmod(left, right)
        case _:
            return None


def _counts(step: Executed) -> bool:
    """Return whether a step reads the variable that it writes: NEXT and the test of a loop."""
    return isinstance(step.instruction, NextFor | TestFor)
