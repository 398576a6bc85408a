"""One row of a class's marks: a result, whose it is, and what lateness and people make of it."""

from collections import Counter
from collections.abc import Iterable
from fractions import Fraction
from typing import Annotated, Literal

import msgspec
from msgspec import Meta, field

from vrts.check.rules.scheme import TOTAL
from vrts.check.task.score import to_tenth
from vrts.marking.result import Damaged, Digest, Exact, Mark, Record, Result, check_mark, decoded
from vrts.marking.unsafe import ALL, Doubt, Reason, doubts, in_order

CLASS_SCHEMA = "vrts.class/1"
BEST_OF = "the best of"  # begins `why` of a hand-in that was chosen among several by its mark
OF_SEVERAL = "hand-ins count"  # in `why` of an exam: so many of so many do
OF_SESSION = "the last session of the room in which something was done"  # `why` of a hand-in
LARGEST = 512_000_000  # bytes of the rows of a class


class Student(Record, frozen=True):
    """Whose submission it is, as far as the platform or the file name tells."""

    name: str = ""
    email: str = ""
    login: str = ""
    ids: Annotated[dict[str, str], Meta(description="by platform")] = field(default_factory=dict)


class MarkedAttempt(Record, frozen=True):
    """One of several hand-ins, which were all marked, as the best of them counts."""

    file: Annotated[str, Meta(description="as the file that counts is called")]
    received: Annotated[str | None, Meta(description="ISO 8601, by the platform")] = None
    mark: Annotated[Mark | None, Meta(description="as computed, before lateness")] = None


class HandedIn(Record, frozen=True):
    """What was handed in, and why it is the one that was marked."""

    file: Annotated[str, Meta(description="in the download; `a.zip!b.v2` for a file in a zip")] = ""
    why: str = ""
    received: Annotated[str | None, Meta(description="ISO 8601, by the platform")] = None
    attempt: int | None = None
    doubts: Annotated[
        tuple[Doubt, ...], Meta(description="why another attempt may be what counts")
    ] = ()
    due: Annotated[
        str | None, Meta(description="own deadline by which it was chosen, ISO 8601; null: none")
    ] = None
    attempts: Annotated[
        tuple[MarkedAttempt, ...],
        Meta(description="in order, where the best of several counts; none: not all were marked"),
    ] = ()


class Lateness(Record, frozen=True):
    """What a task's rules take off for lateness."""

    by_s: Annotated[int, Meta(description="after the time it was due")]
    deduction: Exact
    sentence: str
    review: Annotated[bool, Meta(description="somebody has to look when it came")] = False
    untimed: Annotated[bool, Meta(description="not even whether it was late is known")] = False


class Change(Record, frozen=True):
    """A change of the mark by hand."""

    delta: Exact
    reason: str
    who: str
    date: Annotated[str, Meta(description="ISO 8601")]
    settles: Annotated[
        tuple[str, ...], Meta(description="reasons of doubt that it decides; `all`: every one")
    ] = ()


class Told(Record, frozen=True, omit_defaults=True):
    """Words of a grader about a program, for its student."""

    text: str
    who: str
    line: int | None = None
    time_s: Annotated[float | None, Meta(description="in the run")] = None


class Given(Record, frozen=True, omit_defaults=True):
    """A rubric item that a student has."""

    item: str
    title: str
    points: Annotated[Exact, Meta(description="added to the mark; negative: taken off")]
    who: str
    places: Annotated[
        tuple[tuple[int | None, float | None], ...], Meta(description="line, and s in the run")
    ] = ()


class MadeStep(Record, frozen=True):
    """A part of the change by hand; the parts add up to it."""

    title: str
    delta: Exact
    sentence: str


class Decided(Record, frozen=True, omit_defaults=True):
    """What graders have decided about a submission; nothing that is for those who mark only."""

    comments: tuple[Told, ...] = ()
    items: tuple[Given, ...] = ()
    steps: tuple[MadeStep, ...] = ()
    due: Annotated[str, Meta(description="a later deadline, ISO 8601")] = ""
    excused: Annotated[str, Meta(description="why no mark is expected, and who says so")] = ""
    conflicts: Annotated[
        tuple[str, ...], Meta(description="what graders have decided differently")
    ] = ()
    lapsed: Annotated[tuple[str, ...], Meta(description="decided about another program")] = ()
    again: Annotated[
        str, Meta(description="why another attempt may count by the later deadline")
    ] = ""
    late: Annotated[
        Lateness | None, Meta(description="what lateness would be without the later deadline")
    ] = None
    result: Annotated[
        Result | None, Meta(description="what was found out about somebody who is excused")
    ] = None


class Row(Record, frozen=True):
    """A submission in the list of marks: computed mark, deduction, change by hand, final mark."""

    id: str
    student: Student
    handed_in: HandedIn
    result: Result
    late: Lateness | None = None
    change: Change | None = None
    final: Annotated[Mark | None, Meta(description="null: there is no mark")] = None
    unsafe: Annotated[
        tuple[Doubt, ...], Meta(description="why nobody should take the mark for final")
    ] = ()
    decided: Annotated[Decided | None, Meta(description="by graders; null: nothing")] = None

    @property
    def exact_final(self) -> Fraction | None:
        """The final mark, a multiple of a tenth."""
        return None if self.final is None else Fraction(round(self.final * 10), 10)

    @property
    def of_session(self) -> bool:
        """Whether it is a session of the live server, for which nobody handed in a file."""
        return self.handed_in.why == OF_SESSION


