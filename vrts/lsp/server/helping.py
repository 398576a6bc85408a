"""Hover, completion and signature help."""

import re
from itertools import count

from lsprotocol import types

from vrts.lsp.answers.completing import Proposal, What, complete
from vrts.lsp.answers.hovering import hover
from vrts.lsp.answers.signatures import signature
from vrts.lsp.documents.linking import group
from vrts.lsp.server.beside.settings import completed, explained
from vrts.lsp.server.session import Session

_KINDS = {
    What.INSTRUCTION: types.CompletionItemKind.Keyword,
    What.QUALIFIER: types.CompletionItemKind.Keyword,
    What.FUNCTION: types.CompletionItemKind.Function,
    What.CONSTANT: types.CompletionItemKind.Constant,
    What.PROGRAM: types.CompletionItemKind.Module,
    What.LABEL: types.CompletionItemKind.Reference,
    What.LOCATION: types.CompletionItemKind.Struct,
    What.VARIABLE: types.CompletionItemKind.Variable,
    What.SIGNAL: types.CompletionItemKind.Value,
    What.SECTION: types.CompletionItemKind.Module,
}


_CALLED = re.compile(r"(?P<name>[^\s(]+)\((?P<inside>[^()]+)\)")
_ARGUMENT = re.compile(r"[^,\s]+")


def register(session: Session) -> None:
    """Answer what helps with the word under the cursor."""
    asked: list[bool] = []  # holds something where the client takes snippets

    def begins(params: types.InitializeParams) -> None:
        asked[:] = [True] if _snippets(params) else []

    session.offers.append(begins)

    @session.feature(types.TEXT_DOCUMENT_HOVER)
    async def hovering(server: Session, params: types.HoverParams) -> types.Hover | None:
        setting = server.setting(params.text_document.uri)
        if setting is not None:
            return explained(setting, server.places_in(setting.source), params.position)
        document = server.document(params.text_document.uri)
        places = server.places(document)
        found = hover(document, places.offset(params.position), server.group(document))
        if found is None:
            return None
        about = found.about
        place = found.place
        if place is not None and server.runs:
            reached = await server.aside(lambda: server.reaching.text(document.path, place))
            about += f"\n\n```\n{reached}\n```" if reached else ""
        text = f"```val2\n{found.code}\n```\n{about}"
        content = types.MarkupContent(types.MarkupKind.Markdown, text)
        return types.Hover(content, places.range(found.start, found.end))

    @session.feature(
        types.TEXT_DOCUMENT_COMPLETION,
        types.CompletionOptions(trigger_characters=["$", "#", ".", "("]),
    )
    def completion(server: Session, params: types.CompletionParams) -> types.CompletionList:
        setting = server.setting(params.text_document.uri)
        if setting is not None:
            bodies = server.settings.bodies.get(setting.path, ())
            within = server.places_in(setting.source)
            return completed(setting, within, params.position, bodies)
        document = server.document(params.text_document.uri)
        places = server.places(document)
        beside = server.documents.beside(document.path)
        found = complete(document, places.offset(params.position), group(document, beside), beside)
        replaced = places.range(found.start, found.end)
        fills = bool(asked) and document.source.text[found.end : found.end + 1] != "("
        items = [_item(proposal, replaced, fills=fills) for proposal in found.proposals]
        return types.CompletionList(is_incomplete=not found.is_all, items=items)

    @session.feature(
        types.TEXT_DOCUMENT_SIGNATURE_HELP,
        types.SignatureHelpOptions(trigger_characters=["(", ",", " "]),
    )
    def signature_help(
        server: Session, params: types.SignatureHelpParams
    ) -> types.SignatureHelp | None:
        document = server.document(params.text_document.uri)
        offset = server.places(document).offset(params.position)
        found = signature(document, offset, server.group(document))
        if found is None:
            return None
        parameters = [types.ParameterInformation(text) for text in found.parameters]
        shown = types.SignatureInformation(found.text, found.about, parameters)
        return types.SignatureHelp([shown], 0, found.active)


def _snippets(params: types.InitializeParams) -> bool:
    """Return whether a client fills in places of a text that is completed."""
    text = params.capabilities.text_document
    item = text.completion.completion_item if text and text.completion else None
    return bool(item and item.snippet_support)


def _filled(usage: str) -> str | None:
    """Return `NAME(a, b)` as a snippet whose arguments are places to fill in; None: it has none."""
    found = _CALLED.fullmatch(usage)
    if found is None:
        return None
    numbers = count(1)

    def place(argument: re.Match[str]) -> str:
        name = argument[0].replace("\\", "\\\\").replace("$", "\\$").replace("}", "\\}")
        return f"${{{next(numbers)}:{name}}}"

    listed = re.sub(r",? ?[^,\s]+\.\.\.", "", found["inside"])  # what may come again
    filled = " BY ".join(_ARGUMENT.sub(place, part) for part in listed.split(" BY "))
    return f"{found['name'].replace('$', chr(92) + '$')}({filled})"


def _item(proposal: Proposal, replaced: types.Range, *, fills: bool) -> types.CompletionItem:
    called = proposal.what in (What.FUNCTION, What.PROGRAM)
    filled = _filled(proposal.detail.partition(" in ")[0]) if called and fills else None
    if filled is not None:
        return types.CompletionItem(
            proposal.text,
            kind=_KINDS[proposal.what],
            detail=proposal.detail or None,
            documentation=proposal.about or None,
            sort_text=f"{proposal.rank}{proposal.text.lower()}",
            filter_text=proposal.text,
            insert_text_format=types.InsertTextFormat.Snippet,
            text_edit=types.TextEdit(replaced, filled),
        )
    return types.CompletionItem(
        proposal.text,
        kind=_KINDS[proposal.what],
        detail=proposal.detail or None,
        documentation=proposal.about or None,
        sort_text=f"{proposal.rank}{proposal.text.lower()}",
        text_edit=types.TextEdit(replaced, proposal.text),
    )
