"""Text on a screen of some width: cut with a mark, wrapped between words, scrolled sideways."""

from collections.abc import Iterable
from typing import TypeAlias

from vrts.report.plain import width as columns

Piece: TypeAlias = tuple[str, str]  # style class, text
Row: TypeAlias = list[Piece]

CUT = "…"
BEFORE, BEHIND = "‹", "›"  # more of a line that is typed


def cut(text: str, room: int) -> str:
    """Return a text in at most so many columns; `…` ends one that is cut."""
    if room <= 0:
        return ""
    if len(text) <= room and columns(text) <= room:
        return text
    return _first(text, room - 1) + CUT


def fitted(row: Row, room: int) -> Row:
    """Return a row of exactly so many columns, cut or filled."""
    whole = sum(columns(text) for _, text in row)
    found: Row = []
    left = room
    for style, text in row:
        # the mark stands at the last column, also where a piece ends just before it
        part = text if whole <= room or columns(text) < left else cut(f"{text} ", left)
        if part:
            found.append((style, part))
        left -= columns(part)
        if left <= 0:
            break
    return [*found, ("", " " * left)] if left > 0 else found


def wrapped(lines: Iterable[str], room: int) -> list[str]:
    """Return lines of at most so many columns, parted between words; the rest is indented alike."""
    room = max(room, 1)
    found: list[str] = []
    for line in lines:
        found += _wrapped(line.rstrip(), room)
    return found


def _wrapped(line: str, room: int) -> list[str]:
    indent = " " * min(len(line) - len(line.lstrip(" ")) + 2, room // 3)
    found: list[str] = []
    while columns(line) > room:
        part = _first(line, room)
        blank = part.rstrip().rfind(" ") if line[len(part)] != " " else len(part)
        at = blank if blank > len(indent) else len(part)
        if at == 0:  # one wide character in one column
            break
        found.append(line[:at].rstrip())
        line = indent + line[at:].lstrip()
        if len(line) <= len(indent):
            return found
    return [*found, line]


def typed(text: str, at: int, room: int) -> Row:
    """Return a line while it is typed, with the cursor at a character, in so many columns."""
    room = max(room, 3)
    begin = max(0, at - room + 3)
    while begin < at and columns(text[begin : at + 1]) > room - 2:
        begin += 1
    before, behind = text[begin:at], text[at + 1 :]
    under = text[at : at + 1] or " "
    left = room - columns(before) - columns(under) - (begin > 0)
    row: Row = [("frame", BEFORE)] if begin > 0 else []
    row += [("", before), ("cursor", under)]
    if columns(behind) <= left:
        return [*row, ("", behind)]
    return [*row, ("", _first(behind, left - 1)), ("frame", BEHIND)]


def _first(text: str, room: int) -> str:
    taken = 0
    for k, character in enumerate(text):
        taken += columns(character)
        if taken > room:
            return text[:k]
    return text
