"""What is wrong with a rehearsed text, as the page marks it."""

from collections.abc import Iterable, Sequence
from pathlib import PurePath
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


def in_one_sentence(found: Iterable[Diagnostic], source: SourceFile | None) -> str:
    """Return the first error; where it is in none of the text, with the name of what it is in."""
    first = next((one for one in found if one.is_error), None)
    if first is None:
        return "there is no program to run in this text"
    where = "" if first.primary is None else f"line {first.primary.span.line}: "
    if (other := _other(first, source)) is not None:
        where = f"{other}, {where}"
    return f"{where}{one_line(first.headline)[:LONGEST]}"


def _other(one: Diagnostic, source: SourceFile | None) -> str | None:
    """Return the name of another source that something is in; None: it is in none."""
    if one.primary is None or source is None or one.primary.span.source is source:
        return None
    return PurePath(one.primary.span.source.name).name  # never with a folder of the server


def _problem(one: Diagnostic, source: SourceFile | None) -> Problem:
    line = column = end_line = end_column = 1
    if one.primary is not None and source is not None and one.primary.span.source is source:
        span = one.primary.span
        line, column = span.line, span.column
        end_line, end_column = source.line_of(span.end), source.column_of(span.end)
    other = _other(one, source)
    if other is not None:
        line = end_line = 0
    return Problem(
        line,
        column,
        end_line,
        end_column,
        one.rule.code,
        one.severity.value,
        one_line(one.headline)[:LONGEST],
        "; ".join(map(one_line, one.help))[:LONGEST],
        other or "",
    )
