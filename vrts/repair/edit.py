"""Typed edits: what to write where, which line that blames, and how large it is."""

from collections.abc import Iterable
from enum import Enum
from typing import NamedTuple

from vrts.base.diagnostic import Edit
from vrts.base.mending import with_edits
from vrts.base.source import SourceFile, Span


class Does(Enum):
    """What an edit does to a program; the value is a word for it."""

    NUMBER = "number"  # another number
    NAME = "name"  # another name
    WORD = "word"  # another keyword, operator or unit; ALWAYS more or less
    ADD = "add"  # a step more
    REMOVE = "remove"  # a step less
    ORDER = "order"  # steps, names or values change places
    ROW = "row"  # several values of a row, or a row more
    BOTH = "both"  # several of these


class Change(NamedTuple):
    """An edit of a program: one mistake mended."""

    does: Does
    line: int  # the line that it blames, from 1: before an added step, the one that follows it
    edits: tuple[Edit, ...]
    size: int  # nodes of the syntax that differ
    old: str = ""  # what stands there
    new: str = ""  # what is to stand there


class Candidate(NamedTuple):
    """A change, and what speaks against it: less is likelier."""

    cost: float
    change: Change
    group: tuple[str, int] = ("", 0)  # others of it are much the same: another value, there


def replacement(source: SourceFile, start: int, end: int, text: str) -> Edit:
    """Return the edit that writes a text over a range of a source."""
    return Edit(Span(source, start, end), text)


def changed(text: str, edits: Iterable[Edit]) -> str:
    """Return a program after edits, none of which overlaps another."""
    return with_edits(text, edits)
