"""Databases that are of no use: found before anything is written, and said in one sentence."""

import sqlite3
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from vrts.live.store.migrations import STEPS, NotMigrated, TooNew, version_of
from vrts.pipeline.files import CannotRead

OURS: Final = frozenset(("account", "room", "log"))  # tables that every version has
_BACKUP: Final = "put a copy back that `vrts serve --backup` made, or name another `--folder`"
_OTHER: Final = "name another folder with `--folder`"
_WHAT: Final = {  # names of SQLite's result codes, the longest that fits counts
    "SQLITE_FULL": ("the disk is full", "make room on it"),
    "SQLITE_IOERR": ("the disk is full or fails", "make room on it, or check the disk"),
    "SQLITE_READONLY": ("vrts may not write it", "look who owns the file and the folder"),
    "SQLITE_CANTOPEN": ("vrts cannot open it", "look who owns the file and the folder"),
    "SQLITE_PERM": ("vrts may not read it", "look who owns the file and the folder"),
    "SQLITE_AUTH": ("vrts may not read it", "look who owns the file and the folder"),
    "SQLITE_BUSY": ("another program uses it", "end that program"),
    "SQLITE_LOCKED": ("another program uses it", "end that program"),
    "SQLITE_PROTOCOL": (
        "its file system knows no locks",
        "use a disk of this machine",
    ),
    "SQLITE_CORRUPT": ("it is damaged: a part is missing or was changed", _BACKUP),
    "SQLITE_NOTADB": ("it is no SQLite database", _OTHER),
}


def require_ours(path: Path) -> None:
    """Make sure that a file is absent or a database of vrts that we know; nothing is written.

    Raises:
        CannotRead: It is none.
        TooNew: A later vrts wrote it.
        sqlite3.Error: It cannot be read.
    """
    if not path.exists():
        return
    wal = path.with_name(path.name + "-wal")
    if path.stat().st_size == 0 and not (wal.exists() and wal.stat().st_size):
        if any(path.parent.glob("sessions/*")):
            raise CannotRead(f"the database `{path}` is empty, but sessions were kept", (_BACKUP,))
        return
    connection = sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", uri=True)
    try:
        rows = connection.execute("SELECT name FROM sqlite_master WHERE type='table'").fetchall()
        tables = {str(row[0]) for row in rows}
        version = version_of(connection)
    finally:
        connection.close()
    if tables and (version == 0 or not tables >= OURS):
        raise CannotRead(f"`{path}` is a database of another program", (_OTHER,))
    if version > len(STEPS):
        raise TooNew(f"the database is of a later version: {version}")


def require_whole(path: Path) -> None:
    """Make sure that nothing of a database is missing; nothing is written.

    Raises:
        CannotRead: A part is.
        sqlite3.Error: It cannot be read.
    """
    if not path.exists() or path.stat().st_size == 0:
        return
    connection = sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", uri=True)
    try:
        (found,) = connection.execute("PRAGMA quick_check(1)").fetchone()
    finally:
        connection.close()
    if found != "ok":
        raise CannotRead(f"the database `{path}` is damaged", (_BACKUP,))


@contextmanager
def in_one_sentence(path: Path) -> Generator[None]:
    """Turn what a database refuses into one sentence, and what to do.

    Raises:
        CannotRead: Something was refused.
    """
    try:
        yield
    except TooNew as problem:
        hint = "use a vrts that is at least as new as the one that wrote it, or another `--folder`"
        raise CannotRead(f"`{path}` was written by a later vrts", (hint,)) from problem
    except NotMigrated as problem:
        raise CannotRead(f"`{path}`: {problem}", ("is there room on its disk?",)) from problem
    except sqlite3.Error as problem:
        name = getattr(problem, "sqlite_errorname", "")
        known = next((_WHAT[code] for code in _WHAT if name.startswith(code)), None)
        if known is None:
            raise
        raise CannotRead(
            f"vrts cannot use the database `{path}`: {known[0]}", (known[1],)
        ) from problem