class CountedFile(Record, frozen=True):
    """How much of a grader's file the lists rest on: lines are only ever added to it."""

    grader: Annotated[str, Meta(description="id")]
    lines: Annotated[int, Meta(ge=1)]
    sha256: Annotated[Digest, Meta(description="of these lines, each with one line feed")]


class Class(Record, frozen=True):
    """All rows of one marking."""

    schema: Literal["vrts.class/1"]
    title: str
    rows: tuple[Row, ...]
    unsafe: Annotated[
        dict[str, int] | None,
        Meta(description="how many marks are unsafe, by reason; null: an earlier vrts wrote it"),
    ] = None
    decisions: Annotated[
        tuple[CountedFile, ...], Meta(max_length=100, description="graders' files that count in it")
    ] = ()

    @property
    def total(self) -> Fraction:
        """How many points its marks are out of."""
        return max((row.result.exact_total for row in self.rows), default=TOTAL)


def row_of(
    result: Result,
    student: Student,
    handed_in: HandedIn,
    late: Lateness | None = None,
    change: Change | None = None,
    decided: Decided | None = None,
) -> Row:
    """Return the row of a result; its final mark is computed here and nowhere else.

    What makes the mark unsafe is put beside it.
    """
    final = final_mark(result.exact_mark, late, change, result.exact_total)
    return Row(
        result.id,
        student,
        handed_in,
        result,
        late,
        change,
        None if final is None else float(final),
        _doubts(result, handed_in, late, change, decided),
        decided,
    )


def _doubts(
    result: Result,
    handed_in: HandedIn,
    late: Lateness | None,
    change: Change | None,
    decided: Decided | None,
) -> tuple[Doubt, ...]:
    untimed = late.sentence if late is not None and late.review else ""
    settled = () if change is None else change.settles
    found = doubts(result, untimed=untimed, settled=settled)
    if handed_in.doubts and ALL not in settled:
        others = (doubt for doubt in handed_in.doubts if doubt.reason.value not in settled)
        found = in_order((*found, *others))
    if decided is None:
        return found
    if decided.again and not {ALL, Reason.LATE.value}.intersection(settled):
        found = in_order((*found, Doubt(Reason.LATE, decided.again)))
    if not (decided.conflicts or decided.lapsed):
        return found
    of_graders = (
        *(Doubt(Reason.CONFLICT, text) for text in decided.conflicts),
        *(Doubt(Reason.LAPSED, text) for text in decided.lapsed),
    )
    return in_order((*found, *of_graders))


def unsafe_first(rows: Iterable[Row]) -> tuple[Row, ...]:
    """Return rows with those first whose marks are unsafe, otherwise in their order."""
    return tuple(sorted(rows, key=lambda row: not row.unsafe))


def counted(rows: Class) -> Class:
    """Return a class that tells how many marks are unsafe, with these rows first."""
    reasons = Counter(reason for row in rows.rows for reason in {d.reason for d in row.unsafe})
    counts = {reason.value: reasons[reason] for reason in Reason if reasons[reason]}
    return msgspec.structs.replace(rows, rows=unsafe_first(rows.rows), unsafe=counts)


def final_mark(
    mark: Fraction | None,
    late: Lateness | None,
    change: Change | None,
    total: Fraction = TOTAL,
) -> Fraction | None:
    """Return a mark after deduction and change, from 0 to the total, rounded half up to a tenth.

    A change by hand gives a mark also where none was computed.
    """
    if mark is None and change is None:
        return None
    value = mark or Fraction(0)
    if late is not None:
        value = max(Fraction(0), value - Fraction(late.deduction))
    if change is not None:
        value += Fraction(change.delta)
    return to_tenth(value, total)


def class_to_bytes(rows: Class, *, judged: bool = True) -> bytes:
    """Return the rows of a class as JSON, laid out for people: unsafe marks counted, and first.

    Args:
        rows: Of the class.
        judged: Whether all that may make a mark unsafe was looked at; else nothing is counted.
    """
    told = counted(rows) if judged else msgspec.structs.replace(counted(rows), unsafe=None)
    return msgspec.json.format(msgspec.json.encode(told), indent=1) + b"\n"


class _OnlyDecisions(msgspec.Struct, frozen=True):
    decisions: tuple[CountedFile, ...] = ()


def decisions_counted(data: bytes) -> tuple[CountedFile, ...]:
    """Return which graders' files count in rows; their rows are not looked at.

    Raises:
        Damaged: The bytes are no rows.
    """
    try:
        return msgspec.json.decode(data, type=_OnlyDecisions).decisions
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as problem:
        raise Damaged("it is no list of marks") from problem


def class_from_bytes(data: bytes) -> Class:
    """Return the rows of a class.

    Raises:
        Damaged: The bytes are no rows of this version.
    """
    if len(data) > LARGEST:
        raise Damaged(f"rows of {len(data):,} bytes")
    found = decoded(data, Class)
    for row in found.rows:
        check_mark(row.result, row.result.mark)
        check_mark(row.result, row.final)
    rows = tuple(
        msgspec.structs.replace(
            row, unsafe=_doubts(row.result, row.handed_in, row.late, row.change, row.decided)
        )
        for row in found.rows
    )  # as this vrts judges them, whoever wrote them
    judged = msgspec.structs.replace(found, rows=rows)
    return judged if found.unsafe is None else counted(judged)
