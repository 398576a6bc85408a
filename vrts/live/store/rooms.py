"""Rooms and their chat, as they outlast the server."""

import sqlite3
from typing import Final, NamedTuple

import msgspec

from vrts.live.store.seals.connection import naming

PURGES: Final = "purges"  # counter of how often somebody was purged
HISTORY: Final = 200  # lines of chat that late comers see
MOST_SAID: Final = 5000  # lines of chat that a replay shows, the last ones


class KeptRoom(NamedTuple):
    """A room."""

    id: str
    name: str
    scene: str
    place: int  # in the order of rooms
    chat: bool
    turn_s: float
    idle_s: float


class Line(NamedTuple):
    """A line of chat."""

    room: str
    number: int
    at: float
    account: int | None  # None: the server
    name: str
    text: str
    private: bool
    reader: int | None  # account that may read a private line besides supervisors
    reader_name: str = ""  # kept with the account
    supervisor: bool = False  # so is this


def keep_room(connection: sqlite3.Connection, room: KeptRoom) -> None:
    """Write a room as it is now."""
    row = connection.execute("SELECT name FROM room WHERE id=?", (room.id,)).fetchone()
    naming(connection, room.id, row[0] if row else None)
    connection.execute(
        "INSERT INTO room (id, name, scene, place, chat, turn_s, idle_s) VALUES (?,?,?,?,?,?,?)"
        " ON CONFLICT (id) DO UPDATE SET name=excluded.name, scene=excluded.scene,"
        " place=excluded.place, chat=excluded.chat, turn_s=excluded.turn_s,"
        " idle_s=excluded.idle_s",
        room,
    )


def close_room(connection: sqlite3.Connection, room: str) -> None:
    """End a room; its log stays."""
    connection.execute("UPDATE room SET closed=1 WHERE id=?", (room,))


def open_rooms(connection: sqlite3.Connection) -> list[KeptRoom]:
    """Return the rooms that are not closed, in order."""
    rows = connection.execute(
        "SELECT id, name, scene, place, chat, turn_s, idle_s FROM room WHERE NOT closed"
        " ORDER BY place"
    )
    return [KeptRoom._make((*row[:4], bool(row[4]), *row[5:])) for row in rows]


def keep_line(connection: sqlite3.Connection, line: Line) -> None:
    """Write a line of chat."""
    connection.execute("INSERT INTO chat VALUES (?,?,?,?,?,?,?,?)", line[:8])


def lines(connection: sqlite3.Connection, room: str) -> list[Line]:
    """Return the last lines of chat of a room."""
    rows = connection.execute(
        "SELECT chat.*, coalesce(reading.name, ''), coalesce(saying.supervisor, 0) OR EXISTS"
        " (SELECT 1 FROM leads WHERE account=chat.account AND leads.room IN ('', chat.room))"
        " FROM chat"
        " LEFT JOIN account AS reading ON reading.id=reader"
        " LEFT JOIN account AS saying ON saying.id=chat.account"
        " WHERE chat.room=? ORDER BY number DESC LIMIT ?",
        (room, HISTORY),
    ).fetchall()
    return [Line._make((*row[:6], bool(row[6]), *row[7:9], bool(row[9]))) for row in reversed(rows)]


def said_to_all(connection: sqlite3.Connection, room: str) -> list[tuple[float, str, str]]:
    """Return time, name and text of every line of a room's chat that everybody could read."""
    rows = connection.execute(
        "SELECT at, name, text FROM chat WHERE room=? AND NOT private ORDER BY number DESC LIMIT ?",
        (room, MOST_SAID),
    ).fetchall()
    return rows[::-1]


class KeptNote(NamedTuple):
    """A note at a moment of a session."""

    at_s: float
    name: str
    text: str  # JSON


class _Back(msgspec.Struct, frozen=True):
    time_s: float = 0.0


class _WentBack(msgspec.Struct, frozen=True):
    """The text of a record of a session that went back in time."""

    action: _Back


def notes_of(connection: sqlite3.Connection, room: str) -> list[KeptNote]:
    """Return the notes of a room's last session; those of who was purged are gone.

    So are those that lie later than where the session went back to after them.
    """
    rows = connection.execute(
        "SELECT at_s, log_name.name, text, kind FROM log LEFT JOIN log_text USING (room, seq)"
        " LEFT JOIN log_name ON log_name.room=log.room AND log_name.account=log_text.account"
        " WHERE log.room=?1 AND (kind='note' OR kind IN ('reset', 'rewind') AND accepted)"
        " AND seq>(SELECT coalesce(max(seq), 0) FROM log WHERE room=?1 AND kind='begin')"
        " ORDER BY seq",
        (room,),
    )
    found: list[KeptNote] = []
    for at_s, name, text, kind in rows:
        if kind == "rewind":
            back = msgspec.json.decode(text, type=_WentBack).action if text else _Back()
            found = [note for note in found if note.at_s <= back.time_s] if back.time_s else []
        elif kind == "reset":
            found = []
        elif name is not None and text is not None:
            found.append(KeptNote(at_s, name, text))
    return found


def next_number(connection: sqlite3.Connection, name: str) -> int:
    """Return a number that was never returned before, from 1."""
    (value,) = connection.execute(
        "INSERT INTO counter VALUES (?, 1) ON CONFLICT (name) DO UPDATE SET value=value+1"
        " RETURNING value",
        (name,),
    ).fetchone()
    return int(value)
