"""Where a name is defined and used, over the files that belong together."""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.lsp.answers.hovering import definitions
from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.names import Occurrence
from vrts.lsp.documents.uses import Role


class Found(NamedTuple):
    """A name in a file."""

    document: Document
    occurrence: Occurrence


def definition(document: Document, offset: int, group: Sequence[Document]) -> list[Found]:
    """Return where the name at an offset gets its value or its place."""
    occurrence = document.names.at(offset)
    if occurrence is None:
        return []
    return [Found(*found) for found in definitions(occurrence, group)]


def references(
    document: Document, offset: int, group: Sequence[Document], *, definitions_too: bool = True
) -> list[Found]:
    """Return every use of the name at an offset, those of its own file first."""
    occurrence = document.names.at(offset)
    if occurrence is None:
        return []
    target = occurrence.target
    return [
        Found(other, use)
        for other in (group[:1] if target.program else group)
        for use in other.names.by_target.get(target, ())
        if definitions_too or use.role is Role.READ
    ]
