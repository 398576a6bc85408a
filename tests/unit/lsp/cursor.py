"""A text with a cursor in it."""

from vrts.lsp.documents.documents import Document


def at(text: str, name: str = "/cell/a.v2") -> tuple[Document, int]:
    """Return the document and the offset of the `|` in it."""
    offset = text.index("|")
    return Document(name, text.replace("|", "", 1)), offset
