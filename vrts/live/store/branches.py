"""Private rooms: whose each is, and from which moment of which room it goes on."""

import sqlite3
from typing import NamedTuple


class Branch(NamedTuple):
    """What makes a room a private one."""

    room: str
    owner: int | None  # account; None: purged, so that only supervisors may enter
    origin: str  # id of the room whose session it goes on from
    at_s: float  # from this session time on [s]


def keep_branch(connection: sqlite3.Connection, branch: Branch) -> None:
    """Write that a room is private."""
    connection.execute("INSERT INTO branch VALUES (?,?,?,?)", branch)


def branch_of(connection: sqlite3.Connection, room: str) -> Branch | None:
    """Return what makes a room private; None: it is none."""
    row = connection.execute("SELECT * FROM branch WHERE room=?", (room,)).fetchone()
    return None if row is None else Branch._make(row)
