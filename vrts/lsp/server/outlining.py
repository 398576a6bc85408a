"""Symbols, folding and formatting."""

from lsprotocol import types

from vrts.lsp.answers.folding import folds
from vrts.lsp.answers.formatting import Edit, layout_edits
from vrts.lsp.answers.symbols import Symbol, What, all_symbols, symbols
from vrts.lsp.documents.documents import Document
from vrts.lsp.server.places import Places
from vrts.lsp.server.session import Session

MOST_SYMBOLS = 1000  # that a search over all files answers

_KINDS = {
    What.PROGRAM: types.SymbolKind.Function,
    What.LABEL: types.SymbolKind.Key,
    What.SECTION: types.SymbolKind.Namespace,
    What.LOCATION: types.SymbolKind.Object,
    What.NUMBER: types.SymbolKind.Number,
    What.STRING: types.SymbolKind.String,
}


def register(session: Session) -> None:
    """Answer what concerns the shape of a file."""

    @session.feature(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    def document_symbols(
        server: Session, params: types.DocumentSymbolParams
    ) -> list[types.DocumentSymbol]:
        document = server.document(params.text_document.uri)
        places = server.places(document)
        return [converted(symbol, places) for symbol in symbols(document)]

    @session.feature(types.WORKSPACE_SYMBOL)
    async def workspace_symbols(
        server: Session, params: types.WorkspaceSymbolParams
    ) -> list[types.WorkspaceSymbol]:
        for folder in server.documents.folders(server.folders()):
            await server.reading.whole(folder)
        documents = server.documents.everywhere(server.folders())
        found = all_symbols(documents, params.query)[:MOST_SYMBOLS]
        return [
            types.WorkspaceSymbol(
                types.Location(
                    server.uri(document),
                    server.places(document).range(symbol.name_start, symbol.name_end),
                ),
                symbol.name,
                _KINDS[symbol.what],
                container_name=document.source.name,
            )
            for document, symbol in found
        ]

    @session.feature(types.TEXT_DOCUMENT_FOLDING_RANGE)
    def folding(server: Session, params: types.FoldingRangeParams) -> list[types.FoldingRange]:
        return [
            types.FoldingRange(
                fold.first,
                fold.last,
                kind=types.FoldingRangeKind.Comment if fold.is_comment else None,
            )
            for fold in folds(server.document(params.text_document.uri))
        ]

    @session.feature(types.TEXT_DOCUMENT_FORMATTING)
    async def formatting(
        server: Session, params: types.DocumentFormattingParams
    ) -> list[types.TextEdit]:
        document = server.document(params.text_document.uri)
        edits = await server.aside(lambda: layout_edits(document))
        return _edits(server, document, edits)

    @session.feature(types.TEXT_DOCUMENT_RANGE_FORMATTING)
    async def range_formatting(
        server: Session, params: types.DocumentRangeFormattingParams
    ) -> list[types.TextEdit]:
        document = server.document(params.text_document.uri)
        last = params.range.end.line - (params.range.end.character == 0)
        lines = params.range.start.line, max(last, params.range.start.line)
        edits = await server.aside(lambda: layout_edits(document, *lines))
        return _edits(server, document, edits)


def _edits(server: Session, document: Document, edits: list[Edit]) -> list[types.TextEdit]:
    if server.document(server.uri(document)) is not document:
        return []  # it was typed on: these would hit other lines
    places = server.places(document)
    return [types.TextEdit(places.range(edit.start, edit.end), edit.text) for edit in edits]


def converted(symbol: Symbol, places: Places) -> types.DocumentSymbol:
    """Return a symbol as the protocol has it."""
    return types.DocumentSymbol(
        symbol.name,
        _KINDS[symbol.what],
        places.range(symbol.start, symbol.end),
        places.range(symbol.name_start, symbol.name_end),
        symbol.detail or None,
        children=[converted(part, places) for part in symbol.parts] or None,
    )
