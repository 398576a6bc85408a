"""The teacher's key: whoever has it can tell which variant a student gets.

Lines behind the key tell for which assignments a record of what was handed out was written beside
it, so that a copy of the key without the record is noticed.
"""

import hashlib
import os
import re
import secrets
from pathlib import Path

from vrts.base.diagnostic import Rule, error
from vrts.pipeline.files import CannotRead, read_bytes
from vrts.pipeline.refused import Refused

BAD_KEY = Rule("V868", "variants-key")

NAME = "variants.key"  # beside the task: packed for nobody
HANDED = ".handed.json"  # behind the name of a key: what was handed out by it
PRIVATE = 0o600
LARGEST = 100_000  # bytes of the file
_TEXT = re.compile(rb"([0-9a-f]{64})\n?|([0-9a-f]{64})\n(?:handed [0-9a-f]{16}\n)+")


def place_of_key(task: Path) -> Path:
    """Return where the key of a task is: in its folder, or beside its zip."""
    return (task if task.is_dir() else task.parent) / NAME


def place_of_handed(key: Path) -> Path:
    """Return where it is written what was handed out by a key."""
    return key.with_name(f"{key.name}{HANDED}")


def key_of(path: Path) -> bytes:
    """Return a key that is there already.

    Raises:
        CannotRead: It is not there.
        Refused: The file is none of ours.
    """
    if not os.path.lexists(path):
        hints = (
            "`vrts task variants` makes the key of a task, and says where it is",
            "name another place with `--key`",
        )
        raise CannotRead(f"there is no key of variants at `{path}`", hints)
    found = _TEXT.fullmatch(b"" if path.is_symlink() else read_bytes(path)[:LARGEST])
    if found is None:
        headline = f"`{path}` is no key that vrts has written"
        remedy = "put the file back as it was: with another key every student has another variant"
        raise Refused((error(BAD_KEY, headline, help=(remedy,)),))
    return bytes.fromhex((found[1] or found[2]).decode())


def note_handed(path: Path, assignment: str) -> None:
    """Write into the file of a key that a record of what was handed out stands beside it.

    Raises:
        CannotRead: The file cannot be written.
    """
    line, data = _line(assignment), read_bytes(path)
    if line in data.splitlines():
        return
    begin = b"" if data.endswith(b"\n") else b"\n"
    flags = os.O_WRONLY | os.O_APPEND | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
    try:
        with open(os.open(path, flags), "ab") as file:
            file.write(begin + line + b"\n")
    except OSError as problem:
        headline = f"`{path}` cannot be written: {problem.strerror}"
        hints = ("let yourself write it: vrts notes in it that variants were handed out",)
        raise CannotRead(headline, hints) from problem


def was_handed(path: Path, assignment: str) -> bool:
    """Return whether the file of a key tells that variants of an assignment were handed out."""
    return _line(assignment) in read_bytes(path)[:LARGEST].splitlines()


def _line(assignment: str) -> bytes:
    return f"handed {hashlib.sha256(assignment.encode()).hexdigest()[:16]}".encode()


def key_made(path: Path) -> tuple[bytes, bool]:
    """Return a key, and whether it was made now: drawn, and written for its owner alone.

    Raises:
        CannotRead: Its folder is not there.
        Refused: The file is none of ours.
    """
    if os.path.lexists(path):
        return key_of(path), False
    if not path.parent.is_dir():
        raise CannotRead(f"there is no folder `{path.parent}` for the key")
    if os.path.lexists(place_of_handed(path)):
        headline = f"the key `{path}` is gone, and variants were handed out by it"
        remedies = (
            "put the file back as it was: with another key every student has another variant",
            f"to draw all again, delete `{place_of_handed(path)}`",
        )
        raise Refused((error(BAD_KEY, headline, help=remedies),))
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0)
    with open(os.open(path, flags | getattr(os, "O_BINARY", 0), PRIVATE), "wb") as file:
        file.write(f"{secrets.token_hex(32)}\n".encode())
    return key_of(path), True
