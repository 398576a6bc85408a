"""Steps moved to another place: the same text further down has the same tree, at its own offsets.

Most lines of a program stand in it more than once, and moving a tree costs a fraction of parsing.
"""

from collections.abc import Callable
from typing import Any, TypeAlias, TypeVar, cast

from vrts.base.made import made
from vrts.lang.syntax.expressions import (
    Application,
    FormatItem,
    Infix,
    Name,
    Number,
    Text,
)
from vrts.lang.syntax.statements import Simple, Statement, Structure

S = TypeVar("S", bound=Statement)
_Node: TypeAlias = tuple[Any, ...]


def moved(step: S, by: int) -> S:
    """Return a step with every offset in it raised by a number."""
    return _moved(step, by)


def _moved(node: _Node, by: int) -> Any:
    move = _MOVERS.get(type(node))
    return _any(node, by) if move is None else move(node, by)


def _leaf(node: _Node, by: int) -> _Node:
    """Move a node that holds one thing and its range."""
    what, start, end = node
    return made(type(node), (what, start + by, end + by))


def _all(nodes: tuple[Any, ...], by: int) -> tuple[Any, ...]:
    return tuple([None if node is None else _moved(node, by) for node in nodes])


def _simple(node: Simple, by: int) -> Simple:
    word, operands, start, end = node
    return made(Simple, (word, _all(operands, by) if operands else (), start + by, end + by))


def _infix(node: Infix, by: int) -> Infix:
    operator, left, right, start, end, at = node
    left, right = _moved(left, by), _moved(right, by)
    return made(Infix, (operator, left, right, start + by, end + by, at + by))


def _application(node: Application, by: int) -> Application:
    name, arguments, before_by, start, end = node  # the third counts arguments: it stays
    name = _leaf(name, by)
    return made(Application, (name, _all(arguments, by), before_by, start + by, end + by))


def _any(node: _Node, by: int) -> _Node:
    """Move any other node: its numbers are offsets, its tuples hold nodes or words."""
    parts: list[Any] = []
    for part in node:
        kind = cast("type[object]", type(part))
        if kind is int:
            parts.append(part + by)
        elif kind is tuple:
            inner = cast("tuple[Any, ...]", part)
            parts.append(inner if inner and type(inner[0]) is str else _all(inner, by))
        elif isinstance(part, tuple):
            parts.append(_moved(cast("_Node", part), by))
        else:
            parts.append(part)
    return made(type(node), parts)


_MOVERS: dict[type, Callable[[Any, int], Any]] = {
    Name: _leaf,
    Number: _leaf,
    Text: _leaf,
    FormatItem: _leaf,
    Structure: _leaf,
    Simple: _simple,
    Infix: _infix,
    Application: _application,
}
