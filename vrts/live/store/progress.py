"""How far sessions have come, and what was done in the last one of a room: to carry it on."""

import json
import sqlite3
from collections.abc import Iterable
from typing import NamedTuple


class Reached(NamedTuple):
    """A session time that was reached."""

    room: str
    session: int  # number
    time_s: float


class Kept(NamedTuple):
    """A record of the log of a room, as far as a session needs it."""

    seq: int
    session: int
    kind: str
    account: int | None  # None: the server itself, or purged
    text: str | None  # None: purged


class Slept(NamedTuple):
    """The record of the log that a room fell asleep."""

    seq: int
    session: int
    content: bytes  # digest of the text
    salt: bytes
    text: str | None  # None: purged


def last_sleep(connection: sqlite3.Connection, room: str, beside: Iterable[str]) -> Slept | None:
    """Return when a room fell asleep, if nothing was done in it since; None: it is awake.

    Args:
        connection: Of the database.
        room: The room's id.
        beside: Kinds of records that nothing was done by.
    """
    last = connection.execute(
        "SELECT seq, kind FROM log WHERE room=?"
        " AND kind NOT IN (SELECT value FROM json_each(?)) ORDER BY seq DESC LIMIT 1",
        (room, json.dumps(sorted(beside))),
    ).fetchone()
    if last is None or last[1] != "sleep":
        return None
    row = connection.execute(
        "SELECT seq, session, content, salt, text FROM log LEFT JOIN log_text USING (room, seq)"
        " WHERE room=? AND seq=?",
        (room, last[0]),
    ).fetchone()
    return Slept._make(row)


def keep_reached(connection: sqlite3.Connection, reached: Iterable[Reached]) -> None:
    """Write how far sessions have come, each since the last record of its room's log."""
    connection.executemany(
        "INSERT INTO reached VALUES (?1,?2,?3,(SELECT max(seq) FROM log WHERE room=?1))"
        " ON CONFLICT (room) DO UPDATE SET session=excluded.session, time_s=excluded.time_s,"
        " seq=excluded.seq",
        reached,
    )


def reached(connection: sqlite3.Connection, room: str, session: int, since: int) -> float:
    """Return how far a session has come [s], if that is known since a record; else 0."""
    row = connection.execute(
        "SELECT time_s FROM reached WHERE room=? AND session=? AND seq>=?", (room, session, since)
    ).fetchone()
    return float(row[0]) if row else 0.0


def rooms_with_logs(connection: sqlite3.Connection) -> list[tuple[str, str]]:
    """Return id and name of every room, closed ones too, in order."""
    return connection.execute("SELECT id, name FROM room ORDER BY place, id").fetchall()


def all_records(connection: sqlite3.Connection, room: str) -> list[Kept]:
    """Return all records of a room."""
    rows = connection.execute(
        "SELECT seq, session, kind, account, text FROM log LEFT JOIN log_text USING (room, seq)"
        " WHERE room=? ORDER BY seq",
        (room,),
    )
    return [Kept._make(row) for row in rows]


def last_session(connection: sqlite3.Connection, room: str) -> list[Kept]:
    """Return the records of a room since its last session began; none: there was no session."""
    rows = connection.execute(
        "SELECT seq, session, kind, account, text FROM log LEFT JOIN log_text USING (room, seq)"
        " WHERE room=?1 AND seq>=(SELECT max(seq) FROM log WHERE room=?1 AND kind='begin')"
        " ORDER BY seq",
        (room,),
    )
    return [Kept._make(row) for row in rows]
