"""The mark of a program in short, live, and the recording of its run, for who asks to show them.

A client says `vrts/beside` once; from then on it is told `vrts/shown` whenever a verification knows
more, and may ask for `vrts/recording`.
"""

from typing import Any, cast

from pygls.exceptions import JsonRpcInvalidParams

from vrts.lsp.documents.documents import Document
from vrts.lsp.server.background.settings import Looked
from vrts.lsp.server.beside.settings import last_scene, published
from vrts.lsp.server.beside.settings import shown as in_short
from vrts.lsp.server.session import Session


def register(session: Session) -> None:
    """Tell what is shown beside the text."""

    def told(document: Document) -> None:
        if session.documents.open.get(document.path) is not document:
            return  # there is another text by now: this is not its mark
        session.protocol.notify("vrts/shown", _in_short(session, document))

    def looked(found: Looked) -> None:
        places = session.places_in(found.of.source)
        session.text_document_publish_diagnostics(published(found, places))
        if session.told_beside is not None:
            session.protocol.notify("vrts/shown", in_short(found))

    session.told_looked = looked

    @session.feature("vrts/beside")
    def beside(server: Session, params: object) -> None:
        server.told_beside = told
        server.verifications.are_shown = True
        server.check_again()

    @session.feature("vrts/recording")
    def recording(server: Session, params: object) -> dict[str, object] | None:
        """Return the newest recording of a buffer; nothing where its text has not run."""
        setting = server.setting(_uri(params))
        if setting is not None:
            return last_scene(setting, server.settings.last_good.get(setting.path))
        document = server.document(_uri(params))
        shown = server.verifications.answer(document).shown
        if shown is None:
            return None
        return {"recording": shown.recording, "version": server.version_of(document)}


def _in_short(server: Session, document: Document) -> dict[str, Any]:
    answer = server.verifications.answer(document)
    told: dict[str, Any] = {
        "uri": server.uri(document),
        "version": server.version_of(document),
        "whole": answer.is_whole,
    }
    shown = answer.shown
    if shown is not None:
        told["shown"] = {
            "mark": shown.mark,
            "ready": shown.is_ready,
            "readyIn": shown.ready_in,
            "reasons": list(shown.reasons),
            "cause": shown.cause,
            "settled": shown.is_settled,
            "line": shown.line,
        }
    return told


def _uri(params: object) -> str:
    """Return the address of the buffer that a request is about.

    Raises:
        JsonRpcInvalidParams: It names none.
    """
    uri = cast("dict[str, object]", params).get("uri") if isinstance(params, dict) else None
    if not isinstance(uri, str) or "\0" in uri:
        raise JsonRpcInvalidParams("`vrts/recording`: uri is no address of a buffer")
    return uri
