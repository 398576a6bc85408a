"""A change that earns the full mark: looked for when chosen, shown before it is made."""

from lsprotocol import types

from vrts.lsp.channel.mend import Mend
from vrts.lsp.channel.verification import Asked
from vrts.lsp.server.session import Session, path_of

SEARCH = "Look for a change that earns the full mark (takes some seconds)"
MAKE, LEAVE = "Make the change", "Leave it"


def search_for(uri: str) -> types.CodeAction:
    """Return an action of which nothing is worked out until it is chosen."""
    return types.CodeAction(SEARCH, types.CodeActionKind.QuickFix, data=uri)


async def searched(server: Session, action: types.CodeAction, uri: str) -> types.CodeAction:
    """Return an action with its edit, if one was found and is wanted."""
    document = server.document(uri)
    found = await server.mending.mend(Asked(path_of(uri), document.source.text))
    if server.document(uri) is not document:
        _say(server, "the program has changed meanwhile: ask again")
        return action
    if not found.edits:
        _say(server, found.said or "nothing was found in the time that there is")
        return action
    places = server.places(document)
    edits = [types.TextEdit(places.range(e.start, e.end), e.text) for e in found.edits]
    if _shows_first(server.client_capabilities):
        return _annotated(server, action, uri, edits, found)
    if await _wanted(server, found):
        action.edit = types.WorkspaceEdit(changes={uri: edits})
    return action


def _say(server: Session, text: str) -> None:
    message = types.ShowMessageParams(types.MessageType.Info, text)
    server.window_show_message(message)


def _shows_first(client: types.ClientCapabilities) -> bool:
    """Return whether a client shows the edit of an action, with what is noted on it, beforehand."""
    actions = None if client.text_document is None else client.text_document.code_action
    edits = None if client.workspace is None else client.workspace.workspace_edit
    noted = edits is not None and edits.document_changes and edits.change_annotation_support
    return bool(noted and actions is not None and actions.honors_change_annotations)


def _annotated(
    server: Session, action: types.CodeAction, uri: str, edits: list[types.TextEdit], found: Mend
) -> types.CodeAction:
    version = server.version_of(server.document(uri))
    of = types.OptionalVersionedTextDocumentIdentifier(uri, version)
    noted = [types.AnnotatedTextEdit("future", edit.range, edit.new_text) for edit in edits]
    note = types.ChangeAnnotation(found.future, needs_confirmation=True, description=found.said)
    action.edit = types.WorkspaceEdit(
        document_changes=[types.TextDocumentEdit(of, noted)], change_annotations={"future": note}
    )
    return action


async def _wanted(server: Session, found: Mend) -> bool:
    """Show what comes of a change, and ask whether to make it."""
    choices = [types.MessageActionItem(MAKE), types.MessageActionItem(LEAVE)]
    text = f"{found.future}: {found.said}"
    params = types.ShowMessageRequestParams(types.MessageType.Info, text, choices)
    answer = await server.window_show_message_request_async(params)  # pyright: ignore[reportUnknownMemberType]
    return answer is not None and answer.title == MAKE
