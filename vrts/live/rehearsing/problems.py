"""What is wrong with a rehearsed text, as the page marks it."""

from collections.abc import Iterable, Sequence
from typing import Final

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.live.rehearsing.told import Problem
from vrts.report.plain import one_line

MOST: Final = 100
LONGEST: Final = 500  # characters of a message


def problems(
    found: Sequence[Diagnostic], source: SourceFile | None
) -> tuple[tuple[Problem, ...], int]:
    """Return the first rows, errors before warnings, and how many more there are."""
    ordered = sorted(found, key=lambda one: not one.is_error)
    return tuple(_problem(one, source) for one in ordered[:MOST]), max(len(found) - MOST, 0)


def in_one_sentence(found: Iterable[Diagnostic]) -> str:
    """Return the first error."""
    first = next((one for one in found if one.is_error), None)
    if first is None:
        return "there is no program to run in this text"
    where = f"line {first.primary.span.line}: " if first.primary is not None else ""
    return f"{where}{one_line(first.headline)[:LONGEST]}"


def _problem(one: Diagnostic, source: SourceFile | None) -> Problem:
    line = column = end_line = end_column = 1
    if one.primary is not None and source is not None and one.primary.span.source is source:
        span = one.primary.span
        line, column = span.line, span.column
        end_line, end_column = source.line_of(span.end), source.column_of(span.end)
    return Problem(
        line,
        column,
        end_line,
        end_column,
        one.rule.code,
        one.severity.value,
        one_line(one.headline)[:LONGEST],
        "; ".join(map(one_line, one.help))[:LONGEST],
    )
