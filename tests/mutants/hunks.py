"""An edit of a text by whole lines: where, what stood there, what stands there now."""

import difflib
from collections.abc import Iterable, Sequence
from typing import NamedTuple


class StaleError(ValueError):
    """The text is no longer the one that an edit was made for."""


class Hunk(NamedTuple):
    """Lines that take the place of others; `before` is empty where lines are only added."""

    line: int  # the first line replaced, or before which lines are added; from 1
    before: tuple[str, ...]
    after: tuple[str, ...]


def hunks(before: Sequence[str], after: Sequence[str]) -> tuple[Hunk, ...]:
    """Return the lines that differ, with nothing around them."""
    matcher = difflib.SequenceMatcher(None, before, after, autojunk=False)
    return tuple(
        Hunk(i1 + 1, tuple(before[i1:i2]), tuple(after[j1:j2]))
        for tag, i1, i2, j1, j2 in matcher.get_opcodes()
        if tag != "equal"
    )


def applied(text: str, edits: Iterable[Hunk]) -> str:
    """Return a text with an edit made.

    Raises:
        StaleError: The lines that the edit replaces do not stand where they should.
    """
    lines = text.splitlines()
    for hunk in sorted(edits, reverse=True):
        at = slice(hunk.line - 1, hunk.line - 1 + len(hunk.before))
        if tuple(lines[at]) != hunk.before:
            raise StaleError(f"line {hunk.line} is {lines[at]}, not {list(hunk.before)}")
        lines[at] = hunk.after
    return "".join(f"{line}\n" for line in lines)


def apart(a: Iterable[Hunk], b: Iterable[Hunk]) -> bool:
    """Return whether two edits touch different lines, with one line or more between them."""
    second = list(b)
    return all(
        one.line + len(one.before) < two.line or two.line + len(two.before) < one.line
        for one in a
        for two in second
    )
