"""Syntax as trees of labels, on which an edit is measured: says what each node is."""

from collections.abc import Iterable
from functools import cache
from typing import NamedTuple, TypeAlias, cast

from tests.mutants.reading import WrittenProgram, WrittenRow, WrittenStep
from vrts.lang.names import key
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    FormatItem,
    Infix,
    Name,
    Number,
    Parenthesised,
    Prefix,
    Text,
)
from vrts.lang.syntax.statements import Bad, Level, Statement

BLANK = ""  # the label of an operand left out: it keeps the place and counts nothing
PLACES = frozenset({"start", "end", "operator_start"})


class Tree(NamedTuple):
    """A node and what hangs below it."""

    label: str
    children: "Forest" = ()


Forest: TypeAlias = tuple[Tree, ...]


def weight(tree: Tree) -> int:
    """Return what a node counts by itself."""
    return 0 if tree.label == BLANK else 1


@cache
def nodes(forest: Forest) -> int:
    """Return how many nodes count in a forest."""
    return sum(weight(tree) + nodes(tree.children) for tree in forest)


def step_forest(written: WrittenStep) -> Forest:
    """Return the nodes of a step: its label, if there is one, and its statement."""
    label, statement = written.step.label, written.step.statement
    found: list[Tree] = []
    if label is not None:
        found.append(Tree(f"label {label.number}"))
    if isinstance(statement, Bad):
        found += (Tree(word.lower()) for word in written.text.split())
    elif statement is not None:
        found.append(_statement(statement))
    return tuple(found)


def header_forest(program: WrittenProgram) -> Forest:
    """Return the nodes of the first line of a program: its name and its formal arguments."""
    formals = (
        Tree(key(formal.name.text), (Tree("[]"),) if formal.array else ())
        for formal in program.formals
    )
    return (Tree(f".PROGRAM {program.name}", tuple(formals)),)


def row_forest(row: WrittenRow) -> Forest:
    """Return the nodes of a row of data: its name and each of its values."""
    if row.node is None:
        return tuple(Tree(word.lower()) for word in row.text.split())
    return (_expression(row.node.target), *map(_expression, row.node.values))


def _statement(statement: Statement) -> Tree:
    """Return a statement: the node of its keyword, and below it the nodes of all its fields."""
    fields: dict[str, object] = statement._asdict()
    word = fields.pop("word", type(statement).__name__)
    found = (tree for name, value in fields.items() for tree in _field(name, value))
    return Tree(f"step {word}", tuple(found))


def _field(name: str, value: object) -> Forest:
    """Return the nodes of what a statement holds under a name."""
    if name in PLACES or value is None or value is False:
        return ()
    if value is True:
        return (Tree(f"word {name}"),)
    if isinstance(value, str):
        return (Tree(f"word {value.lower()}"),)
    if isinstance(value, Level):
        inner = _expression(value.value)
        return (inner,) if value.unit is None else (inner, Tree(f"unit {value.unit}"))
    if isinstance(value, tuple) and not hasattr(cast("object", value), "_fields"):
        items = cast("tuple[object, ...]", value)
        return tuple(t for item in items for t in _field("", item) or (Tree(BLANK),))
    return (_expression(cast("object", value)),)


def _expression(node: object) -> Tree:
    """Return an expression: a signed number, a name, an operator or a function is one node each."""
    match node:
        case Number(value):
            return Tree(repr(value + 0.0))  # so that -0 is 0
        case Text(value):
            return Tree(f'"{value}"')
        case Name(text):
            return Tree(key(text))
        case FormatItem(text):
            return Tree(f"format {text.lower()}")
        case Element(name, subscripts):
            return Tree(key(name.text), _items(subscripts))
        case Application(name, arguments, by):
            mark = () if by is None else (Tree("word by"),)
            return Tree(key(name.text), (*_items(arguments), *mark))
        case Prefix("-", Number(value)):
            return _expression(Number(-value, 0, 0))
        case Prefix(operator, operand):
            return Tree(operator, (_expression(operand),))
        case Infix(operator, left, right):
            return Tree(operator, (_expression(left), _expression(right)))
        case Parenthesised(inner):
            return Tree("()", (_expression(inner),))
        case _:
            raise TypeError(f"{type(node).__name__} is no expression")


def _items(items: Iterable[object]) -> Forest:
    return tuple(Tree(BLANK) if item is None else _expression(item) for item in items)
