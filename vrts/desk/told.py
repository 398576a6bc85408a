"""What the page is told, in the words of its JSON. Points and marks as numbers, times in s."""

from msgspec import Struct

from vrts.marking.result import Check, Finding


class Likeness(Struct, frozen=True, rename={"with_": "with"}):
    """That a program is like others, with the strongest of its likenesses."""

    group: str
    strength: str
    with_: tuple[str, ...]
    score: float


class Doubted(Struct, frozen=True):
    """Why a mark is unsafe."""

    reason: str
    sentence: str


class Looked(Struct, frozen=True):
    """That a grader is finished with a row."""

    who: str
    mark: float | None
    stale: bool  # another program was marked since, or another mark would be given now


class RowTold(Struct, frozen=True):
    """A row of the work list."""

    id: str
    name: str
    final: float | None
    computed: float | None
    total: float
    kind: str
    unsafe: tuple[Doubted, ...]
    ready: bool
    cause: str
    line: int | None
    time_s: float | None
    causes: tuple[str, ...]
    late: str
    deduction: float
    due: str | None
    likeness: Likeness | None
    assigned: tuple[str, ...]
    finished: tuple[Looked, ...]
    comments: int
    items: tuple[str, ...]
    change: float | None
    excused: bool
    conflict: bool
    report: bool
    order: int
    why_next: str
    set_by: tuple[str, ...] = ()  # whose marks by hand take the place of the computed one: ids
    own: float | None = None  # what whoever asks would give alone; else the final mark
    alone: bool = False  # whether what other graders think of it is hidden
    otherwise: str = ""  # that all finished with one mark which is not the final one


class VersionTold(Struct, frozen=True):
    """What somebody has made of a rubric item."""

    record: str
    who: str
    name: str
    at: str
    title: str
    points: float
    withdrawn: bool
    undone_by: str | None


class ItemTold(Struct, frozen=True):
    """A rubric item."""

    id: str
    title: str
    points: float
    version: str  # "" where every version is undone
    students: tuple[str, ...]
    withdrawn: bool
    versions: tuple[VersionTold, ...] = ()  # the first one first


class CauseTold(Struct, frozen=True):
    """Rows that lost the same points in the same way."""

    key: str
    kind: str
    check: str
    sentence: str
    points: float
    count: int
    students: tuple[str, ...]


class Side(Struct, frozen=True):
    """One side of a conflict."""

    record: str
    who: str
    at: str
    sentence: str


class ConflictTold(Struct, frozen=True):
    """What graders decided differently."""

    id: str
    about: str
    student: str
    sentence: str
    sides: tuple[Side, ...]


class GraderTold(Struct, frozen=True):
    """Somebody who marks."""

    id: str
    name: str


class MarkingTold(Struct, frozen=True):
    """How far marking again is."""

    running: bool = False
    done: int = 0
    all: int = 0
    problem: str | None = None


class ClassTold(Struct, frozen=True):
    """A class, for the first screen."""

    title: str
    total: float
    revision: str
    me: GraderTold
    graders: tuple[GraderTold, ...]
    rows: tuple[RowTold, ...]
    items: tuple[ItemTold, ...]
    causes: tuple[CauseTold, ...]
    conflicts: tuple[ConflictTold, ...]
    marking: MarkingTold
    retrieved: str  # when the class was marked, ISO 8601
    problems: tuple[str, ...]  # files that cannot be read, in sentences


class CommentTold(Struct, frozen=True):
    """A comment."""

    record: str
    who: str
    name: str
    at: str
    line: int | None
    time_s: float | None
    text: str
    private: bool
    stale: bool
    mine: bool


class GivenTold(Struct, frozen=True):
    """A rubric item that a row has."""

    record: str
    item: str
    who: str
    at: str
    line: int | None
    time_s: float | None
    students: tuple[str, ...]  # who got it by the same record


class ChangeTold(Struct, frozen=True):
    """A change of the mark by hand."""

    record: str
    who: str
    at: str
    delta: float | None
    mark: float | None
    reason: str


class HistoryTold(Struct, frozen=True):
    """Something that was decided about a row, whether it counts or not."""

    record: str
    who: str
    name: str
    at: str
    sentence: str
    undone_by: str | None
    students: int  # whom it is about
    at_once: tuple[str, ...] = ()  # records that count and say the same of others, by one deed
    undone: int = 0  # records that the undo of this one has undone


class SourceTold(Struct, frozen=True):
    """A program as it was handed in."""

    name: str
    lines: tuple[str, ...]


class LossTold(Struct, frozen=True):
    """Points lost to one cause."""

    points: float
    kind: str
    sentence: str
    hint: str | None
    line: int | None
    time_s: float | None
    cause: str


class StepTold(Struct, frozen=True):
    """What lies between the computed mark and the final one."""

    points: float
    title: str
    sentence: str


class Attempt(Struct, frozen=True):
    """A hand-in of a student."""

    at: str | None
    mark: float | None
    file: str


class OneRow(Struct, frozen=True):
    """Everything about one row."""

    row: RowTold
    source: SourceTold | None
    source_problem: str | None  # why there is none to show
    losses: tuple[LossTold, ...]
    checks: tuple[Check, ...]
    findings: tuple[Finding, ...]
    steps: tuple[StepTold, ...]
    comments: tuple[CommentTold, ...]
    given: tuple[GivenTold, ...]
    changes: tuple[ChangeTold, ...]
    history: tuple[HistoryTold, ...]
    report: str | None
    sent: str | None
    attempts: tuple[Attempt, ...]


class AddedTold(Struct, frozen=True):
    """What became of decisions that were added."""

    revision: str
    added: tuple[str, ...]  # names of the records
    rows: tuple[RowTold, ...]  # of which more has changed than their place
    items: tuple[ItemTold, ...]
    conflicts: tuple[ConflictTold, ...]
