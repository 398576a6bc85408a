"""Whether the logs of a database are what was recorded: chains, and what the signs tell besides."""

import sqlite3
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Final, NamedTuple

from vrts.live.store import log
from vrts.live.store.database import read_only
from vrts.live.store.migrations import STEPS
from vrts.live.store.seals.checking import (
    Purged,
    purged,
    require_tables,
    shown,
    strays,
    unlike_head,
    unlike_names,
    unlike_root,
)
from vrts.live.store.seals.heads import root_of
from vrts.live.store.seals.key import LogKey, read_key, require_outside, usual_key
from vrts.live.store.seals.sealing import UNSIGNED, missing
from vrts.live.store.seals.witness import Seen, Witness

SIGNED_SINCE: Final = 1 + next(n for n, step in enumerate(STEPS) if "log_seal" in step)
OLD: Final = "the logs are not signed yet: they will be when the server is started"


class Finding(NamedTuple):
    """What is said of one room, or of all."""

    room: str  # its id; empty: of the whole database
    name: str  # of the room, as it can be shown
    text: str
    wrong: bool


def findings(path: Path, key_file: Path | None = None) -> Iterator[Finding]:
    """Yield what is said of every room, and what is wrong with the database.

    Args:
        path: Of the database, which a server may use meanwhile.
        key_file: With the key of the logs, if not the usual one.

    Raises:
        CannotRead: There is no key that fits.
    """
    file = usual_key() if key_file is None else key_file
    require_outside(file, path.parent)
    key, witness = read_key(file), Witness(file)
    here = witness.in_folder(path.parent)
    try:
        with read_only(path) as connection:
            signed = require_tables(connection) >= SIGNED_SINCE
            root = root_of(connection) if signed else None
            seen = None if root is None else witness.of(root.database)
            connection.execute("BEGIN")  # from here on it stays as it is, whoever writes
            if signed:
                if key is None and (root is not None or here):
                    raise missing(file)
                if key is not None:
                    yield from of_signed(connection, key, seen, here)
                    return
            for room in _rooms(connection, "SELECT DISTINCT room FROM log ORDER BY room"):
                wrong = log.verify(connection, room)
                yield Finding(room, _name(connection, room), wrong or "unbroken", bool(wrong))
            yield Finding("", "", UNSIGNED if here else OLD, bool(here))
    except ValueError as problem:
        yield Finding("", "", str(problem), True)


def of_signed(
    connection: sqlite3.Connection, key: LogKey, seen: Seen | None, here: tuple[Seen, ...]
) -> Iterator[Finding]:
    """Yield what is said of a database whose logs are signed.

    Args:
        connection: In a transaction.
        key: Of the logs.
        seen: What is known of the database beside the key.
        here: What is known of databases in its folder.

    Raises:
        CannotRead: The logs are signed with another key.
    """
    for problem in unlike_root(connection, key, seen):
        yield Finding("", "", problem, True)
    root = root_of(connection)
    database = b"" if root is None else root.database
    for other in here:
        if other.database != database.hex():
            text = f"another database was here, which had been signed {other.count} times"
            yield Finding("", "", text, True)
    rooms = "SELECT room FROM log_head UNION SELECT room FROM log UNION SELECT id FROM room"
    for room in _rooms(connection, f"{rooms} ORDER BY 1"):
        yield from _of_room(connection, key, database, room)
    for problem in strays(connection):
        yield Finding("", "", problem, True)


def _of_room(
    connection: sqlite3.Connection, key: LogKey, database: bytes, room: str
) -> Iterator[Finding]:
    name, gone = _name(connection, room), Purged()
    chain = log.verify(connection, room)
    problems = [chain] if chain else []
    try:
        problems += unlike_head(connection, key, database, room)
        problems += unlike_names(connection, key, database, room)
        for found in purged(connection, key, database, room):
            if isinstance(found, str):
                problems.append(found)
            else:
                gone = found
        (count,) = connection.execute("SELECT count(*) FROM log WHERE room=?", (room,)).fetchone()
    except sqlite3.Error as problem:
        problems.append(f"what was signed cannot be read: {problem}")
        count = 0
    for text in problems:
        yield Finding(room, name, text, True)
    if not problems:
        yield Finding(room, name, f"unbroken, {count} records{_words(gone)}", False)


def _words(gone: Purged) -> str:
    """Return what is said of purges."""
    if not gone.records:
        return ""
    when = datetime.fromtimestamp(gone.last_at, UTC).strftime("%Y-%m-%d %H:%M UTC")
    return f"; the texts of {gone.records} were purged, last on {when}: {gone.last_why}"


def _rooms(connection: sqlite3.Connection, query: str) -> Iterator[str]:
    """Yield the ids of rooms; what is none is told.

    Raises:
        ValueError: One is no text.
    """
    for (room,) in connection.execute(query):
        if not isinstance(room, str):
            raise ValueError(f"there is a room of a foreign kind: {shown(room)}")
        yield room


def _name(connection: sqlite3.Connection, room: str) -> str:
    row = connection.execute("SELECT name FROM room WHERE id=?", (room,)).fetchone()
    return shown(row[0]).strip("`") if row else ""
