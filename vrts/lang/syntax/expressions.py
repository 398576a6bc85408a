"""Nodes of expressions.

Every node ends with `start` and `end`, a half-open range of offsets in the source text; spans are
made when needed.
"""

from typing import NamedTuple, TypeAlias


class Number(NamedTuple):
    """A real constant."""

    value: float
    start: int
    end: int


class Text(NamedTuple):
    """A string constant."""

    value: str
    start: int
    end: int


class Name(NamedTuple):
    """A variable, constant or function without arguments, with its `$` or `#`, as written."""

    text: str
    start: int
    end: int


class Element(NamedTuple):
    """`a[i]`; `a[]` has no subscripts and is the whole array."""

    name: Name
    subscripts: "tuple[Item | None, ...]"
    start: int
    end: int


class Application(NamedTuple):
    """`f(a, b)`; `by` is how many arguments stand before BY, if it is written."""

    name: Name
    arguments: "tuple[Item | None, ...]"
    by: int | None
    start: int
    end: int


class Prefix(NamedTuple):
    """An operator before its operand."""

    operator: str  # upper case: "-", "+", "NOT", "COM"
    operand: "Expression"
    start: int
    end: int


class Infix(NamedTuple):
    """An operator between two operands; `:` is one of them."""

    operator: str  # upper case and in its usual spelling: "<=" for "=<"
    left: "Expression"
    right: "Expression"
    start: int
    end: int
    operator_start: int


class Parenthesised(NamedTuple):
    """`(e)`, kept because it passes an argument by value and settles precedence."""

    inner: "Expression"
    start: int
    end: int


class FormatItem(NamedTuple):
    """`/F8.2` in TYPE or $ENCODE."""

    text: str
    start: int
    end: int


Expression: TypeAlias = (
    Number | Text | Name | Element | Application | Prefix | Infix | Parenthesised
)
Item: TypeAlias = Expression | FormatItem
Variable: TypeAlias = Name | Element
