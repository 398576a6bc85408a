"""Certificates as bytes: a zip of `proof.json` and one member for every column of numbers.

The files that a scene names come along, one after the other in one more member, so that a
certificate needs nothing beside it.
Nothing is believed: names and sizes are checked before anything is unpacked, and what the numbers
mean is for the checker to say.
"""

import hashlib
import json
import re
from collections.abc import Mapping
from typing import Any, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.zips import BadZip, Unpacker, packed
from vrts.check.proof.given import (
    DIRECTION,
    Array,
    Claims,
    Evidence,
    Leaves,
    LetGo,
    Meeting,
    Parted,
    Points,
)
from vrts.engine.storage.damage import Damaged, require
from vrts.engine.storage.plain import Json, listed, named, number, text
from vrts.engine.storage.plain import whole as count
from vrts.scene.model import NO_FILES

# 1 had no files of the scene; 2 did not show until when things that part are near each other,
# nor 3 that they do not come near again before
NUMBER = 4
FORMAT = f"vrts.proof/{NUMBER}"
MANIFEST, FILES = "proof.json", "files"
COLUMNS = {  # kind of number, and how many in a row; 0: no rows
    "edges": ("<f8", 0),
    "row": ("<u4", 0),  # steps from leaf to leaf
    "root": ("<u4", 0),
    "depth": ("|u1", 0),
    "part": ("<u4", 0),
    "kind": ("|u1", 0),
    "normal": ("|i1", 3),  # of the leaves that have a direction, in 127ths
    "finer": ("|u1", 3),  # and what is to be added, in 256ths of that; mostly 0
    "use": ("|u1", 0),
    "time": ("<f8", 0),
    "solids": ("<u2", 2),
    "corners": ("<f8", 24),
    "weights": ("<f8", 4),
}
MODE = 0o600  # of members
FINE = 256  # parts of a step
ONE = 127 * FINE  # steps of a unit vector
STEPS = (126 * FINE, 63 * FINE, 25 * FINE, FINE, 1)  # from short to exact
MOST_BYTES = 64_000_000  # of all members, unpacked
MOST_MANIFEST = 8_000_000
MOST_FILES = 16_000_000  # bytes of all files of the scene
MOST_LEAVES = 500_000
MOST_EDGES = 50_000
MOST_POINTS = 100_000

Table: TypeAlias = npt.NDArray[Any]


class Read(NamedTuple):
    """What a certificate says; nothing of it is believed yet."""

    said: Mapping[str, Json]  # what it says of the run, by name
    claims: Claims
    evidence: Evidence
    files: Mapping[str, bytes]  # that the scene names, by name


class OtherFormat(Damaged):
    """It was written by an older or a newer vrts."""

    def __init__(self, said: str, *, older: bool) -> None:
        """Say which.

        Args:
            said: The format that it names.
            older: Than the one that is read here.
        """
        super().__init__(f"its format is `{said}`, not `{FORMAT}`")
        self.older = older


def digest(said: Json) -> str:
    """Return the hash of JSON, whatever the order of its names."""
    plain = json.dumps(said, sort_keys=True, separators=(",", ":"), allow_nan=False)
    return hashlib.sha256(plain.encode()).hexdigest()


def certificate_bytes(
    said: Mapping[str, Json], claims: Claims, by: Evidence, files: Mapping[str, bytes] = NO_FILES
) -> bytes:
    """Return the bytes of a certificate; the same content gives the same bytes.

    Args:
        said: What is said of the run, by name; each part is written with its hash.
        claims: What is claimed.
        by: What shows it.
        files: That the scene names, by name.
    """
    said = {**said, FILES: [[name, len(data)] for name, data in sorted(files.items())]}
    manifest = {
        "format": FORMAT,
        **said,
        "sha256": {name: digest(part) for name, part in said.items()},
        "claims": {
            "contacts": [list(meeting) for meeting in claims.meetings],
            "clearance_m": claims.clearance_m,
            "near_miss_m": claims.near_miss_m,
            "let_go": [list(row) for row in claims.let_go],
            "parted": [list(row) for row in claims.parted],
        },
    }
    x, p = by.leaves, by.points
    steps = np.round(x.normal[x.kind == DIRECTION] * ONE).astype(np.int64)
    tables = {
        "edges": by.edges,
        "row": np.diff(x.row, prepend=0),
        "root": x.root,
        "depth": x.depth,
        "part": x.part,
        "kind": x.kind,
        "normal": steps // FINE,
        "finer": steps % FINE,
        "use": p.use,
        "time": p.time_s,
        "solids": p.solids,
        "corners": p.corners,
        "weights": p.weights,
    }
    members = {MANIFEST: json.dumps(manifest, separators=(",", ":"), allow_nan=False).encode()}
    for name, (kind, _) in COLUMNS.items():
        members[name] = np.ascontiguousarray(tables[name]).astype(kind).tobytes()
    members[FILES] = b"".join(data for _, data in sorted(files.items()))
    return packed(members, MODE)


