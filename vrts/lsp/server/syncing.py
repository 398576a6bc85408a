"""Opening, changing and closing of buffers."""

from lsprotocol import types

from vrts.lsp.server.session import Session


def register(session: Session) -> None:
    """Follow what happens to buffers."""

    @session.feature(types.TEXT_DOCUMENT_DID_OPEN)
    def did_open(server: Session, params: types.DidOpenTextDocumentParams) -> None:
        server.opened(params.text_document.uri)

    @session.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def did_change(server: Session, params: types.DidChangeTextDocumentParams) -> None:
        server.opened(params.text_document.uri)

    @session.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def did_close(server: Session, params: types.DidCloseTextDocumentParams) -> None:
        server.closed(params.text_document.uri)
