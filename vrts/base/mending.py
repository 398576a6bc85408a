"""Fixes applied to the text that they belong to."""

from collections.abc import Callable, Iterable, Sequence

from vrts.base.diagnostic import Diagnostic, Edit
from vrts.base.source import SourceFile


def mendable(source: SourceFile, found: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Return the diagnostics whose fixes are sure and can be applied at once, each of them whole.

    A fix waits for another pass where it changes what one before it changes, too.
    """
    taken: list[Edit] = []
    chosen: list[Diagnostic] = []
    for diagnostic in found:
        if diagnostic.fix is None or not diagnostic.fix.sure:
            continue
        edits = diagnostic.fix.edits
        if all(edit.span.source is source for edit in edits) and not _clash(edits, taken):
            taken += edits
            chosen.append(diagnostic)
    return chosen


def edits_of(found: Iterable[Diagnostic]) -> list[Edit]:
    """Return the edits of diagnostics that have any."""
    return [edit for d in found if d.fix is not None for edit in d.fix.edits]


def with_edits(
    text: str, edits: Iterable[Edit], place: Callable[[int], int] = lambda offset: offset
) -> str:
    """Return a text after edits, none of which overlaps another.

    Args:
        text: What is changed.
        edits: What to write where.
        place: Where in the text an offset of the edits' source is.
    """
    for edit in sorted(edits, key=lambda edit: edit.span[1:], reverse=True):
        start, end = place(edit.span.start), place(edit.span.end)
        text = text[:start] + edit.replacement + text[end:]
    return text


def _clash(edits: Sequence[Edit], taken: Sequence[Edit]) -> bool:
    return any(_touch(edit, other) for edit in edits for other in taken)


def _touch(a: Edit, b: Edit) -> bool:
    """Whether the order of two edits would matter: they overlap, or begin at one place."""
    (_, start, end), (_, first, last) = a.span, b.span
    return (start < last and first < end) or start == first
