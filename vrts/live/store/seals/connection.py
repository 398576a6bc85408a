"""A connection that remembers which logs a transaction changes, and signs what it is asked to."""

import sqlite3
from collections.abc import Callable
from typing import Any, NamedTuple

from vrts.live.store.seals.key import Field


class Touched(NamedTuple):
    """A room that is changed, as it was when the transaction began."""

    records: int | None = None  # of its log; None: nothing is appended
    last: bytes | None = None  # hash of the last one
    name: str | None = None  # None: it is not named
    named: bool = False


class SealedConnection(sqlite3.Connection):
    """Of one thread. Without a `sign` nothing is signed."""

    def __init__(self, *given: Any, **options: Any) -> None:
        """Open a database."""
        super().__init__(*given, **options)
        self.sign: Callable[..., bytes] | None = None
        self.touched: dict[str, Touched] = {}  # in this transaction


def appending(connection: sqlite3.Connection, room: str, records: int, last: bytes) -> None:
    """Take note that a record is appended to a log, as it was before."""
    if isinstance(connection, SealedConnection):
        found = connection.touched.get(room, Touched())
        if found.records is None:
            connection.touched[room] = found._replace(records=records, last=last)


def naming(connection: sqlite3.Connection, room: str, name: str | None) -> None:
    """Take note that a room is kept, and of the name that it had; None: it is new."""
    if isinstance(connection, SealedConnection):
        found = connection.touched.get(room, Touched())
        if not found.named:
            connection.touched[room] = found._replace(name=name, named=True)


def signature(connection: sqlite3.Connection, kind: str, *fields: Field) -> bytes:
    """Return the sign of some fields; empty where there is no key."""
    if isinstance(connection, SealedConnection) and connection.sign is not None:
        return connection.sign(kind, *fields)
    return b""
