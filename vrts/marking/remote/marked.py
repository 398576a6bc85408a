"""The results of a shard: one zip, made where the shard was marked.

It may come from anywhere and is read without trust: sizes are looked at before anything is
unpacked, no name in it becomes a path, and everything must fit together. The table of contents has
the digest of every file, and is signed.
"""

import hashlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import BinaryIO, Literal, NamedTuple

import msgspec

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.base.zips import BadZip, Unpacker, packed
from vrts.marking.layout import LOST, RESULT, Layout
from vrts.marking.marking import Done
from vrts.marking.remote.names import Pseudonym
from vrts.marking.remote.recounted import contradiction
from vrts.marking.remote.shard import Number, PlanId, Shard
from vrts.marking.remote.signed import Secret, is_signed, signature
from vrts.marking.result import (
    LARGEST,
    Damaged,
    Digest,
    Record,
    Result,
    decoded,
    from_bytes,
    to_bytes,
)
from vrts.marking.submission.marker import STAFF, STUDENT, WRITTEN
from vrts.pipeline.refused import Refused

BAD_RESULTS = Rule("V722", "bad-results")

SCHEMA, UNSIGNED = "vrts.marked/2", "vrts.marked/1"  # those of before have no signature
CONTENTS, SIGNATURE = "marked.json", "signature.txt"
MODE = 0o600  # of members
LARGEST_CONTENTS = 32_000_000  # bytes
LARGEST_SIGNATURE = 64  # bytes
LARGEST_FILE = 64_000_000  # bytes of a page or a recording
LARGEST_ALL = 20_000_000_000  # bytes of everything in one zip, unpacked

_RESULTS = {STAFF: f"{STAFF}/{RESULT}", STUDENT: f"{STUDENT}/{RESULT}"}
_FILES = (*WRITTEN, f"{STAFF}/{LOST}")


class Used(Record, frozen=True):
    """What marking one submission took."""

    pseudonym: Pseudonym
    seconds: float
    peak: int  # bytes of memory in use
    files: dict[str, Digest] = msgspec.field(
        default_factory=dict[str, Digest]
    )  # all about it, by name below its pseudonym


class Contents(Record, frozen=True):
    """What the zip is about."""

    schema: Literal["vrts.marked/1", "vrts.marked/2"]
    plan: PlanId
    number: Number  # of the shard
    shard: Digest
    rows: tuple[Used, ...]


class NotTaken(Exception):  # noqa: N818 -- names the situation
    """The results of one submission cannot be taken; the text says why."""


class MarkedRow(NamedTuple):
    """One submission, under its pseudonym."""

    pseudonym: str
    staff: Result
    student: Result
    seconds: float
    peak: int
    files: dict[str, bytes]  # other than its results, by name in the zip


def results_zip(shard: Shard, digest: str, rows: Mapping[str, Done], layout: Layout) -> bytes:
    """Return the results of a shard and all files about it.

    Args:
        shard: That was marked.
        digest: Of its file.
        rows: Results by pseudonym.
        layout: Where marking wrote the files.
    """
    marked = [(piece.pseudonym, rows[piece.pseudonym]) for piece in shard.pieces]
    used: list[Used] = []
    members: dict[str, bytes] = {}
    for name, done in marked:
        files = {
            _RESULTS[STAFF]: to_bytes(done.result),
            _RESULTS[STUDENT]: to_bytes(done.student),
            **written(layout, name),
        }
        members |= {f"{name}/{file}": data for file, data in files.items()}
        digests = {file: hashlib.sha256(data).hexdigest() for file, data in files.items()}
        used.append(Used(name, round(done.seconds, 3), done.peak, digests))
    return packed({**signed_contents(shard, digest, used), **members}, MODE)


def signed_contents(shard: Shard, digest: str, used: Sequence[Used]) -> dict[str, bytes]:
    """Return the table of contents of results, and what signs it, by name in the zip."""
    secret = shard.secret
    if secret is None:  # a shard of before: it is read as before
        used = [msgspec.structs.replace(one, files={}) for one in used]
    schema = UNSIGNED if secret is None else SCHEMA
    contents = Contents(schema, shard.plan, shard.number, digest, tuple(used))
    data = msgspec.json.format(msgspec.json.encode(contents), indent=1) + b"\n"
    signed = {} if secret is None else {SIGNATURE: signature(secret, data).encode()}
    return {CONTENTS: data, **signed}


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


