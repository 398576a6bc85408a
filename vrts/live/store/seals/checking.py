"""What does not fit the signs of a database, found without trust in anything that it holds.

Rows are read in the order of their keys and forgotten, so it takes time in proportion to the log,
and the same memory for all logs.
"""

import hashlib
import sqlite3
from collections.abc import Iterator
from typing import Final, NamedTuple

from vrts.live.store.migrations import STEPS, migrate, version_of
from vrts.live.store.seals.heads import (
    ACCEPTED,
    HEAD,
    NAME,
    PURGED,
    Head,
    head_of,
    present,
    root_of,
)
from vrts.live.store.seals.key import LogKey
from vrts.live.store.seals.sealing import older, require_key
from vrts.live.store.seals.witness import Seen
from vrts.report.plain import one_line

LONGEST: Final = 32_000_000  # bytes of one value; a program has at most 200,000 characters
READ: Final = frozenset(  # tables that are read here
    ("account", "log", "log_accepted", "log_head", "log_name", "log_purged", "log_seal", "log_text")
) | {"room"}


class Purged(NamedTuple):
    """What is gone of a room's log, by somebody who may purge."""

    records: int = 0
    last_at: float = 0.0  # Unix time of the last one [s]
    last_why: str = ""


def require_tables(connection: sqlite3.Connection) -> int:
    """See to it that a database has the tables of its version; return that.

    Raises:
        ValueError: It has others, such as views that would never end.
    """
    connection.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, LONGEST)
    version = version_of(connection)
    if not 0 < version <= len(STEPS):
        raise ValueError("it is no database of this version of vrts")
    model = sqlite3.connect(":memory:", isolation_level=None)
    try:
        migrate(model, STEPS[:version])
        wanted = _tables(model)
    finally:
        model.close()
    if _tables(connection) != wanted:
        raise ValueError("its tables are not those of this version of vrts")
    return version


def _tables(connection: sqlite3.Connection) -> set[tuple[str, str, str]]:
    rows = connection.execute("SELECT type, name, sql FROM sqlite_master WHERE sql IS NOT NULL")
    return {
        (str(type_), str(name), " ".join(str(sql).split()))
        for type_, name, sql in rows
        if name in READ
    }


def unlike_root(connection: sqlite3.Connection, key: LogKey, seen: Seen | None) -> Iterator[str]:
    """Yield what does not fit the root: the list of rooms, and how far the database had come.

    Raises:
        CannotRead: The key is another one.
    """
    root = root_of(connection)
    if root is None:
        yield "the signed list of rooms is missing"
        return
    require_key(root, key)
    if not root.is_signed(key):
        yield "the signed list of rooms was changed"
        return
    problem = older(root, seen)
    if problem:
        yield problem
    (rooms,) = connection.execute("SELECT count(*) FROM log_head").fetchone()
    seals = hashlib.sha256()  # as `digest_of` makes it of few
    for (seal,) in connection.execute("SELECT seal FROM log_head ORDER BY room"):
        seals.update(seal if isinstance(seal, bytes) else b"")
    if rooms < root.rooms:
        yield f"rooms are missing: {root.rooms} were signed, {rooms} are there"
    elif rooms > root.rooms or seals.digest() != root.heads:
        yield "rooms were added, exchanged, or set back to what they were"
    rows = connection.execute("SELECT number, at, what, seal FROM log_accepted ORDER BY number")
    count = 0
    for count, (number, at, what, seal) in enumerate(rows, 1):
        if number != count or not _signed(key, seal, ACCEPTED, root.database, number, at, what):
            yield f"what was accepted as number {count} was changed"
    if count != root.accepted:
        yield f"{root.accepted} faults were accepted, but {count} are noted"


