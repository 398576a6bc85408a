"""A program file line by line: which text makes which step or row of data."""

from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.lang.dialect import VAL2, Dialect
from vrts.lang.problems import Problems
from vrts.lang.reading.headers import read_header
from vrts.lang.reading.sections.lines import comment_start
from vrts.lang.reading.splitter import split
from vrts.lang.steps.step_parser import StepParser
from vrts.lang.syntax.program import DataLine, Formal
from vrts.lang.syntax.statements import Bad, Statement

INDENT = " " * 8


class WrittenStep(NamedTuple):
    """A step that says something."""

    line: int  # of the file, from 1
    program: int  # which program of the file, from 0
    labelled: bool
    statement: Statement
    start: int  # offsets of its text, without label and comment
    end: int
    text: str


class WrittenRow(NamedTuple):
    """A row of data with its values."""

    line: int
    section: int  # which section of the file, from 0
    kind: str  # "locations", "reals", "strings"
    node: DataLine
    start: int
    end: int


class WrittenProgram(NamedTuple):
    """The first line of a program."""

    name: str  # lower case
    formals: tuple[Formal, ...]
    line: int
    end_line: int  # of its `.END`


class Written(NamedTuple):
    """A file in the order of its text."""

    source: SourceFile
    programs: tuple[WrittenProgram, ...]
    steps: tuple[WrittenStep, ...]
    rows: tuple[WrittenRow, ...]
    data_lines: tuple[int, ...]  # headers of the sections of locations

    @property
    def text(self) -> str:
        """The text of the file."""
        return self.source.text

    def line_start(self, line: int) -> int:
        """Return the offset of the first character of a line, from 1; the end of the text last."""
        starts = self.source.line_starts
        return starts[line - 1] if line <= len(starts) else len(self.source.text)

    def indent(self, line: int) -> str:
        """Return the blanks before what stands on a line."""
        text = self.source.line_text(line)
        return text[: len(text) - len(text.lstrip())] or INDENT


def without_comments(text: str) -> str:
    """Return a program with every line in its place and no comment: quicker to compile."""
    kept: list[str] = []
    for line in text.split("\n"):
        cut = comment_start(line)
        kept.append(line if cut < 0 else line[:cut].rstrip())
    return "\n".join(kept)


def read(source: SourceFile, dialect: Dialect = VAL2) -> Written:
    """Return the steps and rows of a file; what is none of the language is left out."""
    problems = Problems(source, dialect)
    parser = StepParser(problems)
    programs: list[WrittenProgram] = []
    steps: list[WrittenStep] = []
    rows: list[WrittenRow] = []
    headers: list[int] = []
    for number, section in enumerate(split(problems)):
        if section.kind != "program":
            if section.kind == "locations" and section.header.text:
                headers.append(source.line_of(section.header.start))
            for line in section.lines:
                node = parser.data(line)
                if isinstance(node, DataLine):
                    at = source.line_of(line.start)
                    rows.append(WrittenRow(at, number, section.kind, node, line.start, line.end))
            continue
        name, formals = read_header(section, problems)
        at = source.line_of(section.header.start)
        end_line = source.line_of(section.finish[0])
        programs.append(WrittenProgram(name, formals, at, end_line))
        for line in section.lines:
            step = parser.step(line)
            statement = step.statement
            if statement is None or isinstance(statement, Bad):
                continue
            start, end = statement.start, max(statement.end, statement.start)
            steps.append(
                WrittenStep(
                    source.line_of(line.start),
                    len(programs) - 1,
                    step.label is not None,
                    statement,
                    start,
                    line.end,
                    source.text[start : line.end].rstrip() or source.text[start:end],
                )
            )
    return Written(source, tuple(programs), tuple(steps), tuple(rows), tuple(headers))
