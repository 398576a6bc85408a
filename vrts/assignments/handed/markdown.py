"""What a page of Markdown shows or leaves out, and does not say: blocks of code, and comments.

As far as CommonMark tells them by lines; blocks of code in quotations are not looked for.
"""

import re
from bisect import bisect_right
from collections.abc import Sequence
from typing import NamedTuple

_LINE = re.compile(r"[^\n]*\n|[^\n]+")
_OPENS = re.compile(r"[ \t]*(`{3,}(?=[^`\n]*\n?$)|~{3,})")
_CLOSES = re.compile(r"[ \t]*(`{3,}|~{3,})[ \t]*\r?\n?")
_ITEM = re.compile(r"[ \t]*(?:[-*+]|\d{1,9}[.)])[ \t]")
INDENT = 4  # columns from which on a line is code
TAB = 4


class Area(NamedTuple):
    """A half-open range of a text."""

    start: int
    end: int


class Blocks(NamedTuple):
    """What is not said, in the order of the text."""

    code: tuple[Area, ...]
    comments: tuple[Area, ...]
    open: Area | None  # the first line of a block of code that does not end


def within(areas: Sequence[Area], at: int) -> bool:
    """Return whether a place of a text is in one of the areas, which are in order."""
    index = bisect_right(areas, at, key=lambda area: area.start) - 1
    return index >= 0 and at < areas[index].end


def blocks(text: str) -> Blocks:
    """Return where blocks of code and comments are, in one pass."""
    reader = _Reader(text)
    for found in _LINE.finditer(text):
        reader.read(found[0], found.start(), found.end())
    return reader.found()


class _Reader:
    """Reads a page line by line."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.code: list[Area] = []
        self.comments: list[Area] = []
        self.fence: tuple[str, Area] | None = None  # that is open: its signs, and its line
        self.apart = True  # whether the line before is empty or code
        self.item = False  # whether we are inside a list
        self.commented = 0  # where the last comment ends
        self.ends = True  # whether a comment that begins here ends somewhere

    def read(self, line: str, start: int, end: int) -> None:
        """Take the next line."""
        if self.commented > start:
            self._comments(start, end)
            return
        code = _indent(line) >= INDENT and not self.item
        if self.fence is not None:
            signs, first = self.fence
            closing = None if code else _CLOSES.fullmatch(line)
            if closing is not None and closing[1].startswith(signs):
                self.code.append(Area(first.start, end))
                self.fence = None
            return
        if not line.strip():
            self.apart = True
            return
        opening = None if code else _OPENS.match(line)
        if opening is not None:
            self.fence = (opening[1], Area(start, end))
            self.apart = True
        elif code and self.apart:
            self.code.append(Area(start, end))
        else:
            inside = self.item and (not self.apart or line[0] in " \t")
            self.item = inside or _ITEM.match(line) is not None
            self.apart = False
            self._comments(start, end)

    def found(self) -> Blocks:
        """Return everything, at the end of the text."""
        first = None
        if self.fence is not None:
            first = self.fence[1]
            self.code.append(Area(first.start, len(self.text)))
        return Blocks(tuple(self.code), tuple(self.comments), first)

    def _comments(self, start: int, end: int) -> None:
        """Find the comments that begin in a line."""
        at = ticked = max(start, self.commented)
        ticks = 0
        while self.ends and (at := self.text.find("<!--", at, end)) >= 0:
            ticks += self.text.count("`", ticked, at)
            ticked = at
            if ticks % 2:  # code within the line
                at += 1
                continue
            closing = self.text.find("-->", at + 4)
            self.ends = closing >= 0
            if self.ends:
                self.commented = closing + 3
            elif not self.text[start:at].strip():
                self.commented = len(self.text)
            else:
                return
            self.comments.append(Area(at, self.commented))
            at = ticked = self.commented


def _indent(line: str) -> int:
    """Return the columns before the first sign of a line."""
    shown = line.expandtabs(TAB)
    return len(shown) - len(shown.lstrip(" "))
