"""Places in a program where a mistake can be made, and the text with the mistake in it."""

from collections.abc import Callable, Iterator
from random import Random
from typing import NamedTuple, TypeAlias, TypeVar, cast

from tests.mutants.reading import Written, WrittenProgram, WrittenStep
from vrts.lang.syntax.expressions import Name, Number, Prefix
from vrts.lang.syntax.program import DataLine
from vrts.lang.syntax.statements import SetLocation, Simple

T = TypeVar("T")
Kind: TypeAlias = Callable[[Written, Random], str | None]

MOTIONS = ("MOVE", "MOVES", "APPRO", "APPROS", "DEPART", "DEPARTS")
BLOCKS = ("For", "If", "While", "Until", "Case", "ValueGroup", "Structure")


class Constant(NamedTuple):
    """A number as it stands in a step, with its sign."""

    value: float
    start: int
    end: int


def put(text: str, *changes: tuple[int, int, str]) -> str:
    """Return a text with some of its ranges written otherwise."""
    for start, end, new in sorted(changes, reverse=True):
        text = text[:start] + new + text[end:]
    return text


def with_lines(lines: list[str]) -> str:
    """Return the text of lines."""
    return "".join(f"{line}\n" for line in lines)


def of(chance: Random, choices: list[T]) -> T | None:
    """Return one of several, or None where there is none."""
    return chance.choice(choices) if choices else None


def steps(written: Written) -> list[tuple[WrittenProgram, WrittenStep]]:
    """Return every step with the program that it stands in."""
    return [(program, step) for program in written.programs for step in program.steps]


def simple(written: Written, *words: str) -> list[tuple[WrittenProgram, Simple]]:
    """Return the instructions with certain keywords, each with its program."""
    return [
        (program, found)
        for program, step in steps(written)
        if isinstance(found := step.step.statement, Simple) and found.word in words
    ]


def locations(written: Written) -> list[DataLine]:
    """Return the rows of .LOCATIONS with six numbers."""
    return [
        row.node
        for row in written.rows
        if row.kind == "locations" and row.node is not None and len(row.node.values) == 6
    ]


def parts(node: object) -> Iterator[tuple[object, ...]]:
    """Yield a node and all below it, parents first."""
    if not isinstance(node, tuple):
        return
    nodes = cast("tuple[object, ...]", node)
    if hasattr(nodes, "_fields"):
        yield nodes
    for child in nodes:
        yield from parts(child)


def parts_of(written: Written, kind: type[T]) -> list[tuple[WrittenProgram, T]]:
    """Return the nodes of one type in all steps, each with its program."""
    return [
        (program, node)
        for program, step in steps(written)
        for node in parts(step.step.statement)
        if isinstance(node, kind)
    ]


def constants(node: object) -> list[Constant]:
    """Return the numbers in a node, each with its sign."""
    found: list[Constant] = []
    for part in parts(node):
        match part:
            case Prefix("-", Number(value), start, end):
                found.append(Constant(-value, start, end))
            case Number(value, start, end) if not any(c.end == end for c in found):
                found.append(Constant(value, start, end))
            case _:
                continue
    return found


def known_places(written: Written, program: WrittenProgram) -> list[str]:
    """Return the names that stand for locations in a program: rows, SET, formal arguments."""
    rows = [row.target.text for row in locations(written) if isinstance(row.target, Name)]
    targets = [
        node.target.text
        for _, node in parts_of(written, SetLocation)
        if isinstance(node.target, Name)
    ]
    formals = [formal.name.text for formal in program.formals]
    return list(dict.fromkeys([*rows, *targets, *formals]))


def keyword(text: str, node: Simple, word: str) -> tuple[int, int, str]:
    """Return the change that writes another keyword."""
    end = node.start
    while end < len(text) and (text[end].isalnum()):
        end += 1
    return node.start, end, word
