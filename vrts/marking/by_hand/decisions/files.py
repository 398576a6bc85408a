"""The folder of the graders' files: reads all of them, and adds to one, whole or not at all."""

import errno
import os
import sys
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from datetime import datetime
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

import msgspec

from vrts.base.diagnostic import Diagnostic, Rule, error, warning
from vrts.marking.by_hand.decisions.graders import ID, Grader, grader_called
from vrts.marking.by_hand.decisions.ledger import (
    ENDING,
    LARGEST_FILE,
    LARGEST_LINE,
    MOST_FILES,
    NONE,
    NOT_DECISIONS,
    Filed,
    Ledger,
    ledger_of,
    lines_of,
)
from vrts.marking.by_hand.decisions.records import SCHEMA, Beginning, Decision
from vrts.marking.by_hand.decisions.sound import beyond, flaw_of
from vrts.marking.row import CountedFile
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

UNSOUND = Rule("V847", "unsound-decision")
BUSY = Rule("V849", "decisions-not-written")

LOCK = ".lock"  # in the folder; nothing is in it
_NO_LOCKS = (errno.ENOLCK, errno.EOPNOTSUPP, errno.ENOSYS, errno.EINVAL)


class Added(NamedTuple):
    """What was written."""

    grader: Grader
    records: tuple[Filed, ...]


def read_decisions(folder: Path, before: Sequence[CountedFile] = ()) -> Ledger:
    """Return what graders have decided; nothing where there is no folder.

    Args:
        folder: `staff/decisions` of a marking.
        before: What was in the files when lists of marks were written: it must still be there.

    Raises:
        CannotRead: A file cannot be read.
    """
    if not folder.is_dir():
        return ledger_of({}, before) if before else NONE
    found: dict[str, bytes] = {}
    said: list[Diagnostic] = []
    for path in sorted(folder.iterdir()):
        name = path.name
        if name.startswith(".") or name.endswith(".part"):
            continue
        ours = name.endswith(ENDING) and ID.match(name.removesuffix(ENDING))
        if path.is_symlink() or not path.is_file() or not ours:
            said.append(_foreign(name, like=name.lower().endswith(ENDING)))
            continue
        if len(found) == MOST_FILES:
            raise CannotRead(f"`{folder}` has more than {MOST_FILES} files of graders")
        found[name] = _bytes(path)
    ledger = ledger_of(found, before)
    return ledger._replace(diagnostics=(*ledger.diagnostics, *said))


def _bytes(path: Path) -> bytes:
    try:
        with path.open("rb") as file:
            return file.read(LARGEST_FILE + 1)
    except OSError as problem:
        reason = (problem.strerror or "unreadable").lower()
        raise CannotRead(f"cannot read `{path}`: {reason}") from problem


def _foreign(name: str, *, like: bool) -> Diagnostic:
    """Return that a file is not read: an error where it is called like one that would be."""
    headline = f"`{name}` in the folder of decisions is no file of a grader, and is not read"
    remedies = (
        "files of graders are called as vrts has called them: do not rename them",
        "delete the file, or take it somewhere else",
    )
    if not like:
        return warning(NOT_DECISIONS, headline, help=remedies)
    notes = ("decisions may be in it, so no mark is made while it is there",)
    return error(NOT_DECISIONS, headline, notes=notes, help=remedies)


def grader_in(folder: Path, name: str) -> Grader:
    """Return who is called so in a folder; somebody new where nobody is.

    Raises:
        CannotRead: A file cannot be read.
        Refused: It is no name.
    """
    return grader_called(name, _names(folder))


def _names(folder: Path) -> dict[str, str]:
    """Return what graders are called, by id; files that cannot be read hold their id."""
    held = [path.name for path in folder.glob(f"*{ENDING}")] if folder.is_dir() else []
    unknown = {name.removesuffix(ENDING): "" for name in held}
    return {**unknown, **read_decisions(folder).names}


