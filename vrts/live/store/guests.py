"""Guests: accounts without a password, of which there is only so much room.

Who comes in by a right code or link is never turned away because others came before. When all
places are taken, the place goes of who needs it least: whose cookie has expired, who never joined a
room, who stayed less than a minute, who was not seen for longest. Who is in a room keeps it. With
the place go the guest's own programs, which nobody else can see.
"""

import json
import sqlite3
from collections.abc import Iterable
from typing import Final, NamedTuple

from vrts.live.store.accounts import GUESTS, LOGIN_S, Account, enter, lets_in
from vrts.live.store.programs import own_shelf

BRIEF_S: Final = 60.0  # who stayed less than that has hardly worked
IDLE_S: Final = 7 * 86_400.0  # who was not seen for longer counts as idle


class Crowd(NamedTuple):
    """How many guests there are."""

    guests: int
    unused: int  # never joined a room
    idle: int  # were not seen for a week


def come_in(
    connection: sqlite3.Connection,
    token: str,
    name: str,
    now: float,
    *,
    here: Iterable[int],
    most: int = GUESTS,
) -> Account | None:
    """Let somebody in by a link or code, if need be in place of another; None: it is not right.

    Raises:
        ValueError: The name cannot be shown, or all places are of people who are in rooms.
    """
    if not lets_in(connection, token, now):
        return None  # who is wrong takes nobody's place
    make_place(connection, here, now, most)
    return enter(connection, token, name, now)


def make_place(
    connection: sqlite3.Connection, here: Iterable[int], now: float, most: int = GUESTS
) -> int | None:
    """Give up a guest's place where all are taken; return whose, None: that was not needed."""
    (guests,) = connection.execute("SELECT count(*) FROM account WHERE password IS NULL").fetchone()
    if guests < most:
        return None
    row = connection.execute(
        "SELECT id FROM account WHERE password IS NULL AND NOT supervisor"
        " AND id NOT IN (SELECT value FROM json_each(?))"
        " ORDER BY created>?, seen>0, stayed_s>=?, CASE WHEN seen>0 THEN seen ELSE created END"
        " LIMIT 1",
        (json.dumps(sorted(here)), now - LOGIN_S, BRIEF_S),
    ).fetchone()
    if row is None:
        return None
    _remove(connection, [int(row[0])])
    return int(row[0])


def give_up_unused(connection: sqlite3.Connection, accounts: Iterable[int]) -> None:
    """Give up places of guests who never joined a room."""
    rows = connection.execute(
        "SELECT id FROM account WHERE password IS NULL AND NOT supervisor AND seen=0"
        " AND id IN (SELECT value FROM json_each(?))",
        (json.dumps(sorted(accounts)),),
    )
    _remove(connection, [row[0] for row in rows])


def _remove(connection: sqlite3.Connection, accounts: list[int]) -> None:
    """Remove guests and their own programs; what they saved in rooms belongs to the rooms."""
    for account in accounts:
        connection.execute("DELETE FROM program_version WHERE shelf=?", (own_shelf(account),))
        connection.execute("DELETE FROM account WHERE id=?", (account,))


def unused(connection: sqlite3.Connection) -> list[int]:
    """Return the guests who never joined a room, the oldest first."""
    rows = connection.execute(
        "SELECT id FROM account WHERE password IS NULL AND NOT supervisor AND seen=0 ORDER BY id"
    )
    return [row[0] for row in rows]


def saw(connection: sqlite3.Connection, account: int, now: float, stayed_s: float = 0.0) -> None:
    """Keep when somebody was in a room, and for how much longer than was known."""
    connection.execute(
        "UPDATE account SET seen=max(seen, ?), stayed_s=stayed_s+? WHERE id=?",
        (now, stayed_s, account),
    )


def crowd(connection: sqlite3.Connection, now: float) -> Crowd:
    """Count the guests."""
    row = connection.execute(
        "SELECT count(*), total(seen=0), total(seen>0 AND seen<?) FROM account"
        " WHERE password IS NULL AND NOT supervisor",
        (now - IDLE_S,),
    ).fetchone()
    return Crowd(*(int(count) for count in row))


def log_guests_out(connection: sqlite3.Connection) -> list[int]:
    """End the cookies of all guests; return who had one."""
    rows = connection.execute(
        "DELETE FROM login WHERE account IN"
        " (SELECT id FROM account WHERE password IS NULL AND NOT supervisor) RETURNING account"
    ).fetchall()
    return sorted({row[0] for row in rows})
