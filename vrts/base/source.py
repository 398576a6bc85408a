"""Program text and places in it.

Offsets count characters of the decoded text; lines and columns count from 1, as editors do.
"""

from bisect import bisect_right
from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple


class SourceFile:
    """The decoded text of one file and the name it is shown under. Compared by identity."""

    def __init__(self, name: str, text: str) -> None:
        """Keep the text; `name` is what diagnostics print, not a path to open."""
        self.name = name
        self.text = text

    @cached_property
    def line_starts(self) -> tuple[int, ...]:
        """Offset of the first character of every line."""
        starts = [0]
        at = self.text.find("\n")
        while at >= 0:
            starts.append(at + 1)
            at = self.text.find("\n", at + 1)
        return tuple(starts)

    def line_of(self, offset: int) -> int:
        """Return the number, from 1, of the line that holds an offset."""
        return bisect_right(self.line_starts, offset)

    def column_of(self, offset: int) -> int:
        """Return the column, from 1, of an offset in its line."""
        return offset - self.line_starts[self.line_of(offset) - 1] + 1

    def line_text(self, line: int) -> str:
        """Return the text of a line, from 1, without its line end."""
        start = self.line_starts[line - 1]
        end = self.text.find("\n", start)
        return self.text[start : len(self.text) if end < 0 else end].rstrip("\r")

    def lines(self) -> Iterator[str]:
        """Return every line without its line end."""
        return (self.line_text(number) for number in range(1, len(self.line_starts) + 1))

    def __repr__(self) -> str:
        """Return a short form that does not print the text."""
        return f"SourceFile({self.name!r}, {len(self.text)} characters)"


class Span(NamedTuple):
    """A half-open range of offsets in a source file."""

    source: SourceFile
    start: int
    end: int

    @property
    def text(self) -> str:
        """The characters of the span."""
        return self.source.text[self.start : self.end]

    @property
    def line(self) -> int:
        """The line, from 1, on which the span starts."""
        return self.source.line_of(self.start)

    @property
    def column(self) -> int:
        """The column, from 1, at which the span starts."""
        return self.source.column_of(self.start)