def add_decisions(
    folder: Path,
    name: str,
    said: Sequence[Decision],
    now: datetime | None = None,
    total: Fraction | None = None,
) -> Added:
    """Write records at the end of a grader's file: all of them, or none.

    They get the next numbers. What a crash has left of a last line is cut off.

    Args:
        folder: `staff/decisions` of a marking; it is made where it is not there.
        name: Of the grader, as people write it.
        said: Records; their numbers do not count.
        now: Time with its offset for those without one; None: they all have one.
        total: Marks are out of so many points, and nothing is above; None: it is not looked.

    Raises:
        CannotRead: A file cannot be read.
        Refused: A record is unsound, the grader's file is damaged, or it cannot be written.
    """
    for one in said:
        flaw = flaw_of(one if one.at or now is None else _at(one, now))
        if flaw:
            raise Refused((error(UNSOUND, f"a decision cannot be written: {flaw}"),))
        flaw = "" if total is None else beyond(one, total)
        if flaw:
            remedy = "write the mark or the points that are meant"
            raise Refused((error(UNSOUND, f"this cannot be meant: {flaw}", help=(remedy,)),))
    with locked(folder, LOCK):
        grader = grader_in(folder, name)
        path = folder / f"{grader.id}{ENDING}"
        before = _bytes(path) if path.exists() else b""
        ledger = ledger_of({path.name: before}) if before else NONE
        if ledger.wrong:
            raise Refused(ledger.diagnostics)
        number = ledger.last.get(grader.id, 0)
        numbered = tuple(
            msgspec.structs.replace(
                _at(one, now) if now is not None and not one.at else one, number=number + k
            )
            for k, one in enumerate(said, 1)
        )
        lines = [_line(one) for one in numbered]
        after = (_whole(before, ledger) or _line(_beginning(grader))) + b"".join(lines)
        if len(after) > LARGEST_FILE or any(len(line) > LARGEST_LINE for line in lines):
            headline = f"`{path.name}` would be larger than a file of decisions may be"
            remedy = "decide in smaller parts, or go on under another name"
            raise Refused((error(BUSY, headline, help=(remedy,)),))
        _replace(path, after)
    records = tuple(
        Filed(f"{grader.id}:{one.number}", grader.id, grader.name, one) for one in numbered
    )
    return Added(grader, records)


def _at(one: Decision, now: datetime) -> Decision:
    return msgspec.structs.replace(one, at=now.isoformat(timespec="seconds"))


def _beginning(grader: Grader) -> Beginning:
    return Beginning(SCHEMA, grader.id, grader.name)


def _line(one: Decision | Beginning) -> bytes:
    return msgspec.json.encode(one) + b"\n"


def _whole(data: bytes, ledger: Ledger) -> bytes:
    """Return a file so that a line may follow: without what a crash left, with its line end."""
    lines, rest = lines_of(data)
    if not rest:
        return data
    kept = not lines or not ledger.diagnostics  # the one thing that is told is half a line
    return data + b"\n" if kept else data[: len(data) - len(rest)]


def _replace(path: Path, data: bytes) -> None:
    """Put a file in place whole, so that it is there after a crash."""
    draft = path.with_name(f"{path.name}.part")
    try:
        with draft.open("wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        draft.replace(path)
        _sync_folder(path.parent)
    except OSError as problem:
        draft.unlink(missing_ok=True)
        raise Refused(
            (_not_written(path, problem.strerror or "it cannot be written"),)
        ) from problem


def _sync_folder(folder: Path) -> None:
    if sys.platform == "win32":
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


@contextmanager
def locked(folder: Path, name: str) -> Generator[None]:
    """Hold a folder for one writer of this machine; wait for another one, who takes moments.

    The system lets go of it however a process ends. A file system that knows no locks holds
    nothing: what two write within a moment is then a conflict, which is shown.

    Args:
        folder: It is made where it is not there.
        name: Of the empty file in it that is locked.

    Raises:
        Refused: The folder cannot be written.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        descriptor = os.open(folder / name, os.O_RDWR | os.O_CREAT, 0o600)
    except OSError as problem:
        raise Refused((_not_written(folder, problem.strerror or "unwritable"),)) from problem
    try:
        if sys.platform == "win32":
            import msvcrt  # no other system has it

            msvcrt.locking(descriptor, msvcrt.LK_LOCK, 1)
        else:
            import fcntl  # Windows has none

            try:
                fcntl.flock(descriptor, fcntl.LOCK_EX)
            except OSError as problem:
                if problem.errno not in _NO_LOCKS:
                    raise
        yield
    finally:
        os.close(descriptor)


def _not_written(path: Path, why: str) -> Diagnostic:
    headline = f"nothing was decided: `{path}` cannot be written: {why.lower()}"
    remedy = "look whether the disk is full, and whether you may write there; then decide again"
    return error(BUSY, headline, help=(remedy,))
