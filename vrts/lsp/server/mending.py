"""Code actions: what would mend a text, or its run."""

from lsprotocol import types

from vrts.base.diagnostic import Diagnostic
from vrts.lsp.answers.fixing import Remedy, remedies
from vrts.lsp.channel.findings import Finding, Mending
from vrts.lsp.server.diagnostics import converted
from vrts.lsp.server.places import Places
from vrts.lsp.server.scenarios import keeping
from vrts.lsp.server.searching import SEARCH, search_for, searched
from vrts.lsp.server.session import Session


def register(session: Session) -> None:
    """Answer what would mend what is wrong."""

    @session.feature(
        types.TEXT_DOCUMENT_CODE_ACTION,
        types.CodeActionOptions([types.CodeActionKind.QuickFix], resolve_provider=True),
    )
    async def actions(server: Session, params: types.CodeActionParams) -> list[types.CodeAction]:
        uri = params.text_document.uri
        document = server.document(uri)
        places = server.places(document)
        first, last = places.offset(params.range.start), places.offset(params.range.end)
        found = await server.diagnostics_near(document, first, last)
        if server.document(uri) is not document:
            return []
        mended = [
            _action(remedy, diagnostic, uri, places)
            for diagnostic in found
            if _touches(diagnostic, first, last)
            for remedy in remedies(document, diagnostic)
        ]
        here = [f for f in server.findings(document) if f.start <= last and first <= f.end]
        mended += [
            _of_run(finding.mending, server.shown(finding, document), uri, places)
            for finding in here
            if finding.mending is not None
        ]
        answer = server.verifications.answer(document)
        lost = any(one.start <= last and first <= one.end for one in answer.lost)
        asked = answer.mendable and (here or lost)
        if asked and _resolves(server.client_capabilities):
            mended.append(search_for(uri))
        if not _makes_files(server.client_capabilities):
            return mended
        return mended + [
            _kept(finding, server.shown(finding, document)) for finding in here if finding.scenario
        ]

    @session.feature(types.CODE_ACTION_RESOLVE)
    async def resolve(server: Session, action: types.CodeAction) -> types.CodeAction:
        if isinstance(action.data, str) and action.title == SEARCH:
            return await searched(server, action, action.data)
        return action


def _touches(diagnostic: Diagnostic, first: int, last: int) -> bool:
    if diagnostic.primary is None:
        return False
    span = diagnostic.primary.span
    return span.start <= last and first <= max(span.end, span.start + 1)


def _action(remedy: Remedy, diagnostic: Diagnostic, uri: str, places: Places) -> types.CodeAction:
    edits = [types.TextEdit(places.range(e.start, e.end), e.text) for e in remedy.edits]
    return types.CodeAction(
        remedy.title,
        types.CodeActionKind.QuickFix,
        [converted(diagnostic, uri, places)],
        is_preferred=remedy.preferred,
        edit=types.WorkspaceEdit(changes={uri: edits}),
    )


def _makes_files(client: types.ClientCapabilities) -> bool:
    """Return whether an edit may make a file."""
    workspace = client.workspace
    edits = None if workspace is None else workspace.workspace_edit
    made = () if edits is None else edits.resource_operations or ()
    return types.ResourceOperationKind.Create in made


def _resolves(client: types.ClientCapabilities) -> bool:
    """Return whether an edit may come when an action has been chosen."""
    text = client.text_document
    actions = None if text is None else text.code_action
    resolve = None if actions is None or not actions.data_support else actions.resolve_support
    return resolve is not None and "edit" in resolve.properties


def _kept(finding: Finding, shown: types.Diagnostic) -> types.CodeAction:
    title = "Keep the scenario in which this happens beside the program"
    return types.CodeAction(title, types.CodeActionKind.QuickFix, [shown], edit=keeping(finding))


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
