"""A program file as steps and rows of data, each with its line; nothing is resolved."""

from functools import lru_cache
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.lang.dialect import VAL2
from vrts.lang.problems import Problems
from vrts.lang.reading.headers import read_header
from vrts.lang.reading.splitter import split
from vrts.lang.steps.step_parser import StepParser
from vrts.lang.syntax.program import DataLine, Formal, Step


class WrittenStep(NamedTuple):
    """A step that says something."""

    step: Step
    line: int  # of the file, from 1
    text: str  # without its comment


class WrittenProgram(NamedTuple):
    """A program of the file."""

    name: str  # lower case
    formals: tuple[Formal, ...]
    line: int  # of its header, from 1
    steps: tuple[WrittenStep, ...]


class WrittenRow(NamedTuple):
    """A row of a data section."""

    kind: str  # "locations", "reals", "strings"
    node: DataLine | None  # None: it gives no value
    line: int  # of the file, from 1
    text: str  # without its comment


class Written(NamedTuple):
    """A file in the order of its text."""

    text: str
    programs: tuple[WrittenProgram, ...]
    rows: tuple[WrittenRow, ...]

    @property
    def lines(self) -> list[str]:
        """The lines without their ends."""
        return self.text.splitlines()


@lru_cache(maxsize=256)
def read(text: str) -> Written:
    """Return the steps and rows of a file of VAL-II; what is none of the language is kept too."""
    source = SourceFile("program.v2", text)
    problems = Problems(source, VAL2)
    parser = StepParser(problems)
    programs: list[WrittenProgram] = []
    rows: list[WrittenRow] = []
    for section in split(problems):
        if section.kind == "program":
            name, formals = read_header(section, problems)
            written = tuple(
                WrittenStep(parser.step(line), source.line_of(line.start), line.text)
                for line in section.lines
            )
            at = source.line_of(section.header.start)
            programs.append(WrittenProgram(name, formals, at, written))
            continue
        for line in section.lines:
            found = parser.data(line)
            node = found if isinstance(found, DataLine) else None
            rows.append(WrittenRow(section.kind, node, source.line_of(line.start), line.text))
    return Written(text, tuple(programs), tuple(rows))
