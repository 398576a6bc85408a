"""Collects what is wrong in one TOML file."""

from collections.abc import Mapping

from vrts.base.diagnostic import NO_DATA, Datum, Diagnostic, Fix, Label, Rule, Severity
from vrts.base.source import SourceFile, Span


class Problems:
    """Diagnostics of one file, in the order they are found."""

    def __init__(self, source: SourceFile) -> None:
        """Start without any."""
        self.source = source
        self.found: list[Diagnostic] = []

    def error(
        self,
        rule: Rule,
        headline: str,
        span: Span | None,
        text: str = "",
        *,
        secondary: tuple[Label, ...] = (),
        notes: tuple[str, ...] = (),
        help: tuple[str, ...] = (),  # noqa: A002 - the field of Diagnostic
        fix: Fix | None = None,
        data: Mapping[str, Datum] = NO_DATA,
        severity: Severity = Severity.ERROR,
    ) -> None:
        """Add an error at a place."""
        primary = None if span is None else Label(span, text)
        self.found.append(
            Diagnostic(rule, severity, headline, primary, secondary, notes, help, fix, None, data)
        )

    def warning(
        self,
        rule: Rule,
        headline: str,
        span: Span | None,
        text: str = "",
        *,
        secondary: tuple[Label, ...] = (),
        notes: tuple[str, ...] = (),
        help: tuple[str, ...] = (),  # noqa: A002
        data: Mapping[str, Datum] = NO_DATA,
    ) -> None:
        """Add a warning at a place."""
        self.error(
            rule,
            headline,
            span,
            text,
            secondary=secondary,
            notes=notes,
            help=help,
            data=data,
            severity=Severity.WARNING,
        )

    def withdraw(self, diagnostic: Diagnostic) -> None:
        """Take back a diagnostic, most likely one of the last."""
        for k in range(len(self.found) - 1, -1, -1):
            if self.found[k] is diagnostic:
                del self.found[k]
                return

    @property
    def any_error(self) -> bool:
        """Whether an error was found."""
        return any(diagnostic.is_error for diagnostic in self.found)

    def in_order(self) -> tuple[Diagnostic, ...]:
        """Return the diagnostics by place in the file, errors first on one place."""
        return tuple(
            sorted(
                self.found,
                key=lambda d: (d.primary.span.start if d.primary else 0, not d.is_error),
            )
        )
