"""Diagnostics as the protocol has them."""

from collections.abc import Callable
from importlib.resources import files

from lsprotocol import types
from pygls.uris import from_fs_path

from vrts.base.diagnostic import Diagnostic, Severity
from vrts.lang.findings.usage import UNUSED_NAME
from vrts.lsp.channel.findings import Finding, in_words
from vrts.lsp.server.places import Places

VERIFICATION = "vrts verify"  # where a diagnostic comes from that concerns a run
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
    return types.Diagnostic(
        places.range(start, end),
        in_words(diagnostic),
        SEVERITIES[diagnostic.severity],
        code=diagnostic.rule.code,
        code_description=page_of(diagnostic.rule.code),
        source="vrts",
        tags=[types.DiagnosticTag.Unnecessary] if diagnostic.rule == UNUSED_NAME else None,
        related_information=related or None,
    )


def converted_finding(
    finding: Finding,
    uri: str,
    places: Places,
    others: Callable[[str], tuple[str, Places] | None],
    scenario: types.DiagnosticRelatedInformation | None = None,
) -> types.Diagnostic:
    """Return what a verification has found.

    Args:
        finding: In one buffer.
        uri: Of the buffer.
        places: Of the buffer.
        others: Address and places of another file by its path; None: it is gone.
        scenario: A file in which it happens.
    """
    related: list[types.DiagnosticRelatedInformation] = []
    for place in finding.related:
        there = (uri, places) if place.path == finding.path else others(place.path)
        if there is not None:
            where = types.Location(there[0], there[1].range(place.start, place.end))
            related.append(types.DiagnosticRelatedInformation(where, place.text))
    if scenario is not None:
        related.append(scenario)
    end = finding.end
    if finding.start == end:
        end = _something(places.source.text, end)
    return types.Diagnostic(
        places.range(finding.start, end),
        finding.message,
        SEVERITIES[finding.severity],
        code=finding.code,
        code_description=page_of(finding.code),
        source=VERIFICATION,
        related_information=related or None,
    )


def page_of(code: str) -> types.CodeDescription | None:
    """Return the link to the explanation of a code."""
    page = from_fs_path(str(files("vrts") / "pages" / f"{code}.md"))
    return types.CodeDescription(page) if page else None


def _something(text: str, start: int) -> int:
    """Return an end such that there is something to underline, on the same line."""
    return start + 1 if start < len(text) and text[start] != "\n" else start
