"""Changes of marks by hand: `overrides.toml` in `staff`, which marking reads and never writes over.

Every `[[change]]` names a student, and either `delta` (points to add) or `mark` (what the mark is
to be after lateness), with a reason, who decides, and when. `mark` settles whatever makes the mark
unsafe; `delta` what it names in `settles`, and nothing where there is no mark. Both settle that of
one `program` only. Those of one student are made in the order of the file. They stand beside the
computed mark, and survive marking again.
"""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from datetime import date
from difflib import get_close_matches
from fractions import Fraction
from types import MappingProxyType
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, Rule, warning
from vrts.base.source import SourceFile, Span
from vrts.base.toml.reading import Problems, Table, read_toml
from vrts.check.rules.scheme import TOTAL
from vrts.marking.result import Result
from vrts.marking.row import Change, Row
from vrts.marking.unsafe import ALL, SETTLED

CHANGE = Rule("V770", "change-by-hand")
UNKNOWN_STUDENT = Rule("V771", "unknown-student")
LAPSED = Rule("V774", "decision-lapsed")

LONGEST = 1000  # characters of a reason
NO_PROGRAM = "none"  # in place of the digest of one
LOOK_AGAIN = "look again, and decide with `vrts grade change`, or delete the change"


class Override(NamedTuple):
    """One change, as the file has it."""

    student: str
    delta: Fraction | None  # None: `mark` is given
    mark: Fraction | None
    reason: str
    who: str
    date: str  # ISO 8601
    settles: tuple[str, ...] = ()  # reasons why the mark was unsafe, or `all`
    program: str = ""  # sha256 of what it is about, or NO_PROGRAM; "": the file does not say


class Overrides(NamedTuple):
    """The changes of a class."""

    changes: Mapping[str, tuple[Override, ...]]  # by student, in the order of the file
    diagnostics: tuple[Diagnostic, ...] = ()

    @property
    def wrong(self) -> bool:
        """Whether the file has errors; nothing in it may be used then."""
        return any(diagnostic.is_error for diagnostic in self.diagnostics)


NONE = Overrides(MappingProxyType({}))


def read_overrides(
    source: SourceFile, known: Collection[str], total: Fraction = TOTAL
) -> Overrides:
    """Return the changes in a file.

    Args:
        source: Text of `overrides.toml`.
        known: Identifiers of the class; who is not among them is warned of.
        total: Marks of the class are out of so many points.
    """
    top, problems = read_toml(source)
    if top is None:
        return Overrides({}, problems.in_order())
    found: dict[str, tuple[Override, ...]] = {}
    seen: dict[Override, Span] = {}
    for table in top.tables("change"):
        override = _override(table, problems, known, float(total))
        if override is None:
            continue
        if override in seen:
            problems.error(
                CHANGE,
                f"the same change of `{override.student}` is there twice",
                table.span,
                "again here",
                secondary=(Label(seen[override], "first here"),),
                help=("delete one of them; two changes that are both meant differ in `reason`",),
            )
        seen.setdefault(override, table.span)
        found[override.student] = (*found.get(override.student, ()), override)
    top.finish()
    return Overrides({} if problems.any_error else found, problems.in_order())


def _override(
    table: Table, problems: Problems, known: Collection[str], total: float
) -> Override | None:
    student = table.string("student", required=True)
    delta = table.fraction("delta", minimum=-total, maximum=total)
    mark = table.fraction("mark", minimum=0, maximum=total)
    reason = _words(table, problems, "reason")
    who = _words(table, problems, "who")
    day = _date(table, problems)
    program = _program(table, problems)
    settles = table.strings("settles") or ()
    for text in settles:
        if text not in (*SETTLED, ALL):
            problems.error(
                CHANGE,
                f"`{text}` is no reason why a mark is unsafe",
                table.value_span("settles"),
                help=(f"write one of {', '.join(SETTLED)}, or {ALL}",),
            )
    table.finish()
    given = [key for key in ("delta", "mark") if key in table]
    if len(given) != 1:
        problems.error(
            CHANGE,
            "a change has either `delta` or `mark`" + (", not both" if given else ""),
            table.span_of("mark"),
            help=("`delta` is added to the mark; `mark` takes its place",),
        )
        return None
    if student is not None and student not in known:
        close = get_close_matches(student, known, 1, 0.6)
        problems.warning(
            UNKNOWN_STUDENT,
            f"there is no student `{student}` in this class",
            table.value_span("student"),
            notes=("this change has no effect",),
            help=(f"did you mean `{close[0]}`?",) if close else (),
        )
    if student is None or reason is None or who is None or day is None:
        return None
    if delta is None and mark is None:
        return None
    return Override(student, delta, mark, reason, who, day, tuple(settles), program)


