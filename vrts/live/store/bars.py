"""Who may not enter a room any more, and who is not heard: a supervisor said so.

Whoever has an account with a password is known by it. A guest's account is made anew with every use
of the class code, so a new one has the bars of the accounts that its browser had, and of those with
a name that looks the same; and it is muted where its browser was. That holds who just tries again,
not who takes another browser and another name.
"""

import sqlite3
from collections.abc import Iterable
from typing import NamedTuple

from vrts.live.people.skeleton import look

Bars = dict[int, str]  # account: the name under which it was sent away, or muted


class Inherited(NamedTuple):
    """What a new account has of those of its browser."""

    bars: list[tuple[str, str]]  # room, and the name under which it was sent away
    muted: str  # name; empty: it is heard


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


def mute(connection: sqlite3.Connection, account: int, name: str) -> None:
    """Have nobody hear an account."""
    connection.execute("INSERT OR REPLACE INTO muted VALUES (?,?)", (account, name))


def unmute(connection: sqlite3.Connection, name: str) -> None:
    """Let all be heard again who were muted under a name."""
    connection.execute("DELETE FROM muted WHERE name=?", (name,))


def all_muted(connection: sqlite3.Connection) -> Bars:
    """Return who is not heard."""
    return dict(connection.execute("SELECT account, name FROM muted").fetchall())


def use_browser(connection: sqlite3.Connection, accounts: Iterable[int], browser: bytes) -> None:
    """Take note that accounts are used in a browser; `browser` is the digest of its secret."""
    rows = [(account, browser) for account in accounts]
    connection.executemany("INSERT OR IGNORE INTO browser VALUES (?,?)", rows)


def same_browser(connection: sqlite3.Connection, account: int) -> set[int]:
    """Return an account and the guests who have used a browser of it."""
    rows = connection.execute(
        "SELECT other.account FROM browser AS own JOIN browser AS other USING (digest)"
        " JOIN account ON account.id=other.account"
        " WHERE own.account=? AND password IS NULL AND NOT supervisor",
        (account,),
    )
    return {account, *(row[0] for row in rows)}


def inherit(connection: sqlite3.Connection, account: int, name: str) -> Inherited:
    """Keep a new guest out of what others of the same browser, or name, were kept out of.

    Args:
        connection: Of the database.
        account: The new one, whose browser is known.
        name: That was asked for.
    """
    known, same = same_browser(connection, account), look(name)
    rows = connection.execute("SELECT room, name, account FROM barred").fetchall()
    found = {(row[0], row[1]) for row in rows if row[2] in known or same.alike(look(row[1]))}
    for room, barred in found:
        bar(connection, room, account, barred)
    muted = next((as_ for old, as_ in all_muted(connection).items() if old in known), "")
    if muted:
        mute(connection, account, muted)
    return Inherited(sorted(found), muted)
