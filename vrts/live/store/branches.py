"""Private rooms: whose each is, and from which moment of which room it goes on."""

import sqlite3
from typing import NamedTuple


class Branch(NamedTuple):
    """What makes a room a private one."""

    room: str
    owner: int | None  # account; None: purged, so that only supervisors may enter
    origin: str  # id of the room whose session it goes on from
    at_s: float  # from this session time on [s]
    variant: str = ""  # tag of the variant of its task; empty: the task as it is written


def keep_branch(connection: sqlite3.Connection, branch: Branch) -> None:
    """Write that a room is private."""
    connection.execute("INSERT INTO branch VALUES (?,?,?,?,?)", branch)


def branch_of(connection: sqlite3.Connection, room: str) -> Branch | None:
    """Return what makes a room private; None: it is none."""
    row = connection.execute("SELECT * FROM branch WHERE room=?", (room,)).fetchone()
    return None if row is None else Branch._make(row)


class CopiedRow(NamedTuple):
    """A record of a log, with all that a copy needs."""

    seq: int
    session: int  # number of the session
    at_s: float
    wall: float
    kind: str
    accepted: bool
    account: int | None  # None: the server itself, or purged
    name: str | None
    text: str | None  # None: purged


def rows_to_copy(connection: sqlite3.Connection, room: str) -> list[CopiedRow]:
    """Return the records of a room since its last session began."""
    rows = connection.execute(
        "SELECT log.seq, session, at_s, wall, kind, accepted, log_text.account, log_name.name, text"
        " FROM log"
        " LEFT JOIN log_text USING (room, seq)"
        " LEFT JOIN log_name ON log_name.room=log.room AND log_name.account=log_text.account"
        " WHERE log.room=?1"
        " AND log.seq>=(SELECT max(seq) FROM log WHERE room=?1 AND kind='begin')"
        " ORDER BY log.seq",
        (room,),
    )
    return [CopiedRow._make((*row[:5], bool(row[5]), *row[6:])) for row in rows]
