"""A shard: some submissions of a class, with all that another machine needs to mark them.

It names nobody: submissions have pseudonyms, and of what was handed in only the program goes along.
Its secret signs its results.
"""

import hashlib
from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import Annotated, Literal, NamedTuple

import msgspec
from msgspec import Meta

from vrts import __version__
from vrts.base.diagnostic import Rule, error
from vrts.marking.marking import Entry
from vrts.marking.remote.names import Label, Naming, Pseudonym
from vrts.marking.remote.portable import PortableTask
from vrts.marking.remote.signed import Secret, secret_of_shard
from vrts.marking.result import Damaged, Digest, Record, decoded
from vrts.marking.submission.one import Wanted
from vrts.marking.supervise.limits import Limits
from vrts.pipeline.refused import Refused

BAD_SHARD = Rule("V720", "bad-shard")
OTHER_VRTS = Rule("V721", "shard-of-another-vrts")

SCHEMA = "vrts.shard/2"
UNSIGNED = "vrts.shard/1"  # of a vrts that signed nothing
LARGEST = 1_000_000_000  # bytes of a shard
PlanId = Annotated[str, Meta(pattern=r"^[0-9a-f]{16}$")]
Number = Annotated[int, Meta(ge=1, le=100_000)]
Tag = Annotated[str, Meta(pattern=r"^[a-z]{4}-[a-z]{4}$")]  # a name of files, too
NO_VARIANTS: Mapping[str, PortableTask] = MappingProxyType({})
NO_TAGS: Mapping[str, str] = MappingProxyType({})


class Piece(Record, frozen=True):
    """A submission in a shard."""

    pseudonym: Pseudonym
    label: Label
    program: bytes
    variant: str = ""  # tag of the variant that it is marked by; "": the task as it is


class Shard(Record, frozen=True):
    """What is written into the file; bytes are base64 there."""

    schema: Literal["vrts.shard/1", "vrts.shard/2"]
    plan: PlanId
    number: Number
    vrts: str  # the version that has to mark it
    task: PortableTask
    wanted: Wanted
    limits: Limits
    pieces: tuple[Piece, ...]
    secret: Secret | None = None  # signs the results; None: of a vrts that signed nothing
    variants: dict[Tag, PortableTask] = msgspec.field(
        default_factory=dict[Tag, PortableTask]
    )  # of those in it, where students have variants of their own

    @property
    def longest_s(self) -> float:
        """How long marking it may take at most: all processes end by force, twice."""
        return len(self.pieces) * 2 * (self.limits.wall_s + 30.0)


class Cut(NamedTuple):
    """A shard, and what of it stays at home."""

    number: int
    data: bytes
    names: tuple[Naming, ...]
    longest_s: float  # that marking it may take


class Job(NamedTuple):
    """What all shards of a plan have in common."""

    plan: str
    secret: Secret  # of the plan: it stays at home
    task: PortableTask
    wanted: Wanted
    limits: Limits
    variants: Mapping[str, PortableTask] = NO_VARIANTS  # by tag
    tags: Mapping[str, str] = NO_TAGS  # which is whose, by pseudonym


def cut(job: Job, entries: Sequence[tuple[Entry, Naming]], count: int) -> Iterator[Cut]:
    """Yield so many shards of nearly the same length, fewer where there are fewer entries."""
    count = min(count, len(entries))
    for k in range(count):
        part = entries[k * len(entries) // count : (k + 1) * len(entries) // count]
        pieces = [
            Piece(naming.pseudonym, naming.label, entry.data, job.tags.get(naming.pseudonym, ""))
            for entry, naming in part
            if entry.data is not None
        ]
        shard = Shard(
            SCHEMA,
            job.plan,
            k + 1,
            __version__,
            job.task,
            job.wanted,
            job.limits,
            tuple(pieces),
            secret_of_shard(job.secret, job.plan, k + 1),
            {p.variant: job.variants[p.variant] for p in pieces if p.variant},
        )
        data = msgspec.json.encode(shard) + b"\n"
        yield Cut(shard.number, data, tuple(naming for _, naming in part), shard.longest_s)


def part_of(whole: Cut, names: tuple[Naming, ...]) -> Cut:
    """Return a shard of our own with some of its submissions."""
    wanted = {naming.pseudonym for naming in names}
    shard = read_shard(whole.data)
    pieces = tuple(piece for piece in shard.pieces if piece.pseudonym in wanted)
    part = msgspec.structs.replace(shard, pieces=pieces)
    return Cut(whole.number, msgspec.json.encode(part) + b"\n", names, part.longest_s)


def read_shard(data: bytes) -> Shard:
    """Return the shard that a file holds.

    Raises:
        Refused: It is none, is damaged, or is for another version of vrts.
    """
    if len(data) > LARGEST:
        raise _bad(f"it has more than {LARGEST:,} bytes")
    try:
        shard = decoded(data, Shard)
    except Damaged as problem:
        raise _bad(str(problem)) from problem
    if (shard.secret is None) != (shard.schema == UNSIGNED):
        raise _bad("what signs its results is missing")
    if not {piece.variant for piece in shard.pieces} <= {"", *shard.variants}:
        raise _bad("a variant is missing")
    if len({piece.pseudonym for piece in shard.pieces}) != len(shard.pieces):
        raise _bad("a submission is in it twice")
    if shard.vrts != __version__:
        headline = f"the shard is for vrts {shard.vrts}, and this is vrts {__version__}"
        wheel = f"install the wheel of vrts {shard.vrts} here"
        remedy = f"{wheel}, or plan again with vrts {__version__}"
        raise Refused((error(OTHER_VRTS, headline, help=(remedy,)),))
    return shard


def digest_of(data: bytes) -> Digest:
    """Return what results name a shard by."""
    return hashlib.sha256(data).hexdigest()


def _bad(why: str) -> Refused:
    headline = f"this is no shard of a plan: {why[:200]}"
    remedy = "copy the file again from the folder that `vrts grade plan` wrote"
    return Refused((error(BAD_SHARD, headline, help=(remedy,)),))
