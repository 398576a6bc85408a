"""Steps, programs and lines of data as they were written."""

from typing import NamedTuple

from vrts.lang.syntax.expressions import Name, Number, Text, Variable
from vrts.lang.syntax.statements import Statement


class DataLine(NamedTuple):
    """A line of a data section."""

    target: Variable
    values: tuple[Number | Text, ...]
    start: int
    end: int


class Label(NamedTuple):
    """A number before a statement, or a name and a colon in AS."""

    number: int | str
    start: int
    end: int


class Step(NamedTuple):
    """A numbered step that holds a label, a statement or both."""

    number: int  # from 1; blank and comment lines count too
    label: Label | None
    statement: Statement | None


class Formal(NamedTuple):
    """A formal argument; `array` when written `a[]`. None stands for one left out."""

    name: Name
    array: bool


class ProgramText(NamedTuple):
    """One program after parsing."""

    name: str  # lower case, at most 15 characters
    formals: tuple[Formal, ...]
    steps: tuple[Step, ...]
    step_count: int  # blank and comment lines included
    start: int  # of the header line
    end: int
    finish: tuple[int, int]  # range of the line that ends the program
    sound: bool = True  # whether nothing was reported of its header
