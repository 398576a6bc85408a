"""Join links and the class code: who may come in by them, how often they did, when they ended."""

import sqlite3
from typing import Final, NamedTuple

from vrts.live.store.accounts import MANY, add_link

ALWAYS: Final = 1e12  # a code ends when it is renewed [Unix time, s]
WRONG: Final = "wrong guesses"  # counter


class KeptLink(NamedTuple):
    """A link, or the class code."""

    id: str
    code: bool  # it is the class code
    supervisor: bool
    room: str | None
    made: float  # Unix time [s]
    expires: float
    uses: int  # that are left; `MANY`: any number
    used: int  # entries so far
    inside: int  # how many accounts of those are there


def links(connection: sqlite3.Connection, now: float) -> list[KeptLink]:
    """Return what lets people in now: the class code first, then the newest."""
    rows = connection.execute(
        "SELECT id, code, supervisor, room, made, expires, uses, used,"
        " (SELECT count(*) FROM account WHERE account.link=link.id) FROM link"
        " WHERE ended IS NULL AND expires>? AND uses<>0 ORDER BY code DESC, made DESC",
        (now,),
    )
    return [KeptLink(r[0], bool(r[1]), bool(r[2]), *r[3:]) for r in rows]


def link(connection: sqlite3.Connection, id_: str, now: float) -> KeptLink | None:
    """Return what is called so, if it lets in anybody."""
    return next((found for found in links(connection, now) if found.id == id_), None)


def end_link(connection: sqlite3.Connection, id_: str, now: float, *, away: bool) -> None:
    """Let nobody in by a link any more.

    Args:
        connection: Of the database.
        id_: What the link is called.
        now: Unix time [s].
        away: Whether those who came in by it are sent away: their cookies end too.
    """
    connection.execute(
        "UPDATE link SET ended=coalesce(ended, ?), away=? WHERE id=?", (now, away, id_)
    )
    if away:
        connection.execute(
            "DELETE FROM login WHERE account IN (SELECT id FROM account WHERE link=?)", (id_,)
        )


def sent_away(connection: sqlite3.Connection, accounts: set[int]) -> set[int]:
    """Return who of some came in by a link whose people were sent away."""
    rows = connection.execute(
        "SELECT account.id FROM account JOIN link ON link.id=account.link WHERE away"
    )
    return accounts & {row[0] for row in rows}


def code_now(connection: sqlite3.Connection) -> bytes | None:
    """Return the digest of the class code; None: there is none."""
    row = connection.execute("SELECT digest FROM link WHERE code AND ended IS NULL").fetchone()
    return None if row is None else bytes(row[0])


def replace_code(
    connection: sqlite3.Connection, text: str, now: float, *, away: bool = False
) -> None:
    """Have another class code (empty: none), and end the one of before."""
    rows = connection.execute("SELECT id FROM link WHERE code AND ended IS NULL").fetchall()
    for (id_,) in rows:
        end_link(connection, id_, now, away=away)
    if text:
        add_link(connection, text, ALWAYS, uses=MANY, code=True, made=now)


def wrong_guesses(connection: sqlite3.Connection) -> int:
    """Return how many wrong guesses at class codes may have been made so far."""
    row = connection.execute("SELECT value FROM counter WHERE name=?", (WRONG,)).fetchone()
    return 0 if row is None else int(row[0])


def keep_wrong_guesses(connection: sqlite3.Connection, count: int) -> None:
    """Keep that so many wrong guesses may have been made; the number never falls."""
    connection.execute(
        "INSERT INTO counter VALUES (?, ?) ON CONFLICT (name)"
        " DO UPDATE SET value=max(value, excluded.value)",
        (WRONG, count),
    )