def _program(table: Table, problems: Problems) -> str:
    text = table.string("program") or ""
    if text and text != NO_PROGRAM and not re.fullmatch("[0-9a-f]{64}", text):
        problems.error(
            CHANGE,
            "`program` is no sha256",
            table.value_span("program"),
            help=(f"write that of the program, 64 digits, or `{NO_PROGRAM}`",),
        )
    return text


def _words(table: Table, problems: Problems, key: str) -> str | None:
    text = table.string(key, required=True)
    if text is None:
        return None
    if not text.strip() or len(text) > LONGEST:
        what = "is empty" if not text.strip() else f"has more than {LONGEST} characters"
        problems.error(CHANGE, f"`{key}` {what}", table.value_span(key))
        return None
    return text.strip()


def _date(table: Table, problems: Problems) -> str | None:
    text = table.string("date", required=True)
    if text is None:
        return None
    try:
        date.fromisoformat(text)
    except ValueError:
        problems.error(
            CHANGE,
            f"`{text}` is no date",
            table.value_span("date"),
            help=('write such as "2026-11-30"',),
        )
        return None
    return text


def change_of(
    after_lateness: Fraction | None, overrides: Iterable[Override], about: Result | None = None
) -> Change | None:
    """Return what changes by hand come to, made one after the other; None where there are none.

    Args:
        after_lateness: The mark before they are made; None counts as 0.
        overrides: Of one student.
        about: The result that they change; None: nothing is settled.
    """
    before = value = after_lateness or Fraction(0)
    made = tuple(overrides)
    if not made:
        return None
    for override in made:
        if override.mark is not None:
            value = override.mark
        else:
            assert override.delta is not None
            value += override.delta
    return Change(
        str(value - before),
        "; ".join(override.reason for override in made),
        ", ".join(dict.fromkeys(override.who for override in made)),
        made[-1].date,
        () if about is None else settled_by(made, about),
    )


def settled_by(made: Iterable[Override], result: Result) -> tuple[str, ...]:
    """Return what changes decide of what made a mark unsafe: a mark in its place, everything."""
    held = (one for one in made if not _flaw(one, result))
    found = (text for one in held for text in ((ALL,) if one.mark is not None else one.settles))
    return tuple(dict.fromkeys(found))


def program_of(result: Result) -> str:
    """Return how a change names the program that it is about."""
    return NO_PROGRAM if result.program is None else result.program.sha256


def _flaw(override: Override, result: Result) -> str:
    """Return why a change does not settle for a result what it says; "" where it does."""
    if override.mark is None and result.mark is None:
        return "where there is no mark only `mark` decides"
    if override.program:
        same = override.program == program_of(result)
        return "" if same else "it was decided about another program"
    if override.mark is not None:
        return ""
    return f'it does not say about which program: write `program = "{program_of(result)}"`'


def lapses(rows: Sequence[Row], overrides: Overrides) -> tuple[Diagnostic, ...]:
    """Return warnings of changes by hand that no longer settle what they say.

    Args:
        rows: With these changes.
        overrides: Of the class.
    """
    return tuple(
        warning(LAPSED, f"`{row.id}`: {what}", notes=(why,), help=(LOOK_AGAIN,))
        for row in rows
        for what, why in _lapsed(row, overrides.changes.get(row.id, ()))
    )


def _lapsed(row: Row, made: Sequence[Override]) -> Iterator[tuple[str, str]]:
    """Yield what lapsed, and why, unless something later has decided it."""
    given = (k for k, one in enumerate(made) if one.mark is not None and not _flaw(one, row.result))
    open_now = {doubt.reason.value for doubt in row.unsafe}
    for one in made[max(given, default=-1) + 1 :]:
        why = _flaw(one, row.result)
        if why and one.mark is not None:
            yield f"the mark of {one.date} by {one.who} counts, and settles nothing", why
        elif why and (open_now.intersection(one.settles) or (open_now and ALL in one.settles)):
            yield f"the change of {one.date} by {one.who} settles nothing", why
