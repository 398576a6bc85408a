"""Semantic tokens, whole, of some lines, or as a change of those that were sent last."""

from itertools import count
from typing import NamedTuple

from lsprotocol import types

from vrts.lsp.answers.colouring import Colour, coloured
from vrts.lsp.documents.documents import Document
from vrts.lsp.server.places import Places
from vrts.lsp.server.session import Session

_COLOURS = list(Colour)
_NUMBERS = {colour: number for number, colour in enumerate(_COLOURS)}
LEGEND = types.SemanticTokensLegend(
    [colour.value for colour in _COLOURS], ["definition", "defaultLibrary"]
)


class _Sent(NamedTuple):
    result: str  # identity of the answer
    data: list[int]


def register(session: Session) -> None:
    """Answer what words are."""
    sent: dict[str, _Sent] = {}  # what was answered last, by the path of a buffer
    numbers = count(1)

    def answer(server: Session, document: Document) -> _Sent:
        for path in sent.keys() - server.documents.open.keys():
            del sent[path]
        found = _Sent(str(next(numbers)), encoded(document, server.places(document)))
        sent[document.path] = found
        return found

    @session.feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL, LEGEND)
    def tokens(server: Session, params: types.SemanticTokensParams) -> types.SemanticTokens:
        found = answer(server, server.document(params.text_document.uri))
        return types.SemanticTokens(found.data, found.result)

    @session.feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL_DELTA, LEGEND)
    def changes(
        server: Session, params: types.SemanticTokensDeltaParams
    ) -> types.SemanticTokens | types.SemanticTokensDelta:
        document = server.document(params.text_document.uri)
        before = sent.get(document.path)
        found = answer(server, document)
        if before is None or before.result != params.previous_result_id:
            return types.SemanticTokens(found.data, found.result)
        return types.SemanticTokensDelta(changed(before.data, found.data), found.result)

    @session.feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_RANGE, LEGEND)
    def some_tokens(
        server: Session, params: types.SemanticTokensRangeParams
    ) -> types.SemanticTokens:
        document = server.document(params.text_document.uri)
        lines = params.range.start.line, params.range.end.line
        return types.SemanticTokens(encoded(document, server.places(document), *lines))


def encoded(
    document: Document, places: Places, first: int = 0, last: int | None = None
) -> list[int]:
    """Return words as the protocol encodes them: five numbers each, relative to the one before."""
    source = document.source
    starts = source.line_starts
    data: list[int] = []
    line, line_before, column_before = max(first, 0), 0, 0
    for word in coloured(document, max(first, 0), last):
        while line + 1 < len(starts) and starts[line + 1] <= word.start:
            line += 1
        column = places.length(starts[line], word.start)
        data += (
            line - line_before,
            column - column_before if line == line_before else column,
            places.length(word.start, word.end),
            _NUMBERS[word.colour],
            word.is_definition + 2 * word.is_built_in,
        )
        line_before, column_before = line, column
    return data


def changed(before: list[int], after: list[int]) -> list[types.SemanticTokensEdit]:
    """Return the edit that makes numbers others: all between the first and the last difference."""
    most = min(len(before), len(after))
    head = next((n for n in range(most) if before[n] != after[n]), most)
    other = (n for n in range(most - head) if before[-1 - n] != after[-1 - n])
    tail = next(other, most - head)
    if head == len(before) == len(after):
        return []
    new = after[head : len(after) - tail]
    return [types.SemanticTokensEdit(head, len(before) - tail - head, new)]
