"""Time slots of shared robots: who has booked which. Each job is a transaction: one gets it."""

import sqlite3
from typing import Literal, NamedTuple

Became = Literal["booked", "taken", "most"]


class Booked(NamedTuple):
    """A slot that is somebody's."""

    starts: float  # Unix time [s]
    ends: float
    account: int
    name: str


class NotMoved(Exception):  # noqa: N818 -- names the situation
    """The other slot cannot be had: the one of before stays."""

    def __init__(self, why: Became) -> None:
        """Say why."""
        super().__init__(why)
        self.why: Became = why


def book(
    connection: sqlite3.Connection,
    room: str,
    span: tuple[float, float],
    account: int,
    *,
    now: float,
    most: int,
) -> Became:
    """Give somebody a slot, unless another has it or they have as many as they may.

    Args:
        connection: Of the database.
        room: Id of the room.
        span: When the slot starts and ends, Unix time [s].
        account: Whose it becomes.
        now: Unix time [s].
        most: Slots that somebody may have before them.
    """
    starts, ends = span
    (mine,) = connection.execute(
        "SELECT count(*) FROM slot WHERE room=? AND account=? AND ends>?", (room, account, now)
    ).fetchone()
    other = connection.execute(
        "SELECT 1 FROM slot WHERE room=? AND starts<? AND ends>?", (room, ends, starts)
    ).fetchone()
    if other is not None:
        return "taken"
    if mine >= most:
        return "most"
    connection.execute("INSERT INTO slot VALUES (?,?,?,?)", (room, starts, ends, account))
    return "booked"


def cancel(connection: sqlite3.Connection, room: str, starts: float, account: int | None) -> bool:
    """Free a slot, of one account or of anybody (None); return whether it was theirs."""
    gone = connection.execute(
        "DELETE FROM slot WHERE room=? AND starts=? AND (?3 IS NULL OR account=?3)"
        " RETURNING account",
        (room, starts, account),
    ).fetchall()
    return bool(gone)


def move(
    connection: sqlite3.Connection,
    room: str,
    starts: float,
    span: tuple[float, float],
    account: int | None,
    *,
    now: float,
    most: int,
) -> bool:
    """Give who has a slot another one for it; return whether there was such a slot.

    Raises:
        NotMoved: The other one cannot be had; nothing is changed then.
    """
    row = connection.execute(
        "SELECT account FROM slot WHERE room=? AND starts=? AND (?3 IS NULL OR account=?3)",
        (room, starts, account),
    ).fetchone()
    if row is None:
        return False
    cancel(connection, room, starts, None)
    became = book(connection, room, span, row[0], now=now, most=most)
    if became != "booked":
        raise NotMoved(became)  # which undoes it all
    return True


def booked(connection: sqlite3.Connection, room: str, after: float) -> list[Booked]:
    """Return the slots of a room that end later than a time [Unix time, s], in order."""
    rows = connection.execute(
        "SELECT starts, ends, account, name FROM slot JOIN account ON account.id=account"
        " WHERE slot.room=? AND ends>? ORDER BY starts",
        (room, after),
    )
    return [Booked._make(row) for row in rows]


def forget_past(connection: sqlite3.Connection, before: float) -> None:
    """Forget slots that ended before a time [Unix time, s]."""
    connection.execute("DELETE FROM slot WHERE ends<?", (before,))
