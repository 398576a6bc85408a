"""What a grader can write down: one record a line, told apart by `does`.

A record is named `GRADER:NUMBER`, such as `huber:12`. In the file of one grader a later record
takes the place of an earlier one about the same thing; points add up. Between files nothing takes
the place of anything: what two graders decide differently is a conflict, until a `decide` or an
`undo` of somebody settles it.
"""

from typing import Annotated, Literal

import msgspec
from msgspec import Meta

from vrts.marking.result import Exact, Record

SCHEMA = "vrts.decisions/1"

Name = Annotated[
    str, Meta(pattern=r"^[a-z0-9][a-z0-9-]{0,39}:[1-9][0-9]{0,6}$", description="of a record")
]
Student = Annotated[str, Meta(min_length=1, max_length=200, description="id in the class")]
Students = Annotated[tuple[Student, ...], Meta(min_length=1, max_length=5000)]
Words = Annotated[str, Meta(min_length=1, max_length=2000)]
LineNumber = Annotated[int, Meta(ge=1, le=1_000_000)]
Time = Annotated[float, Meta(ge=0, le=1_000_000, description="s, in the run")]
Identifier = Annotated[str, Meta(pattern=r"^[a-z0-9][a-z0-9-]{0,39}$")]
Digest = Annotated[str, Meta(pattern=r"^([0-9a-f]{64}|none|)$", description="sha256 of a program")]
Digests = Annotated[
    dict[Student, Digest],
    Meta(max_length=5000, description="by student, of the program that was looked at"),
]
Points = Annotated[
    Exact, Meta(max_length=24, description="of at most 1000 points, with three decimals")
]


class Beginning(Record, frozen=True):
    """The first line of a file: whose it is."""

    schema: Literal["vrts.decisions/1"]
    id: Annotated[Identifier, Meta(description="the name of the file, without its ending")]
    grader: Annotated[str, Meta(min_length=1, max_length=200, description="as people call them")]


class Said(Record, frozen=True, tag_field="does", omit_defaults=True):
    """What every record has."""

    number: Annotated[int, Meta(ge=1, description="in its file, without gaps")]
    at: Annotated[str, Meta(max_length=40, description="ISO 8601, with offset")]


class Comment(Said, frozen=True, tag="comment"):
    """Words about a program, a line of it, or a moment of its run."""

    student: Student
    text: Words
    line: LineNumber | None = None
    time_s: Time | None = None
    program: Digest = ""
    private: Annotated[bool, Meta(description="for those who mark only")] = False


class Item(Said, frozen=True, tag="item"):
    """A rubric item: points for a reason, given to as many as have it. Later: changed for all."""

    id: Identifier
    title: Words
    points: Annotated[Points, Meta(description="added to the mark; negative: taken off")]
    after: Annotated[
        tuple[Name, ...],
        Meta(max_length=100, description="versions of the item that this one replaces"),
    ] = ()
    withdrawn: bool = False


class Give(Said, frozen=True, tag="give"):
    """A rubric item for students; `undo` takes it away."""

    item: Identifier
    students: Students
    line: LineNumber | None = None
    time_s: Time | None = None
    programs: Digests = msgspec.field(default_factory=dict)


class ChangeMark(Said, frozen=True, tag="change"):
    """Points added, or a mark in place of the computed one, as in `overrides.toml`."""

    students: Students
    reason: Words
    delta: Points | None = None
    mark: Points | None = None
    settles: Annotated[tuple[str, ...], Meta(max_length=20)] = ()
    programs: Digests = msgspec.field(default_factory=dict)


class Extend(Said, frozen=True, tag="extend"):
    """A later deadline for students."""

    students: Students
    due: Annotated[str, Meta(max_length=40, description="ISO 8601, with offset")]
    reason: Words


class Excuse(Said, frozen=True, tag="excuse"):
    """No mark is expected of these students."""

    students: Students
    reason: Words


class Assign(Said, frozen=True, tag="assign"):
    """Who is to look at these students; two graders: each by themselves, then compared."""

    students: Students
    graders: Annotated[tuple[Identifier, ...], Meta(max_length=10)]


class Finish(Said, frozen=True, tag="finish"):
    """The grader has looked at this, and would give this mark."""

    student: Student
    mark: Points | None
    program: Digest = ""


class Decide(Said, frozen=True, tag="decide"):
    """A conflict is settled: one record counts, the others do not."""

    keep: Name
    over: Annotated[tuple[Name, ...], Meta(min_length=1, max_length=100)]
    reason: Words
    students: Annotated[
        tuple[Student, ...],
        Meta(max_length=5000, description="for whom it is settled; none: all who share it"),
    ] = ()


class Undo(Said, frozen=True, tag="undo"):
    """Records that no longer count, one's own or another grader's."""

    records: Annotated[tuple[Name, ...], Meta(min_length=1, max_length=5000)]
    reason: Annotated[str, Meta(max_length=2000)] = ""


class Forgotten(Said, frozen=True, tag="forgotten"):
    """What was decided about somebody who was forgotten: nothing but its number is left."""


Decision = Comment | Item | Give | ChangeMark | Extend | Excuse | Assign | Finish | Decide | Undo
Line = Decision | Forgotten
