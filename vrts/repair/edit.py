"""Typed edits: what to write where, which line that blames, and how large it is."""

from collections.abc import Iterable
from enum import Enum
from typing import NamedTuple

from vrts.base.diagnostic import Edit
from vrts.base.mending import with_edits
from vrts.base.source import SourceFile, Span

FARTHEST = 600.0  # [mm] of a usual distance of APPRO and DEPART


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
    parts: "tuple[Change, ...]" = ()  # of several mistakes: each by itself, lines as in the file

    @property
    def each(self) -> "tuple[Change, ...]":
        """The changes that it is made of: itself, if it is one."""
        return self.parts or (self,)


class Candidate(NamedTuple):
    """A change, and what speaks against it: less is likelier."""

    cost: float
    change: Change
    group: tuple[str, int] = ("", 0)  # others of it are much the same: another value, there
    doubt: float = 0.0  # what a teacher says against it who sees that it earns the full mark


def replacement(source: SourceFile, start: int, end: int, text: str) -> Edit:
    """Return the edit that writes a text over a range of a source."""
    return Edit(Span(source, start, end), text)


def both(source: SourceFile, first: Change, second: Change) -> Change | None:
    """Return two changes as one of a source; None where they touch each other.

    Args:
        source: What is changed.
        first: A change of it.
        second: A change of what the first makes of it.
    """
    made = [_back(source, first.edits, edit) for edit in second.edits]
    kept = [edit for edit in made if edit is not None]
    if len(kept) < len(made):
        return None
    # what the second blames stands where its edit does, or as far from it as it says
    behind = second.line - second.edits[0].span.line
    again = second._replace(line=kept[0].span.line + behind, edits=tuple(kept))
    parts = tuple(sorted((first, again), key=lambda part: part.line))
    size = first.size + second.size
    return Change(Does.BOTH, first.line, (*first.edits, *kept), size, parts=parts)


def _back(source: SourceFile, before: Iterable[Edit], edit: Edit) -> Edit | None:
    """Return an edit of what other edits make of a source as one of the source itself."""
    start, end = edit.span.start, edit.span.end
    moved = 0
    for other in sorted(before, key=lambda each: each.span[1:]):
        first = other.span.start + moved
        behind = first + len(other.replacement)
        if (start < behind and first < end) or start == first:
            return None
        if start < behind:
            break
        moved += len(other.replacement) - (other.span.end - other.span.start)
    return Edit(Span(source, start - moved, end - moved), edit.replacement)


def changed(text: str, edits: Iterable[Edit]) -> str:
    """Return a program after edits, none of which overlaps another."""
    return with_edits(text, edits)


def changed_lines(change: Change) -> frozenset[int]:
    """Return the lines of the file on which edits of a change begin."""
    return frozenset(edit.span.line for edit in change.edits)
