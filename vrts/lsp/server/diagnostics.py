"""Diagnostics as the protocol has them."""

from importlib.resources import files

from lsprotocol import types
from pygls.uris import from_fs_path

from vrts.base.diagnostic import Diagnostic, Severity
from vrts.lang.usage import UNUSED_NAME
from vrts.lsp.server.places import Places

SEVERITIES = {
    Severity.ERROR: types.DiagnosticSeverity.Error,
    Severity.WARNING: types.DiagnosticSeverity.Warning,
    Severity.NOTE: types.DiagnosticSeverity.Information,
}


def converted(diagnostic: Diagnostic, uri: str, places: Places) -> types.Diagnostic:
    """Return a diagnostic with the link to its explanation.

    Args:
        diagnostic: Of one buffer; its labels lie in it.
        uri: Of the buffer.
        places: Of the buffer.
    """
    primary = diagnostic.primary
    start, end = (primary.span.start, primary.span.end) if primary is not None else (0, 0)
    if start == end:
        end = _something(places.source.text, start)
    related = [
        types.DiagnosticRelatedInformation(
            types.Location(uri, places.range(label.span.start, label.span.end)),
            label.text or "see here",
        )
        for label in diagnostic.secondary
    ]
    page = from_fs_path(str(files("vrts") / "pages" / f"{diagnostic.rule.code}.md"))
    return types.Diagnostic(
        places.range(start, end),
        message(diagnostic),
        SEVERITIES[diagnostic.severity],
        code=diagnostic.rule.code,
        code_description=types.CodeDescription(page) if page else None,
        source="vrts",
        tags=[types.DiagnosticTag.Unnecessary] if diagnostic.rule == UNUSED_NAME else None,
        related_information=related or None,
    )


def message(diagnostic: Diagnostic) -> str:
    """Return all that a diagnostic says but its places."""
    label = diagnostic.primary.text if diagnostic.primary is not None else ""
    rows = [diagnostic.headline + (f": {label}" if label else "")]
    rows += [f"note: {note}" for note in diagnostic.notes]
    rows += [f"help: {hint}" for hint in diagnostic.help]
    return "\n".join(rows)


def _something(text: str, start: int) -> int:
    """Return an end such that there is something to underline, on the same line."""
    return start + 1 if start < len(text) and text[start] != "\n" else start
