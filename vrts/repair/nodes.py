"""How large an edit is: how many nodes of the syntax it changes, adds or removes.

One node each: a number with its sign, a name, a text in quotes, an operator, a pair of parentheses,
a function, an array, the keyword of a step, ALWAYS, a unit, each value of a row of data.
"""

from collections.abc import Iterator
from typing import cast

from vrts.lang.syntax.expressions import (
    Application,
    Element,
    Expression,
    FormatItem,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    Prefix,
    Text,
)
from vrts.lang.syntax.program import DataLine
from vrts.lang.syntax.statements import Level, Statement

_PLACES = frozenset({"start", "end", "operator_start", "word"})
_NODES = (Number, Text, Name, FormatItem, Element, Application, Prefix, Infix, Parenthesised)


def nodes_of_step(statement: Statement) -> int:
    """Return how many nodes a step has; its label apart."""
    return 1 + sum(nodes(each) for each in operands(statement)) + _words(statement)


def nodes_of_row(row: DataLine) -> int:
    """Return how many nodes a row of data has: its name, and each of its values."""
    return nodes(row.target) + len(row.values)


def nodes(item: Item) -> int:
    """Return how many nodes an expression has."""
    match item:
        case Prefix("-", Number()):
            return 1
        case Number() | Text() | Name() | FormatItem():
            return 1
        case Element(_, subscripts):
            return 1 + sum(nodes(each) for each in subscripts if each is not None)
        case Application(_, arguments, by):
            given = sum(nodes(each) for each in arguments if each is not None)
            return 1 + given + (by is not None)
        case Prefix(_, operand):
            return 1 + nodes(operand)
        case Infix(_, left, right):
            return 1 + nodes(left) + nodes(right)
        case Parenthesised(inner):
            return 1 + nodes(inner)


def operands(statement: Statement) -> Iterator[Item]:
    """Return the outermost expressions of a step in the order of its text."""
    for name, value in statement._asdict().items():
        if name not in _PLACES:
            yield from _within(cast("object", value))


def parts(item: Item) -> Iterator[Item]:
    """Return an expression and all within it, outermost first; a signed number is one."""
    yield item
    match item:
        case Prefix("-", Number()):
            return
        case Element(_, several) | Application(_, several, _):
            for each in several:
                if each is not None:
                    yield from parts(each)
        case Prefix(_, inner) | Parenthesised(inner):
            yield from parts(inner)
        case Infix(_, left, right):
            yield from parts(left)
            yield from parts(right)
        case _:
            return


def is_expression(item: Item) -> bool:
    """Return whether an item is no format."""
    return not isinstance(item, FormatItem)


def _within(value: object) -> Iterator[Item]:
    if isinstance(value, Level):
        yield value.value
    elif isinstance(value, _NODES):
        yield cast("Expression", value)
    elif isinstance(value, tuple):
        for each in cast("tuple[object, ...]", value):
            yield from _within(each)


def _words(statement: Statement) -> int:
    """Return how many words of a step count beside its keyword: ALWAYS, units, kinds."""
    count = 0
    for name, value in statement._asdict().items():
        if name in _PLACES:
            continue
        if value is True or isinstance(value, str):
            count += 1
        elif isinstance(value, tuple) and not isinstance(value, _NODES):
            several = cast("tuple[object, ...]", value)
            count += sum(isinstance(x, Level) and x.unit is not None for x in several)
            count += sum(isinstance(x, str) for x in several)
    return count
