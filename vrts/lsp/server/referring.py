"""Definition, references and rename."""

from lsprotocol import types
from pygls.exceptions import JsonRpcException

from vrts.lsp.answers.finding import Found, definition, references
from vrts.lsp.answers.renaming import CannotRename, renamable, rename
from vrts.lsp.documents.uses import Role
from vrts.lsp.server.session import Session

REQUEST_FAILED = -32803  # LSP 3.17: carried out, and refused for a reason


def register(session: Session) -> None:
    """Answer where names are."""

    @session.feature(types.TEXT_DOCUMENT_DEFINITION)
    async def defined(server: Session, params: types.DefinitionParams) -> list[types.Location]:
        document = server.document(params.text_document.uri)
        offset = server.places(document).offset(params.position)
        found = definition(document, offset, [document])
        if not found:  # it stands in another file
            await server.all_read(params.text_document.uri)
            found = definition(document, offset, server.group(document))
        return _locations(server, found)

    @session.feature(types.TEXT_DOCUMENT_REFERENCES)
    async def referred(server: Session, params: types.ReferenceParams) -> list[types.Location]:
        await server.all_read(params.text_document.uri)
        document = server.document(params.text_document.uri)
        offset = server.places(document).offset(params.position)
        wanted = params.context.include_declaration
        group = server.group(document)
        return _locations(server, references(document, offset, group, definitions_too=wanted))

    @session.feature(types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
    def highlighted(
        server: Session, params: types.DocumentHighlightParams
    ) -> list[types.DocumentHighlight]:
        document = server.document(params.text_document.uri)
        places = server.places(document)
        kinds = {
            Role.READ: types.DocumentHighlightKind.Read,
            Role.WRITE: types.DocumentHighlightKind.Write,
        }
        return [
            types.DocumentHighlight(places.range(o.start, o.end), kinds.get(o.role))
            for _, o in references(document, places.offset(params.position), [document])
        ]

    @session.feature(types.TEXT_DOCUMENT_PREPARE_RENAME)
    def rename_begins(
        server: Session, params: types.PrepareRenameParams
    ) -> types.PrepareRenamePlaceholder:
        document = server.document(params.text_document.uri)
        places = server.places(document)
        try:
            found = renamable(document, places.offset(params.position))
        except CannotRename as problem:
            raise JsonRpcException(str(problem), REQUEST_FAILED) from problem
        written = document.source.text[found.start : found.end]
        return types.PrepareRenamePlaceholder(places.range(found.start, found.end), written)

    @session.feature(types.TEXT_DOCUMENT_RENAME, types.RenameOptions(prepare_provider=True))
    async def renamed(server: Session, params: types.RenameParams) -> types.WorkspaceEdit:
        await server.all_read(params.text_document.uri)
        document = server.document(params.text_document.uri)
        offset = server.places(document).offset(params.position)
        try:
            found = rename(document, offset, params.new_name, server.group(document))
        except CannotRename as problem:
            raise JsonRpcException(str(problem), REQUEST_FAILED) from problem
        return _edited(server, found, params.new_name)


def _locations(server: Session, found: list[Found]) -> list[types.Location]:
    return [
        types.Location(server.uri(document), server.places(document).range(o.start, o.end))
        for document, o in found
    ]


def _edited(server: Session, found: list[Found], new: str) -> types.WorkspaceEdit:
    edits: dict[str, list[types.TextEdit]] = {}
    for document, o in found:
        edit = types.TextEdit(server.places(document).range(o.start, o.end), new)
        edits.setdefault(server.uri(document), []).append(edit)
    return types.WorkspaceEdit(changes=edits)
