"""The results of a shard: one zip, made where the shard was marked.

It may come from anywhere and is read without trust: sizes are looked at before anything is
unpacked, no name in it becomes a path, and everything must fit together.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import BinaryIO, Literal, NamedTuple

import msgspec

from vrts.base.diagnostic import Rule, error
from vrts.base.zips import BadZip, Unpacker, packed
from vrts.marking.layout import LOST, RESULT, Layout
from vrts.marking.marking import Done
from vrts.marking.remote.names import Pseudonym
from vrts.marking.remote.shard import Number, PlanId, Shard
from vrts.marking.result import LARGEST, Damaged, Digest, Record, Result, from_bytes, to_bytes
from vrts.marking.submission.marker import STAFF, STUDENT, WRITTEN
from vrts.pipeline.refused import Refused

BAD_RESULTS = Rule("V722", "bad-results")

SCHEMA = "vrts.marked/1"
CONTENTS = "marked.json"
MODE = 0o600  # of members
LARGEST_CONTENTS = 8_000_000  # bytes
LARGEST_FILE = 64_000_000  # bytes of a page or a recording
LARGEST_ALL = 20_000_000_000  # bytes of everything in one zip, unpacked

_RESULTS = {STAFF: f"{STAFF}/{RESULT}", STUDENT: f"{STUDENT}/{RESULT}"}
_FILES = (*WRITTEN, f"{STAFF}/{LOST}")


class Used(Record, frozen=True):
    """What marking one submission took."""

    pseudonym: Pseudonym
    seconds: float
    peak: int  # bytes of memory in use


class Contents(Record, frozen=True):
    """What the zip is about."""

    schema: Literal["vrts.marked/1"]
    plan: PlanId
    number: Number  # of the shard
    shard: Digest
    rows: tuple[Used, ...]


class MarkedRow(NamedTuple):
    """One submission, under its pseudonym."""

    pseudonym: str
    staff: Result
    student: Result
    seconds: float
    peak: int


def results_zip(shard: Shard, digest: str, rows: Mapping[str, Done], layout: Layout) -> bytes:
    """Return the results of a shard and all files about it.

    Args:
        shard: That was marked.
        digest: Of its file.
        rows: Results by pseudonym.
        layout: Where marking wrote the files.
    """
    marked = [(piece.pseudonym, rows[piece.pseudonym]) for piece in shard.pieces]
    used = tuple(Used(name, round(done.seconds, 3), done.peak) for name, done in marked)
    contents = Contents(SCHEMA, shard.plan, shard.number, digest, used)
    members = {CONTENTS: msgspec.json.format(msgspec.json.encode(contents), indent=1) + b"\n"}
    for name, done in marked:
        members[f"{name}/{_RESULTS[STAFF]}"] = to_bytes(done.result)
        members[f"{name}/{_RESULTS[STUDENT]}"] = to_bytes(done.student)
        members |= {f"{name}/{file}": data for file, data in written(layout, name).items()}
    return packed(members, MODE)


def written(layout: Layout, identifier: str) -> dict[str, bytes]:
    """Return what marking wrote about a submission beside its results, by name in the zip."""
    homes = {STAFF: layout.grader(identifier), STUDENT: layout.student(identifier)}
    found: dict[str, bytes] = {}
    for name in _FILES:
        whose, file = name.split("/")
        place = homes[whose] / file
        if place.is_file():
            found[name] = place.read_bytes()
    return found


def is_of(path: Path, digest: str) -> bool:
    """Return whether a file holds the results of a shard, whole; `digest` is that of the shard."""
    try:
        with path.open("rb") as file:
            marked = MarkedShard(file, path.name)
            marked.rows()
    except Refused:
        return False
    return marked.contents.shard == digest


class MarkedShard:
    """The results of a shard, from its zip."""

    def __init__(self, source: bytes | BinaryIO, name: str) -> None:
        """Read the table of contents; `name` is what messages call the zip.

        Raises:
            Refused: It is no zip of results, or is damaged.
        """
        self.name = name
        try:
            self._archive = Unpacker(source)
        except BadZip as problem:
            raise self._bad("it is incomplete, or is no zip file") from problem
        self.contents = self._contents()
        self._check_names()

    def rows(self) -> list[MarkedRow]:
        """Return all results.

        Raises:
            Refused: One of them is damaged.
        """
        return [
            MarkedRow(
                row.pseudonym,
                self._result(row.pseudonym, STAFF),
                self._result(row.pseudonym, STUDENT),
                row.seconds,
                row.peak,
            )
            for row in self.contents.rows
        ]

    def files(self, pseudonym: str) -> dict[str, bytes]:
        """Return the files about a submission other than its results, by name in the zip.

        Raises:
            Refused: One of them is damaged.
        """
        found: dict[str, bytes] = {}
        for name in _FILES:
            if f"{pseudonym}/{name}" in self._archive.sizes:
                found[name] = self._read(f"{pseudonym}/{name}", LARGEST_FILE)
        return found

    def _contents(self) -> Contents:
        if CONTENTS not in self._archive.sizes:
            raise self._bad(f"there is no `{CONTENTS}` in it")
        try:
            return msgspec.json.decode(self._read(CONTENTS, LARGEST_CONTENTS), type=Contents)
        except msgspec.MsgspecError as problem:
            raise self._bad(f"its `{CONTENTS}` is not as vrts writes it") from problem

    def _check_names(self) -> None:
        names = [row.pseudonym for row in self.contents.rows]
        allowed = {f"{name}/{file}" for name in names for file in (*_RESULTS.values(), *_FILES)}
        strange = sorted(self._archive.sizes.keys() - allowed - {CONTENTS})
        if strange or len(set(names)) != len(names):
            raise self._bad("it holds what no marking has written")
        if sum(self._archive.sizes.values()) > LARGEST_ALL:
            raise self._bad(f"its files have more than {LARGEST_ALL:,} bytes")

    def _result(self, pseudonym: str, whose: str) -> Result:
        member = f"{pseudonym}/{_RESULTS[whose]}"
        if member not in self._archive.sizes:
            raise self._bad(f"`{member}` is missing in it")
        try:
            return from_bytes(self._read(member, LARGEST))
        except Damaged as problem:
            raise self._bad(f"`{member}` is no result") from problem

    def _read(self, member: str, most: int) -> bytes:
        if self._archive.sizes[member] > most:
            raise self._bad(f"`{member}` has more than {most:,} bytes")
        try:
            return self._archive.read(member)
        except BadZip as problem:
            raise self._bad(f"`{member}` is damaged") from problem

    def _bad(self, why: str) -> Refused:
        headline = f"`{self.name}` holds no results of a shard: {why}"
        remedy = "copy the file again from where it was made, or run the shard again"
        return Refused((error(BAD_RESULTS, headline, help=(remedy,)),))
