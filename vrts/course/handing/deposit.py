"""Writes hand-ins so that nothing that was acknowledged is lost, and nothing is half there.

First a hand-in is written whole, in one file, before anything else: from then on it counts. Then
the program goes to the folder of each person, then rows are written, and the first file is removed.
Whatever a crash leaves out of that is done at the next start.
"""

import hashlib
import os
import secrets
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import msgspec

from vrts.course.handing.names import PROGRAM

PENDING: Final = ".pending"  # beside the folders of the assignments


class HandIn(msgspec.Struct, frozen=True):
    """A program that was handed in, and for whom."""

    assignment: str
    at: int  # Unix time [s]
    stamp: str  # the same as the name of a folder
    by: int  # account
    people: tuple[tuple[int, str], ...]  # account and folder of everybody for whom it counts
    late: str  # in words
    program: bytes
    variant: str = ""  # tag of the variant that it is for; empty: the task has none

    @property
    def digest(self) -> str:
        """Of the program."""
        return hashlib.sha256(self.program).hexdigest()


def begin(home: Path, hand_in: HandIn) -> Path:
    """Write a hand-in, whole or not at all; return the file. From then on it is handed in.

    Raises:
        OSError: It cannot be written: nothing was handed in.
    """
    pending = home / PENDING
    home.mkdir(mode=0o700, parents=True, exist_ok=True)  # programs are nobody else's to read
    pending.mkdir(exist_ok=True)
    path = pending / f"{hand_in.at}-{hand_in.by}-{secrets.token_hex(4)}.json"
    _write(path.with_suffix(".part"), msgspec.json.encode(hand_in))
    path.with_suffix(".part").replace(path)
    _sync(pending)
    return path


def place(home: Path, hand_in: HandIn) -> None:
    """Put the program where marking looks for it, for everybody; once more changes nothing."""
    for _, folder in hand_in.people:
        own = home / hand_in.assignment / folder
        own.mkdir(parents=True, exist_ok=True)
        target = own / hand_in.stamp
        if (target / PROGRAM).is_file():
            continue
        draft = home / PENDING / f"draft-{secrets.token_hex(4)}"
        draft.mkdir()
        _write(draft / PROGRAM, hand_in.program)
        draft.rename(target)
        _sync(own)
        _sync(own.parent)


def done(path: Path) -> None:
    """Forget the first file: everything else is written."""
    path.unlink(missing_ok=True)


def unfinished(home: Path) -> Iterator[tuple[Path, HandIn]]:
    """Yield what was begun and not done, the earliest first; what is half there goes away."""
    pending = home / PENDING
    if not pending.is_dir():
        return
    for path in sorted(pending.iterdir()):
        if path.suffix == ".json":
            yield path, msgspec.json.decode(path.read_bytes(), type=HandIn)
        elif path.is_dir():
            shutil.rmtree(path, ignore_errors=True)
        else:
            path.unlink(missing_ok=True)


def program_of(home: Path, assignment: str, folder: str, stamp: str) -> bytes | None:
    """Return a program that was handed in; None: it is not there any more."""
    path = home / assignment / folder / stamp / PROGRAM
    try:
        return path.read_bytes() if not path.is_symlink() else None
    except OSError:
        return None


def found(home: Path, assignment: str) -> Iterator[tuple[str, str, Path]]:
    """Yield folder, stamp and program of everything that lies there."""
    for path in sorted((home / assignment).glob(f"*/*/{PROGRAM}")):
        if path.is_file() and not path.is_symlink():
            yield path.parent.parent.name, path.parent.name, path


def _write(path: Path, data: bytes) -> None:
    with path.open("xb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())
    _sync(path.parent)


def _sync(folder: Path) -> None:
    """Have the system write down which files a folder holds."""
    number = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(number)
    finally:
        os.close(number)
