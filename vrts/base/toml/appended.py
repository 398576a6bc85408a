"""Two TOML files read as one, the second at the end of the first; places stay in their own file."""

from dataclasses import replace

from vrts.base.diagnostic import Diagnostic, Label
from vrts.base.source import SourceFile, Span


class Appended:
    """A file with another one at its end."""

    def __init__(self, first: SourceFile, second: SourceFile) -> None:
        """Join two files; the whole has the name of the first."""
        self.first = first
        self.second = second
        self.joined = SourceFile(first.name, f"{first.text}\n{second.text}")

    def span(self, span: Span) -> Span:
        """Return a place of the whole in the file that it is in."""
        if span.source is not self.joined:
            return span
        start = len(self.first.text) + 1  # of the second file
        if span.start >= start:
            return Span(self.second, span.start - start, span.end - start)
        return Span(self.first, span.start, min(span.end, start - 1))

    def label(self, label: Label) -> Label:
        """Return a label with its place in the file that it is in."""
        return label._replace(span=self.span(label.span))

    def diagnostic(self, d: Diagnostic) -> Diagnostic:
        """Return a diagnostic of the whole with its places in the files that they are in."""
        primary = None if d.primary is None else self.label(d.primary)
        return replace(d, primary=primary, secondary=tuple(map(self.label, d.secondary)))
