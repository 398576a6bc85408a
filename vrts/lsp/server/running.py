"""Code lenses, and inlay hints from a verification in the background."""

from lsprotocol import types

from vrts.lsp.answers.lenses import lenses
from vrts.lsp.channel.timing import STEP_S, Timing, hint
from vrts.lsp.documents.documents import Document
from vrts.lsp.server.session import Session

SHOWN = ""  # of a lens that does nothing when it is chosen


def register(session: Session) -> None:
    """Answer what a program does when it runs."""

    @session.feature(types.TEXT_DOCUMENT_CODE_LENS)
    def code_lenses(server: Session, params: types.CodeLensParams) -> list[types.CodeLens]:
        document = server.document(params.text_document.uri)
        places = server.places(document)
        uri = params.text_document.uri
        return [
            types.CodeLens(
                places.range(lens.start, lens.end),
                types.Command(lens.title, lens.command, arguments=[uri, lens.entry]),
            )
            for lens in lenses(document)
        ] + [
            types.CodeLens(places.range(lost.start, lost.end), types.Command(lost.why, SHOWN))
            for lost in server.verifications.answer(document).lost
        ]

    @session.feature(types.TEXT_DOCUMENT_INLAY_HINT)
    def inlay_hints(server: Session, params: types.InlayHintParams) -> list[types.InlayHint]:
        document = server.document(params.text_document.uri)
        places = server.places(document)
        first, last = params.range.start.line, params.range.end.line
        return [
            types.InlayHint(
                places.position(_line_end(document, timing.line)),
                hint(timing),
                tooltip=_tooltip(timing),
                padding_left=True,
            )
            for timing in server.verifications.answer(document).timings
            if first <= timing.line - 1 <= last
        ]

    @session.feature(types.SHUTDOWN)
    def shutdown(server: Session, params: None) -> None:
        server.leave()


def _line_end(document: Document, line: int) -> int:
    source = document.source
    return source.line_starts[line - 1] + len(source.line_text(line))


def _tooltip(timing: Timing) -> str:
    often = "once" if timing.times == 1 else f"{timing.times} times"
    text = f"takes {timing.takes_s:.2f} s; moves the arm {often}; seconds since the start"
    if timing.clearance_mm is None:
        return text
    return f"{text}; least clearance seen every {STEP_S} s: `vrts verify` proves more"