def unlike_head(
    connection: sqlite3.Connection, key: LogKey, database: bytes, room: str
) -> Iterator[str]:
    """Yield what does not fit the head of a room."""
    found, now = head_of(connection, room), present(connection, room)
    if found is None:
        yield "this room was never signed"
        return
    head, seal = found
    if not _signed(key, seal, HEAD, database, *head):
        yield "the signed head of its log was changed"
        return
    if now is None or (head.name and now.name == ""):
        yield "the room was deleted"
    elif now.name != head.name:
        yield f"the room was called {shown(head.name)}, and is called {shown(now.name)}"
    yield from _unlike_tail(connection, head)


def _unlike_tail(connection: sqlite3.Connection, head: Head) -> Iterator[str]:
    (count,) = connection.execute("SELECT count(*) FROM log WHERE room=?", (head.room,)).fetchone()
    if count < head.records:
        yield f"the end is missing: {head.records} records were signed, {count} are there"
    elif count > head.records:
        yield f"{count - head.records} records at the end were never signed"
    row = connection.execute(
        "SELECT hash FROM log WHERE room=? AND seq=?", (head.room, head.records)
    ).fetchone()
    if row is not None and row[0] != head.last:
        yield f"record {head.records} is not the one that was signed"


def unlike_names(
    connection: sqlite3.Connection, key: LogKey, database: bytes, room: str
) -> Iterator[str]:
    """Yield which persons of a room are not those that were signed, the first one."""
    rows = connection.execute(
        "SELECT n.room, n.account, n.salt, n.name, n.seal, account.name FROM log_name AS n"
        " LEFT JOIN account ON account.id=n.account WHERE n.room=? ORDER BY n.account",
        (room,),
    )
    for *fields, seal, called in rows:
        _, account, _, name = fields
        if not _signed(key, seal, NAME, database, *fields):
            yield f"account {shown(account)} has another name: {shown(name)} was not signed"
            return
        if called is not None and called != name:
            yield (
                f"account {shown(account)} is {shown(name)} in the log,"
                f" and {shown(called)} among the accounts"
            )
            return


def purged(
    connection: sqlite3.Connection, key: LogKey, database: bytes, room: str
) -> Iterator[str | Purged]:
    """Yield the first text that is gone without a purge, or what was purged."""
    rows = connection.execute(
        "SELECT log.seq, content, log_text.seq, at, why, log_purged.seal FROM log"
        " LEFT JOIN log_text USING (room, seq) LEFT JOIN log_purged USING (room, seq)"
        " WHERE log.room=? AND (log_text.seq IS NULL OR log_purged.seq IS NOT NULL)"
        " ORDER BY log.seq",
        (room,),
    )
    found = Purged()
    for seq, content, text, at, why, seal in rows:
        if seal is None:
            yield f"the text of record {shown(seq)} was removed, and nobody purged it"
            return
        if not _signed(key, seal, PURGED, database, room, seq, content, at, why):
            yield f"what is said of the purge of record {shown(seq)} was changed"
            return
        if text is not None:
            yield f"record {shown(seq)} was purged, and has a text"
            return
        found = Purged(found.records + 1, max(found.last_at, at), why)
    yield found


def strays(connection: sqlite3.Connection) -> Iterator[str]:
    """Yield which rows belong to no record."""
    for table, words in (("log_text", "texts"), ("log_purged", "notes of purges")):
        (count,) = connection.execute(
            f"SELECT count(*) FROM {table} AS t"  # noqa: S608 -- names of ours
            " WHERE NOT EXISTS (SELECT 1 FROM log WHERE log.room=t.room AND log.seq=t.seq)"
        ).fetchone()
        if count:
            yield f"{count} {words} belong to no record"


def shown(value: object) -> str:
    """Return a value of a database that nobody trusts, for a line of words."""
    if isinstance(value, bytes):
        return f"{len(value)} bytes"
    if isinstance(value, int):
        return str(value)
    text = one_line(str(value))
    return f"`{text[:60]}`" + ("…" if len(text) > 60 else "")


def _signed(key: LogKey, seal: object, kind: str, database: bytes, *fields: object) -> bool:
    plain = [field for field in fields if isinstance(field, str | int | float | bytes)]
    return len(plain) == len(fields) and key.signed(seal, kind, database, *plain)
