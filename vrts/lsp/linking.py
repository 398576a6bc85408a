"""Which files of a folder belong together: one calls a program or uses data of the other."""

from collections.abc import Sequence

from vrts.lsp.documents import Document


def group(document: Document, beside: Sequence[Document]) -> list[Document]:
    """Return the files that a file belongs together with, itself first.

    Files are joined where one calls a program that only the other has, and where one uses a name
    that it gives no value and a file of nothing but data does. Other files of the folder may hold
    the same names and mean something else: the work of other people, or an older version.
    """
    found: list[Document] = [document]
    waiting: list[Document] = [document]
    left: list[Document] = list(beside)
    while waiting and left:
        one = waiting.pop()
        joined: list[Document] = [
            other for other in left if _belong(one, other) or _belong(other, one)
        ]
        left = [other for other in left if other not in joined]
        found += joined
        waiting += joined
    return found


def _belong(user: Document, giver: Document) -> bool:
    """Return whether a file needs what another one holds."""
    if user.names.missing("program") & giver.names.defined("program"):
        return True
    if giver.names.programs:
        return False
    return bool(user.names.missing("variable") & giver.names.defined("variable"))
