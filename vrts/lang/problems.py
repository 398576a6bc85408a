"""Collects the diagnostics of one compilation."""

from collections.abc import Mapping

from vrts.base.diagnostic import NO_DATA, Datum, Diagnostic, Fix, Label, Rule, Severity
from vrts.base.source import SourceFile, Span
from vrts.lang.dialect import VAL2, Dialect
from vrts.lang.joined import order, span_in

TOO_MANY = Rule("V151", "too-many-problems")
LIMIT = 200  # that are shown
MOST_KEPT = 20_000  # errors, and as many others; of what is found beyond, only the number counts

_NOT_KEPT = {s: Diagnostic(TOO_MANY, s, "one more problem") for s in Severity}


class Problems:
    """Diagnostics of one source file, in the order they are found."""

    def __init__(self, source: SourceFile, dialect: Dialect = VAL2) -> None:
        self.source = source
        self.dialect = dialect
        self.found: list[Diagnostic] = []
        self.any_error = False
        self._room = {True: MOST_KEPT, False: MOST_KEPT}  # for errors, and for others
        self.look_alikes: list[tuple[str, int]] = []  # pasted characters and their offsets

    @classmethod
    def none(cls) -> "Problems":
        """Return a collection for text that stands in no file."""
        return cls(SourceFile("", ""))

    def span(self, start: int, end: int) -> Span:
        """Return a span of the source."""
        return span_in(self.source, start, end)

    def label(self, start: int, end: int, text: str = "") -> Label:
        """Return a label in the source."""
        return Label(span_in(self.source, start, end), text)

    def error(
        self,
        rule: Rule,
        headline: str,
        start: int,
        end: int,
        text: str = "",
        *,
        secondary: tuple[Label, ...] = (),
        notes: tuple[str, ...] = (),
        help: tuple[str, ...] = (),  # noqa: A002 - the field of Diagnostic
        fix: Fix | None = None,
        data: Mapping[str, Datum] = NO_DATA,
        severity: Severity = Severity.ERROR,
    ) -> None:
        """Add an error at a range of offsets."""
        primary = self.label(start, end, text)
        self.add(
            Diagnostic(rule, severity, headline, primary, secondary, notes, help, fix, None, data)
        )

    def add(self, diagnostic: Diagnostic) -> None:
        """Add a diagnostic; of those beyond what is kept, its severity."""
        is_error = diagnostic.is_error
        self.any_error = self.any_error or is_error
        self._room[is_error] -= 1
        full = self._room[is_error] < 0
        self.found.append(_NOT_KEPT[diagnostic.severity] if full else diagnostic)

    def warning(
        self,
        rule: Rule,
        headline: str,
        start: int,
        end: int,
        text: str = "",
        *,
        secondary: tuple[Label, ...] = (),
        notes: tuple[str, ...] = (),
        help: tuple[str, ...] = (),  # noqa: A002
        fix: Fix | None = None,
        data: Mapping[str, Datum] = NO_DATA,
    ) -> None:
        """Add a warning at a range of offsets."""
        self.error(
            rule,
            headline,
            start,
            end,
            text,
            secondary=secondary,
            notes=notes,
            help=help,
            fix=fix,
            data=data,
            severity=Severity.WARNING,
        )

    def note(
        self,
        rule: Rule,
        headline: str,
        start: int,
        end: int,
        *,
        help: tuple[str, ...] = (),  # noqa: A002
        data: Mapping[str, Datum] = NO_DATA,
    ) -> None:
        """Add a note at a range of offsets."""
        self.error(rule, headline, start, end, help=help, data=data, severity=Severity.NOTE)

    def forget(self, mark: int) -> None:
        """Take back what was reported after the first `mark`: there is something better to say."""
        for diagnostic in self.found[mark:]:
            self._room[diagnostic.is_error] += 1
        del self.found[mark:]

    @property
    def full(self) -> bool:
        """Whether further errors would not even be kept."""
        return self._room[True] < 0

    def replace(self, start: int, end: int, replacement: str, *, sure: bool = True) -> Fix:
        """Return a fix that replaces a range of the source."""
        return Fix(span_in(self.source, start, end), replacement, sure=sure)

    def in_order(self) -> tuple[Diagnostic, ...]:
        """Return the diagnostics by place, errors first on one place, at most `LIMIT` of them."""
        ordered = sorted(
            (d for d in self.found if d.rule is not TOO_MANY),
            key=lambda d: (order(self.source, d.primary), not d.is_error),
        )
        if len(ordered) <= LIMIT:
            return tuple(ordered)
        kept = _errors_first(ordered)
        more = len(self.found) - LIMIT
        worst = Severity.ERROR if self.any_error else Severity.WARNING
        rest = Diagnostic(
            TOO_MANY,
            worst,
            f"and {more:,} more problems",
            notes=(f"the first {LIMIT} are shown",),
            data={"more": more},
        )
        return (*kept, rest)


def _errors_first(ordered: list[Diagnostic]) -> list[Diagnostic]:
    """Keep at most LIMIT, errors rather than warnings, in their order."""
    errors = [i for i, d in enumerate(ordered) if d.is_error][:LIMIT]
    others = [i for i, d in enumerate(ordered) if not d.is_error][: LIMIT - len(errors)]
    return [ordered[i] for i in sorted(errors + others)]


def short(text: str) -> str:
    """Return a piece of a program as a message quotes it."""
    return text if len(text) <= 40 else text[:37] + "..."
