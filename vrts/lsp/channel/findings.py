"""What a verification in the background found, tied to places of the text that it read."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, Severity
from vrts.base.source import SourceFile
from vrts.lsp.answers.formatting import Edit
from vrts.lsp.documents.moved import Moved

MOST = 200  # findings that are told of one text


class Related(NamedTuple):
    """A place that has to do with a finding."""

    path: str
    start: int
    end: int
    text: str


class Mending(NamedTuple):
    """Edits after which a verification no longer has a finding: that was tried."""

    title: str
    edits: tuple[Edit, ...]


class Finding(NamedTuple):
    """One finding at a place of the text that was verified."""

    path: str  # of the text
    code: str
    severity: Severity
    message: str
    start: int
    end: int
    related: tuple[Related, ...] = ()
    mending: Mending | None = None
    scenario: str = ""  # the text of a file in which it happens; empty: it always does


class Found(NamedTuple):
    """A diagnostic of a run, and what was tried against it."""

    diagnostic: Diagnostic
    mending: Mending | None = None
    scenario: str = ""  # as of a finding


def told(
    found: Iterable[Found], path: str, header: Label | None, where: str = ""
) -> tuple[Finding, ...]:
    """Return findings as an editor shows them: the same at the same place once.

    Args:
        found: Diagnostics of the run, in the order in which they are told.
        path: Of the text that was verified.
        header: Of the program that was executed, where what has no place in this text is told;
            None: it stands in another file, and so does what is told there.
        where: In which scene, in words; empty: nothing was executed.
    """
    several: dict[tuple[str, int, str], list[Found]] = {}
    for one in found:
        primary = one.diagnostic.primary
        start = primary.span.start if primary is not None else -1
        same = (one.diagnostic.rule.code, start, one.diagnostic.headline)
        if header is not None or (primary is not None and primary.span.source.name == path):
            several.setdefault(same, []).append(one)
    return tuple(_told(same, path, header, where) for same in list(several.values())[:MOST])


def _told(same: Sequence[Found], path: str, header: Label | None, where: str) -> Finding:
    diagnostic, mending, scenario = same[0]
    if mending is not None:  # what was tried is better than what was estimated
        tried = mending.title[0].lower() + mending.title[1:]
        diagnostic = replace(diagnostic, help=(tried,))
    labels = [label for label in (diagnostic.primary, *diagnostic.secondary) if label is not None]
    here = diagnostic.primary
    severity = diagnostic.severity
    if here is None:
        severity = Severity.NOTE  # a goal that is not reached yet, while the program is written
    if here is None or here.span.source.name != path:
        assert header is not None
        here = header
    related = [
        Related(label.span.source.name, label.span.start, label.span.end, label.text or "see here")
        for label in labels
        if label.span != here.span
    ]
    text = in_words(diagnostic)
    if where:
        moment = diagnostic.moment
        at = "" if moment is None else f", at {moment.time_s:.3f} s"
        deepest = ", where it is deepest" if moment is not None and moment.deepest else ""
        often = f"; {len(same)} times" if len(same) > 1 else ""
        text += f"\nfound {where}{at}{deepest}{often}"
    code, span = diagnostic.rule.code, here.span
    place = path, code, severity, text, span.start, span.end
    return Finding(*place, tuple(related), mending, scenario)


def in_words(diagnostic: Diagnostic) -> str:
    """Return all that a diagnostic says but its places."""
    label = diagnostic.primary.text if diagnostic.primary is not None else ""
    rows = [diagnostic.headline + (f": {label}" if label else "")]
    rows += [f"note: {note}" for note in diagnostic.notes]
    rows += [f"help: {hint}" for hint in diagnostic.help]
    return "\n".join(rows)


def carried(
    findings: Iterable[Finding], before: SourceFile, after: SourceFile
) -> tuple[Finding, ...]:
    """Return findings of an earlier text where they are now; those of changed lines are gone.

    They may hold no longer, so they weigh little, say so, and offer nothing more.
    """
    moved = Moved(before, after).offset
    found: list[Finding] = []
    for finding in findings:
        start, end = moved(finding.start), moved(finding.end)
        if start is not None and end is not None:
            text = f"before the last change: {finding.message}"
            now = finding._replace(severity=Severity.NOTE, message=text, start=start, end=end)
            found.append(now._replace(related=(), mending=None, scenario=""))
    return tuple(found)
