"""The canonical layout of a buffer, as edits of the lines that differ from it."""

from typing import NamedTuple

from vrts.lang.writing.layout import layout
from vrts.lsp.documents.documents import Document


class Edit(NamedTuple):
    """A replacement of a range of offsets."""

    start: int
    end: int
    text: str


def layout_edits(document: Document, first: int = 0, last: int | None = None) -> list[Edit]:
    """Return what to change so that lines are in canonical layout.

    Args:
        document: The buffer.
        first: First line, from 0.
        last: Last line; None: to the end of the text.
    """
    source = document.source
    if not source.text.strip():
        return []
    before = source.text.split("\n")
    after = layout(source, document.dialect).split("\n")
    edits: list[Edit] = []
    for number, (old, new) in enumerate(zip(before, after, strict=True)):
        if old != new and first <= number and (last is None or number <= last):
            start = source.line_starts[number]
            edits.append(Edit(start, start + len(old), new))
    if last is None and before[-1]:
        end = len(source.text)
        edits.append(Edit(end, end, "\n"))
    return edits
