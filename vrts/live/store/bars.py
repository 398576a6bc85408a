"""Who may not enter a room any more: a supervisor has sent them away.

Whoever has an account is known by it. A guest's account is made anew with every use of the class
code, so a new one has the bars of the accounts that its browser had, and of those with its name.
That keeps out who just tries again, not who takes another browser and another name.
"""

import sqlite3
from collections.abc import Iterable

Bars = dict[int, str]  # account: the name under which it was sent away


def bar(connection: sqlite3.Connection, room: str, account: int, name: str) -> None:
    """Keep an account out of a room."""
    connection.execute("INSERT OR REPLACE INTO barred VALUES (?,?,?)", (room, account, name))


def allow(connection: sqlite3.Connection, room: str, name: str) -> None:
    """Let all in again who were kept out of a room under a name."""
    connection.execute("DELETE FROM barred WHERE room=? AND name=?", (room, name))


def bars_of(connection: sqlite3.Connection, room: str) -> Bars:
    """Return who may not enter a room."""
    rows = connection.execute("SELECT account, name FROM barred WHERE room=?", (room,))
    return dict(rows.fetchall())


def inherit(
    connection: sqlite3.Connection, account: int, name: str, before: Iterable[int]
) -> list[tuple[str, str]]:
    """Keep a new account out of the rooms of which others were kept out; return room and name.

    Args:
        connection: Of the database.
        account: The new one.
        name: That was asked for.
        before: Accounts that the same browser had.
    """
    rows = connection.execute("SELECT room, name, account FROM barred").fetchall()
    known, same = frozenset(before), name.casefold()
    found = {
        (room, barred) for room, barred, old in rows if old in known or barred.casefold() == same
    }
    for room, barred in found:
        bar(connection, room, account, barred)
    return sorted(found)
