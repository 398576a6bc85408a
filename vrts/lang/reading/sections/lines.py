"""What a file is split into: lines without their comments, and the sections that hold them."""

import re
from typing import NamedTuple

from vrts.lang.reading.characters import OPENING_QUOTES

_QUOTES = re.escape(OPENING_QUOTES)
_STRING_OR_COMMENT = re.compile(rf"""("[^"]*("|$)|[{_QUOTES}][^{_QUOTES}"]*[{_QUOTES}"]|'.)|(;)""")


class Line(NamedTuple):
    """What stands on a line before its comment, blanks stripped."""

    number: int  # in its section, from 1
    text: str
    start: int
    end: int


class Section(NamedTuple):
    """A program or a data section."""

    kind: str  # "program", "locations", "reals", "strings"
    header: Line
    lines: tuple[Line, ...]  # the ones that hold something
    line_count: int  # blank and comment lines included
    finish: tuple[int, int]  # range of its .END, or of the end of its last line


def comment_start(line: str) -> int:
    """Return where the comment of a line begins (its `;`), or -1."""
    first = line.find(";")
    if first < 0:
        return -1
    for match in _STRING_OR_COMMENT.finditer(line):
        if match.group(3):
            return match.start()
    return -1
