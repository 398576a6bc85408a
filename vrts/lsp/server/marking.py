"""Semantic tokens and code actions."""

from lsprotocol import types

from vrts.base.diagnostic import Diagnostic
from vrts.lsp.colouring import Colour, coloured
from vrts.lsp.documents import Document
from vrts.lsp.findings import Mending
from vrts.lsp.fixing import Remedy, remedies
from vrts.lsp.server.diagnostics import converted
from vrts.lsp.server.places import Places
from vrts.lsp.server.session import Session

_COLOURS = list(Colour)
_NUMBERS = {colour: number for number, colour in enumerate(_COLOURS)}
LEGEND = types.SemanticTokensLegend(
    [colour.value for colour in _COLOURS], ["definition", "defaultLibrary"]
)


def register(session: Session) -> None:
    """Answer what words are, and what would mend them."""

    @session.feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL, LEGEND)
    def tokens(server: Session, params: types.SemanticTokensParams) -> types.SemanticTokens:
        document = server.document(params.text_document.uri)
        return types.SemanticTokens(_encoded(document, server.places(document)))

    @session.feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_RANGE, LEGEND)
    def some_tokens(
        server: Session, params: types.SemanticTokensRangeParams
    ) -> types.SemanticTokens:
        document = server.document(params.text_document.uri)
        lines = params.range.start.line, params.range.end.line
        return types.SemanticTokens(_encoded(document, server.places(document), *lines))

    @session.feature(
        types.TEXT_DOCUMENT_CODE_ACTION,
        types.CodeActionOptions([types.CodeActionKind.QuickFix]),
    )
    async def actions(server: Session, params: types.CodeActionParams) -> list[types.CodeAction]:
        uri = params.text_document.uri
        document = server.document(uri)
        found = await server.diagnostics_of(document)
        if server.document(uri) is not document:
            return []
        places = server.places(document)
        first, last = places.offset(params.range.start), places.offset(params.range.end)
        mended = [
            _action(remedy, diagnostic, uri, places)
            for diagnostic in found
            if _touches(diagnostic, first, last)
            for remedy in remedies(document, diagnostic)
        ]
        return mended + [
            _of_run(finding.mending, server.shown(finding, document), uri, places)
            for finding in server.findings(document)
            if finding.mending is not None
            if finding.start <= last and first <= finding.end
        ]


def _encoded(
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


def _touches(diagnostic: Diagnostic, first: int, last: int) -> bool:
    if diagnostic.primary is None:
        return False
    span = diagnostic.primary.span
    return span.start <= last and first <= max(span.end, span.start + 1)


def _action(remedy: Remedy, diagnostic: Diagnostic, uri: str, places: Places) -> types.CodeAction:
    edit = types.TextEdit(places.range(remedy.edit.start, remedy.edit.end), remedy.edit.text)
    return types.CodeAction(
        remedy.title,
        types.CodeActionKind.QuickFix,
        [converted(diagnostic, uri, places)],
        is_preferred=remedy.preferred,
        edit=types.WorkspaceEdit(changes={uri: [edit]}),
    )


def _of_run(
    mending: Mending, shown: types.Diagnostic, uri: str, places: Places
) -> types.CodeAction:
    edits = [types.TextEdit(places.range(e.start, e.end), e.text) for e in mending.edits]
    return types.CodeAction(
        mending.title,
        types.CodeActionKind.QuickFix,
        [shown],
        is_preferred=True,
        edit=types.WorkspaceEdit(changes={uri: edits}),
    )
