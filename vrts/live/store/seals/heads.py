"""What is signed: the head of every log, and all heads together, as one root.

A head says how many records the log of a room has, which is the last, and what the room is called.
The root says how many heads there are and which, and counts how often it was signed.
"""

import hashlib
import sqlite3
from collections.abc import Iterable
from typing import Final, NamedTuple

from vrts.live.store.chain import START
from vrts.live.store.seals.key import LogKey

HEAD: Final = "head"
ROOT: Final = "root"
NAME: Final = "name"  # of a person in a room
PURGED: Final = "purged"
ACCEPTED: Final = "accepted"


class Head(NamedTuple):
    """Of a room's log."""

    room: str
    name: str  # of the room
    records: int
    last: bytes  # hash of the last record


class Root(NamedTuple):
    """Of a database."""

    database: bytes  # what the database is called: random
    key: bytes  # which key signs
    times: int  # how often this was signed
    rooms: int
    heads: bytes  # digest of their signs
    accepted: int  # how many faults somebody has accepted
    seal: bytes = b""

    def is_signed(self, key: LogKey) -> bool:
        """Return whether the sign fits."""
        return key.signed(self.seal, ROOT, self.database, *self[1:6])

    def sign(self, key: LogKey) -> "Root":
        """Return the same, signed."""
        return self._replace(seal=key.sign(ROOT, self.database, *self[1:6]))


UNREADABLE: Final = Root(b"", b"", 0, 0, b"", 0)  # in place of one with foreign values


def digest_of(seals: Iterable[bytes]) -> bytes:
    """Return the digest of the signs of all heads, in the order of their rooms."""
    return hashlib.sha256(b"".join(seals)).digest()


def root_of(connection: sqlite3.Connection) -> Root | None:
    """Return the root as it is kept; None: there is none."""
    row = connection.execute(
        "SELECT database, key, count, rooms, heads, accepted, seal FROM log_seal WHERE one=1"
    ).fetchone()
    if row is None:
        return None
    kinds = (bytes, bytes, int, int, bytes, int, bytes)
    if all(isinstance(value, kind) for value, kind in zip(row, kinds, strict=True)):
        return Root._make(row)
    return UNREADABLE


def keep_root(connection: sqlite3.Connection, root: Root) -> None:
    """Write the root."""
    connection.execute("INSERT OR REPLACE INTO log_seal VALUES (1,?,?,?,?,?,?,?)", root)


def head_of(connection: sqlite3.Connection, room: str) -> tuple[Head, bytes] | None:
    """Return the head of a room as it is kept, with its sign."""
    row = connection.execute(
        "SELECT room, name, records, last, seal FROM log_head WHERE room=?", (room,)
    ).fetchone()
    return None if row is None else (Head._make(row[:4]), row[4])


def keep_head(connection: sqlite3.Connection, key: LogKey, database: bytes, head: Head) -> bytes:
    """Sign and write the head of a room; return the sign."""
    seal = key.sign(HEAD, database, *head)
    connection.execute("INSERT OR REPLACE INTO log_head VALUES (?,?,?,?,?)", (*head, seal))
    return seal


def present(connection: sqlite3.Connection, room: str) -> Head | None:
    """Return the head that a room would have now; None: there is neither a room nor a log."""
    named = connection.execute("SELECT name FROM room WHERE id=?", (room,)).fetchone()
    tail = connection.execute(
        "SELECT seq, hash FROM log WHERE room=? ORDER BY seq DESC LIMIT 1", (room,)
    ).fetchone()
    if named is None and tail is None:
        return None
    records, last = tail or (0, START)
    return Head(room, named[0] if named else "", records, last)


def seals_of_heads(connection: sqlite3.Connection) -> dict[str, bytes]:
    """Return the signs of all heads, in the order of their rooms."""
    return dict(connection.execute("SELECT room, seal FROM log_head ORDER BY room").fetchall())
