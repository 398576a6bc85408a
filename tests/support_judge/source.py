"""A hand-in as its writer has it in mind: programs, steps, loops, places."""

import re
from collections.abc import Callable, Iterator
from typing import NamedTuple

WORD = re.compile(r'"[^"]*"|[A-Za-z_][A-Za-z0-9_]*')


class Step(NamedTuple):
    """A line: a word, what stands behind it, and what is said of it.

    The words `=` and `SET` have two operands, left and right; `CALL` has the name of the program
    first; `;` is a line that is a comment only.
    """

    word: str
    operands: tuple[str, ...] = ()
    note: str = ""


class Loop(NamedTuple):
    """Steps that are repeated while a variable counts from 1 to `last`."""

    kind: str  # FOR or WHILE
    variable: str
    last: str
    body: "Body"


class Free(NamedTuple):
    """Pieces whose order does not matter to the task."""

    pieces: "tuple[Body, ...]"


Node = Step | Loop | Free
Body = tuple[Node, ...]


class Program(NamedTuple):
    """A program of a file."""

    name: str
    parameters: tuple[str, ...]
    body: Body
    note: str = ""


class Place(NamedTuple):
    """A taught location [mm, degrees]."""

    name: str
    values: tuple[float, ...]


class Source(NamedTuple):
    """A whole file."""

    head: tuple[str, ...]  # comments above everything
    programs: tuple[Program, ...]
    places: tuple[Place, ...]


def changed(body: Body, change: Callable[[Node], Body]) -> Body:
    """Return a body in which every node, innermost first, became some nodes."""
    out: list[Node] = []
    for node in body:
        match node:
            case Loop():
                out += change(node._replace(body=changed(node.body, change)))
            case Free():
                out += change(Free(tuple(changed(piece, change) for piece in node.pieces)))
            case Step():
                out += change(node)
    return tuple(out)


def steps(body: Body) -> Iterator[Step]:
    """Yield the steps of a body in the order in which they are written."""
    for node in body:
        match node:
            case Step():
                yield node
            case Loop():
                yield from steps(node.body)
            case Free():
                for piece in node.pieces:
                    yield from steps(piece)


def loops(body: Body) -> Iterator[Loop]:
    """Yield the loops of a body, those inside others first."""
    for node in body:
        match node:
            case Loop():
                yield from loops(node.body)
                yield node
            case Free():
                for piece in node.pieces:
                    yield from loops(piece)
            case Step():
                pass


def mapped(source: Source, change: Callable[[Node], Body]) -> Source:
    """Return a source with the bodies of all programs changed."""
    programs = tuple(one._replace(body=changed(one.body, change)) for one in source.programs)
    return source._replace(programs=programs)


def renamed(source: Source, names: dict[str, str]) -> Source:
    """Return a source in which names became others, texts and comments aside."""

    def other(text: str) -> str:
        return WORD.sub(lambda found: names.get(found[0], found[0]), text)

    def change(node: Node) -> Body:
        match node:
            case Step(word="TYPE"):
                return (node,)
            case Step():
                return (node._replace(operands=tuple(map(other, node.operands))),)
            case Loop():
                return (node._replace(variable=other(node.variable), last=other(node.last)),)
            case Free():
                return (node,)

    out = mapped(source, change)
    return out._replace(
        programs=tuple(
            one._replace(name=other(one.name), parameters=tuple(map(other, one.parameters)))
            for one in out.programs
        ),
        places=tuple(one._replace(name=other(one.name)) for one in out.places),
    )
