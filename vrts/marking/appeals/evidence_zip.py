"""Reads an evidence zip, which may come from anybody, without trust."""

from pathlib import Path
from typing import BinaryIO

from vrts.base.safe_names import safe
from vrts.base.zips import BadZip, Flaw, Unpacker
from vrts.check.task.manifest import sha256
from vrts.marking.appeals.evidence import (
    CHANGES,
    CONTENTS,
    DECISIONS,
    INTAKE,
    LARGEST_ALL,
    LARGEST_CONTENTS,
    LARGEST_ZIP,
    MOST_FILES,
    OVER,
    README,
    ROW,
    STAFF,
    STUDENT,
    SUBMISSION,
    TASK,
    Contents,
    Evidence,
    altered,
    damaged,
)
from vrts.marking.appeals.proof import PROOF
from vrts.marking.by_hand.graded import undecided
from vrts.marking.layout import LOST, RESULT
from vrts.marking.result import Damaged, Result, decoded, from_bytes
from vrts.marking.row import Row
from vrts.marking.submission.report_files import FAULT, RECORDING, REPORT
from vrts.pipeline.files import CannotRead

_FIXED = frozenset(
    (
        *(CONTENTS, README, TASK, ROW, INTAKE, CHANGES, DECISIONS, PROOF),
        *(f"{who}/{name}" for who in (STAFF, STUDENT) for name in (RESULT, REPORT, RECORDING)),
        *(f"{STAFF}/{name}" for name in (FAULT, LOST)),
    )
)
_LAID_OVER = ("scene", "scenario", "lab")


def read_evidence(path: Path) -> Evidence:
    """Return what is in an evidence zip.

    Raises:
        CannotRead: The file is not there.
        Refused: It is none, is damaged, or was altered; one diagnostic says what.
    """
    try:
        if path.stat().st_size > LARGEST_ZIP:
            raise damaged(f"it has more than {LARGEST_ZIP:,} bytes")
        with path.open("rb") as file:
            return _evidence(_files(file))
    except OSError as problem:
        reason = (problem.strerror or "unreadable").lower()
        raise CannotRead(f"cannot read `{path}`: {reason}") from problem


def _files(file: BinaryIO) -> dict[str, bytes]:
    try:
        archive = Unpacker(file)
        sizes = archive.sizes
        for name in sizes:
            if not known_name(name):
                raise damaged(f"`{name}` does not belong into it")
        if len(sizes) > MOST_FILES:
            raise damaged(f"it has more than {MOST_FILES} files")
        if sum(sizes.values()) > LARGEST_ALL:
            raise damaged(f"its files have more than {LARGEST_ALL:,} bytes")
        if sizes.get(CONTENTS, 0) > LARGEST_CONTENTS:
            raise damaged(f"`{CONTENTS}` has more than {LARGEST_CONTENTS:,} bytes")
        return {name: archive.read(name) for name in sizes}
    except BadZip as problem:
        raise damaged(_flaw(problem)) from problem


def known_name(name: str) -> bool:
    """Return whether a file of evidence may have a name; none leads out of its folder."""
    if name in _FIXED:
        return True
    match name.split("/"):
        case [folder, file]:
            return folder == SUBMISSION and safe(file) == file
        case [folder, part, file]:
            return folder == OVER and part in _LAID_OVER and safe(file) == file
        case _:
            return False


def _flaw(problem: BadZip) -> str:
    match problem.flaw:
        case Flaw.INCOMPLETE:
            return "it is incomplete, or is no zip file"
        case Flaw.FOREIGN:
            return "it is packed in a way that evidence is not"
        case Flaw.TWICE:
            return f"`{problem.member}` is in it twice"
        case Flaw.LENGTH:
            return f"`{problem.member}` has another length than it says"


def _evidence(files: dict[str, bytes]) -> Evidence:
    """Return the evidence in files, each of them as its digest says, and in agreement."""
    if CONTENTS not in files:
        raise damaged(f"there is no `{CONTENTS}` in it")
    try:
        contents = decoded(files.pop(CONTENTS), Contents)
    except Damaged as problem:
        raise damaged(f"`{CONTENTS}` is not as vrts writes it") from problem
    for name, digest in contents.sha256.items():
        if name not in files:
            raise altered(f"`{name}` is missing")
        if sha256(files[name]) != digest:
            raise altered(f"`{name}` has other bytes")
    strange = sorted(files.keys() - contents.sha256.keys())
    if strange:
        raise altered(f"`{strange[0]}` was added")
    staff, student = (_result(files, f"{who}/{RESULT}") for who in (STAFF, STUDENT))
    row = _row(files)
    _agree(contents, row, staff, student, files)
    return Evidence(contents, row, staff, student, files)


def _result(files: dict[str, bytes], name: str) -> Result:
    if name not in files:
        raise damaged(f"there is no `{name}` in it")
    try:
        return from_bytes(files[name])
    except Damaged as problem:
        raise damaged(f"`{name}` is no result of this version") from problem


def _row(files: dict[str, bytes]) -> Row:
    try:
        return decoded(files.get(ROW, b""), Row)
    except Damaged as problem:
        raise damaged(f"`{ROW}` is not as vrts writes it") from problem


def _agree(
    contents: Contents, row: Row, staff: Result, student: Result, files: dict[str, bytes]
) -> None:
    """Refuse evidence whose parts are about different things."""
    if len({contents.id, row.id, staff.id, student.id}) != 1 or undecided(row).result != staff:
        raise altered("its parts are about different results")
    place = contents.place
    named = (place.task, place.scene, place.scenario, place.lab, contents.program)
    missing = [name for name in named if name is not None and name not in files]
    if missing or place.task != TASK:
        raise altered(f"the file `{(missing or [place.task])[0]}` that it names is not in it")
    about = staff.program
    if about is None:
        return
    if contents.program is None:
        raise altered("the program is missing")
    if sha256(files[contents.program]) != about.sha256:
        raise altered("the program is not the one that the result is about")
