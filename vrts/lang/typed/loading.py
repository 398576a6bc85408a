"""A file as LOAD takes it: the lines of every program, the good and the bad, and the data."""

from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.base.stack import deep_stack
from vrts.ir.module import Datum
from vrts.lang.dialect import Dialect
from vrts.lang.meaning.data_sections import read_data
from vrts.lang.meaning.scope import Scope
from vrts.lang.problems import Problems
from vrts.lang.reading.headers import is_remarks, read_header
from vrts.lang.reading.sections.lines import Section
from vrts.lang.reading.splitter import split
from vrts.lang.steps.step_parser import StepParser


class ProgramLines(NamedTuple):
    """The text of one program, as written."""

    name: str  # lower case, at most 15 characters
    header: str  # `.PROGRAM name(a, b)`
    lines: tuple[str, ...]  # one a step, comments and blank ones included


class Contents(NamedTuple):
    """What a file holds."""

    programs: tuple[ProgramLines, ...]
    data: tuple[Datum, ...]
    diagnostics: tuple[Diagnostic, ...]  # of sections, headers and data; not of steps


@deep_stack()
def contents(source: SourceFile, dialect: Dialect) -> Contents:
    """Return programs and data of a file. Steps are not looked at, so bad ones are kept."""
    problems = Problems(source, dialect)
    sections = [section for section in split(problems) if not is_remarks(section, dialect)]
    parser, scope = StepParser(problems), Scope([])
    programs: list[ProgramLines] = []
    data: list[Datum] = []
    for section in sections:
        if section.kind == "program":
            name, _ = read_header(section, problems)
            if name:
                header = _header(source, section, name)
                programs.append(ProgramLines(name, header, _lines(source, section)))
        else:
            data += read_data(section, parser, scope)
    return Contents(tuple(programs), tuple(data), problems.in_order())


def _header(source: SourceFile, section: Section, name: str) -> str:
    written = source.text[section.header.start : section.header.end].strip()
    formals = written[written.find("(") :].lower() if "(" in written else ""
    return f".PROGRAM {name}{formals[: formals.find(')') + 1]}"


def _lines(source: SourceFile, section: Section) -> tuple[str, ...]:
    first = source.line_of(section.header.start) + bool(section.header.text)
    last = min(first + section.line_count, len(source.line_starts) + 1)
    return tuple(source.line_text(number).rstrip() for number in range(first, last))
