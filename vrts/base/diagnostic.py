"""What is wrong, where, why, and what to do about it.

A diagnostic is a value: rules make it, renderers in `report` and `cli` show it. Wording lives
beside the rule. Headlines are lower case without a full stop, say what is, and stand alone; the
remedy stands only in `help`.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum
from types import MappingProxyType
from typing import NamedTuple, TypeAlias

from vrts.base.source import Span

Datum: TypeAlias = "str | int | float | bool | tuple[Datum, ...] | None"

NO_DATA: Mapping[str, Datum] = MappingProxyType({})


class Severity(Enum):
    """How much a diagnostic weighs. Only errors make a check or a compilation fail."""

    ERROR = "error"
    WARNING = "warning"
    NOTE = "note"


class Rule(NamedTuple):
    """Identity of a kind of diagnostic. Codes are never reused; each has a page in `vrts/pages`."""

    code: str  # "V302"
    slug: str  # "joint-speed"


class Label(NamedTuple):
    """A place in the text and what is to be said there (may be empty)."""

    span: Span
    text: str = ""


class Moment(NamedTuple):
    """When and where in a run a finding holds."""

    time_s: float  # simulated time [s]
    configuration: tuple[float, ...]  # joint positions [rad], then hand opening [m]
    bodies: tuple[str, ...] = ()  # names of the bodies involved
    deepest: bool = False  # of a contact that began before


class Edit(NamedTuple):
    """A replacement of a piece of text."""

    span: Span
    replacement: str


class Fix(NamedTuple):
    """Replacements of text that together remove the cause: all of them, or none."""

    span: Span
    replacement: str
    more: tuple[Edit, ...] = ()  # further places, none overlapping another
    sure: bool = True  # whether it may be applied unasked: it is surely what was meant

    @property
    def edits(self) -> tuple[Edit, ...]:
        """All replacements."""
        return (Edit(self.span, self.replacement), *self.more)

    @classmethod
    def from_edits(cls, edits: Sequence[Edit], *, sure: bool = True) -> "Fix":
        """Return a fix of one or more replacements."""
        return cls(*edits[0], tuple(edits[1:]), sure)


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One cause, explained."""

    rule: Rule
    severity: Severity
    headline: str
    primary: Label | None = None
    secondary: tuple[Label, ...] = ()
    notes: tuple[str, ...] = ()
    help: tuple[str, ...] = ()
    fix: Fix | None = None
    moment: Moment | None = None
    data: Mapping[str, Datum] = field(default_factory=lambda: NO_DATA)  # exact values by name

    @property
    def is_error(self) -> bool:
        """Whether this diagnostic alone makes its stage fail."""
        return self.severity is Severity.ERROR


def error(rule: Rule, headline: str, primary: Label | None = None, **more: object) -> Diagnostic:
    """Return an error; `more` are further fields of `Diagnostic`."""
    return Diagnostic(rule, Severity.ERROR, headline, primary, **more)  # type: ignore[arg-type]


def warning(rule: Rule, headline: str, primary: Label | None = None, **more: object) -> Diagnostic:
    """Return a warning; `more` are further fields of `Diagnostic`."""
    return Diagnostic(rule, Severity.WARNING, headline, primary, **more)  # type: ignore[arg-type]