def is_of(path: Path, shard: Shard, digest: str) -> bool:
    """Return whether a file holds the results of a shard, as far as can be told without its plan.

    Args:
        path: Of the file.
        shard: That was marked.
        digest: Of its file.
    """
    try:
        with path.open("rb") as file:
            marked = MarkedShard(file, path.name)
            contents = marked.contents
            if shard.secret is not None and not marked.is_signed(shard.secret):
                return False
            sound = all(_is_sound(marked.row(used)) for used in contents.rows)
    except (Refused, NotTaken):
        return False
    whole = {row.pseudonym for row in contents.rows} == {piece.pseudonym for piece in shard.pieces}
    return sound and whole and contents.shard == digest


def _is_sound(row: MarkedRow) -> bool:
    return all(contradiction(result) is None for result in (row.staff, row.student))


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

    def is_signed(self, secret: Secret) -> bool:
        """Return whether its table of contents has the signature of a shard with this secret."""
        if self.contents.schema == UNSIGNED or SIGNATURE not in self._archive.sizes:
            return False
        try:
            found = self._read(SIGNATURE, LARGEST_SIGNATURE).decode("ascii", "replace")
        except NotTaken:
            return False
        return is_signed(secret, self._signed, found)

    def row(self, used: Used) -> MarkedRow:
        """Return one submission, with its files.

        Raises:
            NotTaken: Something about it is damaged, missing, or not what was signed.
        """
        name = used.pseudonym
        results = {whose: self._file(used, file) for whose, file in _RESULTS.items()}
        there = [file for file in _FILES if f"{name}/{file}" in self._archive.sizes]
        if self.contents.schema != UNSIGNED:
            strange = {*there, *_RESULTS.values()} ^ used.files.keys()
            if strange:
                raise NotTaken(f"`{name}/{min(strange)}` is not what was signed")
        return MarkedRow(
            name,
            self._result(results[STAFF], used, STAFF),
            self._result(results[STUDENT], used, STUDENT),
            used.seconds,
            used.peak,
            {file: self._file(used, file) for file in there},
        )

    def _contents(self) -> Contents:
        if CONTENTS not in self._archive.sizes:
            raise self._bad(f"there is no `{CONTENTS}` in it")
        try:
            self._signed = self._read(CONTENTS, LARGEST_CONTENTS)
            return decoded(self._signed, Contents)
        except Damaged as problem:
            raise self._bad(f"its `{CONTENTS}` is not as vrts writes it") from problem
        except NotTaken as problem:
            raise self._bad(str(problem)) from problem

    def _check_names(self) -> None:
        names = [row.pseudonym for row in self.contents.rows]
        allowed = {f"{name}/{file}" for name in names for file in (*_RESULTS.values(), *_FILES)}
        strange = sorted(self._archive.sizes.keys() - allowed - {CONTENTS, SIGNATURE})
        if strange or len(set(names)) != len(names):
            raise self._bad("it holds what no marking has written")
        if sum(self._archive.sizes.values()) > LARGEST_ALL:
            raise self._bad(f"its files have more than {LARGEST_ALL:,} bytes")

    def _result(self, data: bytes, used: Used, whose: str) -> Result:
        try:
            return from_bytes(data)
        except Damaged as problem:
            raise NotTaken(f"`{used.pseudonym}/{_RESULTS[whose]}` is no result") from problem

    def _file(self, used: Used, file: str) -> bytes:
        """Return a file about a submission, if it is the one that was signed."""
        member = f"{used.pseudonym}/{file}"
        if member not in self._archive.sizes:
            raise NotTaken(f"`{member}` is missing in it")
        data = self._read(member, LARGEST if file in _RESULTS.values() else LARGEST_FILE)
        signed = self.contents.schema != UNSIGNED
        if signed and hashlib.sha256(data).hexdigest() != used.files.get(file):
            raise NotTaken(f"`{member}` was changed after it was signed")
        return data

    def _read(self, member: str, most: int) -> bytes:
        if self._archive.sizes[member] > most:
            raise NotTaken(f"`{member}` has more than {most:,} bytes")
        try:
            return self._archive.read(member)
        except BadZip as problem:
            raise NotTaken(f"`{member}` is damaged") from problem

    def _bad(self, why: str) -> Refused:
        return Refused((no_results(self.name, why),))


def no_results(name: str, why: str) -> Diagnostic:
    """Return what to say of a file that holds no results."""
    headline = f"`{name}` holds no results of a shard: {why}"
    remedy = "copy the file again from where it was made, or run the shard again"
    return error(BAD_RESULTS, headline, help=(remedy,))
