"""The result of one submission: the published schema that every list, export and appeal reads.

A result is a function of the program's bytes, the task with its scene and scenario, and the
versions of vrts and of the scoring: `key` is the digest of these. It names nobody; who handed the
program in, when, and what that changes, stands beside it in a `Row`. Times in s, lengths in mm,
rounded by the shared rule; points exactly, as fractions, and as numbers.
"""

import hashlib
from enum import Enum
from fractions import Fraction
from typing import Annotated, Literal, TypeVar

import msgspec
from msgspec import Meta, Struct

from vrts.base.diagnostic import Severity
from vrts.check.rules.scheme import LARGEST_TOTAL
from vrts.check.verdicts.every_future import CHECK

SCHEMA = "vrts.result/1"
SCORING = (
    2  # version of how marks are made of verdicts: raised when the same run may mark otherwise
)
LARGEST = 8_000_000  # bytes of a result

PROVEN = "every future"  # in what a program is ready
SHOWN = "the scenario of its task"


class Kind(Enum):
    """What became of a submission."""

    GRADED = "graded"
    DOES_NOT_COMPILE = "does not compile"
    STOPPED = "stopped by an error"
    LIMIT = "stopped by a limit"
    UNREADABLE = "unreadable"  # for anybody: no text, empty, too large
    RESOURCE = "resource"  # the process was ended; never a mark
    AMBIGUOUS = "ambiguous"  # nobody can tell which file is meant
    UNREAD = "not read"  # this machine could not read the file
    MISSING = "missing"  # nothing handed in
    EXCUSED = "excused"  # by the teacher
    FAULT = "fault"  # of vrts itself


T = TypeVar("T")

UNMARKED = frozenset(
    {Kind.RESOURCE, Kind.AMBIGUOUS, Kind.UNREAD, Kind.MISSING, Kind.EXCUSED, Kind.FAULT}
)

Points = Annotated[float, Meta(description="points, rounded to six decimals")]
Mark = Annotated[float, Meta(ge=0, le=LARGEST_TOTAL, description="a multiple of 0.1")]
Exact = Annotated[str, Meta(pattern=r"^-?\d+(/\d+)?$", description="the same as a fraction")]
Digest = Annotated[str, Meta(pattern=r"^[0-9a-f]{64}$", description="sha256")]


class Record(Struct, frozen=True, forbid_unknown_fields=True):
    """A part of the schema: nothing else may stand in it."""


class Loss(Record, frozen=True):
    """Points lost to one cause."""

    points: Points
    points_exact: Exact
    kind: str
    sentence: str
    hint: str | None
    line: int | None
    time_s: float | None


class Check(Record, frozen=True):
    """One thing that was asked for, and what it earned."""

    id: str
    title: str
    kind: str
    answer: Literal["holds", "violated", "undetermined", "not reached"]
    points: Points
    most: Annotated[float, Meta(description="points at most; 0: it can only cost")]
    hidden: Annotated[bool, Meta(description="students see it after marking only")]
    message: str


class Parts(Record, frozen=True, omit_defaults=True):
    """The parts of the mark, which add up to it; what is taken off counts negative."""

    targets: Points
    vias: Points
    contacts: Points
    demands: Points
    time: Points
    limits: Annotated[float, Meta(description="for breaking limits of the robot")] = 0.0


class Finding(Record, frozen=True):
    """What the compiler, the run or a check said."""

    code: str
    slug: str
    severity: Severity
    headline: str
    line: int | None
    column: int | None
    time_s: float | None
    help: tuple[str, ...]


class Metrics(Record, frozen=True):
    """Numbers of the run; null: there are none."""

    duration_s: float | None = None
    horizon_s: float | None = None
    motions: int | None = None
    contacts: int | None = None
    near_misses: int | None = None
    clearance_mm: float | None = None


class Named(Record, frozen=True):
    """A task or a scene, and the digest of everything in it."""

    name: str
    title: str
    sha256: Digest


class Program(Record, frozen=True):
    """What was marked."""

    name: str
    sha256: Digest
    size: Annotated[int, Meta(description="bytes")]


class Versions(Record, frozen=True):
    """With which the result was made."""

    vrts: str
    scoring: int
    engine: Annotated[str | None, Meta(description="what measured distances")]


