"""The steps of programs: as they are typed, and as they are compared."""

import re
from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.lang.dialect import Dialect
from vrts.lang.reading.sections.lines import comment_start
from vrts.lang.writing.layout import program_text

_HEADER = re.compile(r"\.PROGRAM +(?P<name>[\w.]+) *(?P<formals>\(.*?\))?", re.IGNORECASE)


class Steps(NamedTuple):
    """A program, as a controller is given it or lists it."""

    name: str
    formals: str  # `(a, $b)`, or empty
    rows: tuple[str, ...]  # one a step, as typed

    @property
    def text(self) -> str:
        """The program as a file has it."""
        rows = "".join(f"        {row}".rstrip() + "\n" for row in self.rows)
        return f".PROGRAM {self.name}{self.formals}\n{rows}.END\n"


class Difference(NamedTuple):
    """The first step in which two programs differ; None where one has no more."""

    step: int
    wanted: str | None
    found: str | None


def steps_of(text: str) -> Steps:
    """Return the steps of a program of a bundle: `.PROGRAM`, its steps, `.END`."""
    header, *rows = text.rstrip("\n").split("\n")
    name, formals = header_of(header)
    return Steps(name, formals, tuple(typed(row) for row in rows[:-1]))


def header_of(header: str) -> tuple[str, str]:
    """Return name and arguments that a `.PROGRAM` line gives; two empty texts for another line."""
    match = _HEADER.match(header)
    if match is None:
        return "", ""
    return match["name"].lower(), re.sub(r"\s", "", match["formals"] or "").replace("()", "")


def typed(row: str) -> str:
    """Return a step as it is typed: without gutter, one blank behind a label."""
    match = re.match(r"\s*(\d{1,5}|[a-z][\w.]*:)\s+(?=\S)", row)
    if match is None or comment_start(row[: match.end()]) >= 0:
        return row.strip()
    return f"{match[1]} {row[match.end() :].rstrip()}"


def first_difference(wanted: Steps, found: Steps, dialect: Dialect) -> Difference | None:
    """Return where two programs differ first, as far as the language is concerned; None: nowhere.

    Case, indentation and blanks between words do not count; comments and strings count exactly.
    Step 0 is the line with the arguments.
    """
    if wanted.formals.lower() != found.formals.lower():
        return Difference(0, wanted.formals, found.formals)
    ours, theirs = _comparable(wanted, dialect), _comparable(found, dialect)
    for at in range(max(len(ours), len(theirs))):
        one = wanted.rows[at] if at < len(ours) else None
        other = found.rows[at] if at < len(theirs) else None
        if one is None or other is None or ours[at] != theirs[at]:
            return Difference(at + 1, one, other)
    return None


def _comparable(steps: Steps, dialect: Dialect) -> Sequence[tuple[str, str]]:
    found = program_text(SourceFile("program", steps.text), dialect).get(steps.name, steps.text)
    rows = found.rstrip("\n").split("\n")[1:-1]
    return [_parts(row) for row in (rows if len(rows) == len(steps.rows) else steps.rows)]


def _parts(row: str) -> tuple[str, str]:
    """Return instruction and comment of a step."""
    cut = comment_start(row)
    return (typed(row), "") if cut < 0 else (typed(row[:cut]), row[cut:].rstrip())