def rounded(normal: Array, step: int) -> Array:
    """Return directions as they can be written, (m, 3).

    Args:
        normal: Unit vectors, (m, 3).
        step: Of the numbers written, of which 32512 are one; the larger, the shorter it packs.
    """
    return np.round(normal * (ONE / step)).clip(-(ONE // step), ONE // step) * step / ONE


def is_certificate(data: bytes) -> bool:
    """Return whether bytes begin as a certificate does, sound or not."""
    return data.startswith(b"PK\x03\x04") and data[30:].startswith(MANIFEST.encode())


def read_certificate(data: bytes) -> Read:
    """Return what a certificate says.

    Raises:
        OtherFormat: It was written by an older or a newer vrts.
        Damaged: It is not sound.
    """
    require(data.startswith(b"PK\x03\x04"), "it is none, or its beginning was changed")
    try:
        archive = Unpacker(data)
        sizes = archive.sizes
        strange = "it has other members than certificates have"
        require(MANIFEST in sizes, strange)
        require(sizes[MANIFEST] <= MOST_MANIFEST, "what it says about itself is too long")
        require(sum(sizes.values()) <= MOST_BYTES, "it is too large")
        said = _manifest(archive.read(MANIFEST))
        _require_format(said.get("format"))
        require(sizes.keys() == {MANIFEST, FILES, *COLUMNS}, strange)
        require(sizes[FILES] <= MOST_FILES, "the files of its scene are too large")
        tables = {name: _table(archive.read(name), *COLUMNS[name]) for name in COLUMNS}
        joined = archive.read(FILES)
    except BadZip as problem:
        raise Damaged("it is incomplete, or was changed") from problem
    hashes = named(said.get("sha256"))
    for name in said.keys() - {"format", "sha256", "claims"}:
        good = hashes.get(name) == digest(said[name])
        require(good, f"what it says of `{name}` does not have the hash that it names")
    files = _files(joined, said.get(FILES))
    return Read(said, _claims(named(said.get("claims"))), _evidence(tables), files)


def _require_format(said: Json) -> None:
    numbered = re.fullmatch(r"vrts\.proof/([1-9][0-9]{0,3})", said if isinstance(said, str) else "")
    if numbered is None:
        raise Damaged(f"its format is not `{FORMAT}`")
    if int(numbered[1]) != NUMBER:
        raise OtherFormat(numbered[0], older=int(numbered[1]) < NUMBER)


def _manifest(data: bytes) -> dict[str, Json]:
    try:
        return named(json.loads(data, parse_constant=_no_number))
    except (ValueError, RecursionError) as problem:
        raise Damaged("what it says about itself is not JSON") from problem


def _no_number(word: str) -> float:
    raise ValueError(word)


def _files(joined: bytes, said: Json) -> Mapping[str, bytes]:
    found: dict[str, bytes] = {}
    at = 0
    for row in listed(said):
        name, size = listed(row, 2)
        end = at + count(size)
        found[text(name)] = joined[at:end]
        at = end
    require(at == len(joined), "the files of its scene have other lengths")
    return found


def _table(data: bytes, kind: str, columns: int) -> Table:
    dtype = np.dtype(kind)
    step = dtype.itemsize * max(columns, 1)
    require(len(data) % step == 0, "a column ends within a number")
    found = np.frombuffer(data, dtype)
    require(dtype.kind != "f" or bool(np.isfinite(found).all()), "a number is infinite or none")
    return found.reshape(-1, columns) if columns else found


def _claims(said: Mapping[str, Json]) -> Claims:
    floor, near_miss = (
        None if said.get(name) is None else number(said.get(name))
        for name in ("clearance_m", "near_miss_m")
    )
    meetings: list[Meeting] = []
    for row in listed(said.get("contacts")):
        first, second, from_s, to_s = listed(row, 4)
        meetings.append(Meeting(text(first), text(second), number(from_s), number(to_s)))
    let_go: list[LetGo] = []
    for row in listed(said.get("let_go")):
        body, finger, grip, apart_s, away_s = listed(row, 5)
        place = text(body), count(finger), count(grip)
        let_go.append(LetGo(*place, number(apart_s), number(away_s)))
    parted: list[Parted] = []
    for row in listed(said.get("parted")):
        body, stay, other, from_s, to_s = listed(row, 5)
        parted.append(Parted(text(body), count(stay), text(other), number(from_s), number(to_s)))
    return Claims(tuple(meetings), floor, near_miss, tuple(let_go), tuple(parted))


def _evidence(tables: Mapping[str, Table]) -> Evidence:
    real = {name: t.astype(np.float64) for name, t in tables.items() if t.dtype.kind == "f"}
    whole = {name: t.astype(np.int64) for name, t in tables.items() if t.dtype.kind != "f"}
    directed = whole["kind"] == DIRECTION
    leaves, points, directions = len(tables["row"]), len(tables["use"]), int(directed.sum())
    lengths = dict.fromkeys(("root", "depth", "part", "kind"), leaves)
    lengths |= dict.fromkeys(("time", "solids", "corners", "weights"), points)
    lengths |= dict.fromkeys(("normal", "finer"), directions)
    same = all(len(tables[name]) == length for name, length in lengths.items())
    require(same, "its columns differ in length")
    require(leaves <= MOST_LEAVES and points <= MOST_POINTS, "it is too large")
    require(2 <= len(tables["edges"]) <= MOST_EDGES, "it has too few intervals, or too many")
    normal = np.zeros((leaves, 3))
    normal[directed] = (whole["normal"] * FINE + whole["finer"]) / ONE
    row = np.cumsum(whole["row"])
    places = whole["root"], whole["depth"], whole["part"], whole["kind"]
    corners = real["corners"].reshape(-1, 2, 4, 3)
    pairs = Points(whole["use"], real["time"], whole["solids"], corners, real["weights"])
    return Evidence(real["edges"], Leaves(row, *places, normal), pairs)