class Mending(Record, frozen=True):
    """What would earn the full mark; for those who mark, where they ask for it."""

    cause: Annotated[str, Meta(description="what is wrong, in words that others share")]
    sentence: str
    lines: tuple[int, ...]
    changes: Annotated[int, Meta(description="how many mistakes that mends")]
    executions: Annotated[int, Meta(description="how often a changed program was executed")]
    mark: Annotated[
        float | None, Meta(description="what it would earn: the full mark, or more")
    ] = None


class OfVariant(Record, frozen=True, omit_defaults=True):
    """Which variant of its task a program was marked by."""

    tag: Annotated[str, Meta(description="what the variant is called; empty: the task as written")]
    doubt: Annotated[str, Meta(description="why it may be the wrong one; for those who mark")] = ""


class Result(Record, frozen=True, omit_defaults=True):
    """What vrts found out about one submission."""

    schema: Literal["vrts.result/1"]
    id: str
    kind: Annotated[Kind, Meta(description="what became of it")]
    mark: Annotated[Mark | None, Meta(description="null: there is no mark")]
    lowest: Annotated[Mark | None, Meta(description="the mark if all in doubt went wrong")]
    review: Annotated[tuple[str, ...], Meta(description="why somebody has to look at it")]
    ready: Annotated[bool, Meta(description="for the real robot")]
    obstacles: tuple[str, ...]
    cause: str
    hint: str | None
    line: int | None
    time_s: float | None
    parts: Parts | None
    losses: tuple[Loss, ...]
    checks: tuple[Check, ...]
    metrics: Metrics
    findings: tuple[Finding, ...]
    stamps: Annotated[tuple[str, ...], Meta(description="why this mark does not count")]
    more: Annotated[int, Meta(description="checks that will be added at marking")]
    task: Named
    scene: Named
    program: Program | None
    versions: Versions
    key: Digest
    controller: Annotated[
        Named | None, Meta(description="model that the run went by; null: vrts-1, the first")
    ] = None
    total: Annotated[Mark, Meta(description="the mark is out of so many points")] = 10.0
    mending: Mending | None = None
    variant: Annotated[
        OfVariant | None, Meta(description="of a task that is another for each student")
    ] = None

    @property
    def exact_total(self) -> Fraction:
        """How many points the mark is out of."""
        return Fraction(round(self.total * 10), 10)

    @property
    def exact_mark(self) -> Fraction | None:
        """The mark, a multiple of a tenth."""
        return None if self.mark is None else Fraction(round(self.mark * 10), 10)

    @property
    def ready_in(self) -> str:
        """In what a program is ready: only a proof speaks of more than was executed."""
        proven = any(one.id == CHECK and one.answer == "holds" for one in self.checks)
        return PROVEN if proven else SHOWN

    @property
    def is_fault(self) -> bool:
        """Whether vrts itself failed."""
        return self.kind is Kind.FAULT


class Damaged(ValueError):  # noqa: N818 -- names the situation
    """Bytes are no result of this version."""


def to_bytes(result: Result) -> bytes:
    """Return a result as JSON, laid out for people, the same bytes for the same result."""
    return msgspec.json.format(msgspec.json.encode(result), indent=1) + b"\n"


def from_bytes(data: bytes) -> Result:
    """Return the result that JSON stands for.

    Raises:
        Damaged: It is no result, or one of another version.
    """
    if len(data) > LARGEST:
        raise Damaged(f"a result of {len(data):,} bytes")
    found = decoded(data, Result)
    check_mark(found, found.mark)
    return found


def decoded(data: bytes, kind: type[T]) -> T:
    """Return what JSON from anywhere stands for.

    Raises:
        Damaged: It is nothing of this kind.
    """
    try:
        return msgspec.json.decode(data, type=kind)
    except (msgspec.MsgspecError, UnicodeDecodeError) as problem:  # text may have any bytes in it
        raise Damaged(str(problem)) from problem


def check_mark(result: Result, mark: float | None) -> None:
    """Check that a mark is not more than there are points.

    Raises:
        Damaged: It is more.
    """
    if mark is not None and mark > result.total:
        raise Damaged(f"a mark of {mark:g} of {result.total:g}")


def key_of(program: bytes, *depends_on: str) -> str:
    """Return the digest of what a result depends on: the program's bytes and everything named."""
    whole = hashlib.sha256(hashlib.sha256(program).digest())
    for part in depends_on:
        whole.update(hashlib.sha256(part.encode()).digest())
    return whole.hexdigest()
