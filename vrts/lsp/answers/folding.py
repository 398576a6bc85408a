"""What an editor may fold away: programs, structures, data, blocks of comments."""

from typing import NamedTuple

from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.uses import read_line

_OPENERS = frozenset({"IF", "WHILE", "FOR", "CASE", "DO"})
_CLOSERS = frozenset({"END", "UNTIL"})


class Fold(NamedTuple):
    """Lines, from 0; the last one stays visible where it ends a structure."""

    first: int
    last: int
    is_comment: bool = False


def folds(document: Document) -> list[Fold]:
    """Return what may be folded, in the order of the text."""
    source, names = document.source, document.names
    found: list[Fold] = []
    for section in (*(p.section for p in names.programs), *names.data):
        first = source.line_of(section.header.start) - 1
        last = source.line_of(max(section.finish[0], section.header.end)) - 1
        found.append(Fold(first, last))
    for program in names.programs:
        opened: list[int] = []
        for line in program.section.lines:
            word = read_line(line.text, document.dialect).word
            at = source.line_of(line.start) - 1
            if word in _OPENERS:
                opened.append(at)
            elif word == "ELSE" and opened:
                found.append(Fold(opened.pop(), at - 1))
                opened.append(at)
            elif word in _CLOSERS and opened:
                found.append(Fold(opened.pop(), at - 1))
    found += _comments(document)
    return sorted(fold for fold in found if fold.last > fold.first)


def _comments(document: Document) -> list[Fold]:
    found: list[Fold] = []
    first = None
    lines = document.source.text.split("\n")
    for number, line in enumerate([*lines, ""]):
        if line.lstrip().startswith(";"):
            first = number if first is None else first
        elif first is not None:
            found.append(Fold(first, number - 1, is_comment=True))
            first = None
    return found
