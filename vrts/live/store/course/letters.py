"""Links with which somebody of a course comes in for the first time and chooses a password.

Each works once. Only its digest is kept; a later one of the same person ends it.
"""

import sqlite3
from typing import Final

from vrts.live.store.accounts import NOT_CHOSEN
from vrts.live.store.course.people import Person, person_of
from vrts.live.tokens import digest, new_token

LETTER_S: Final = 60 * 86_400.0  # how long one works


def new_letter(connection: sqlite3.Connection, account: int, now: float) -> str:
    """Return the token of a new link for somebody."""
    token = new_token()
    connection.execute(
        "INSERT OR REPLACE INTO letter VALUES (?,?,?,?)",
        (account, digest(token), now, now + LETTER_S),
    )
    return token


def end_letter(connection: sqlite3.Connection, token: str) -> None:
    """End a link."""
    connection.execute("DELETE FROM letter WHERE digest=?", (digest(token),))


def has_letter(connection: sqlite3.Connection, account: int, now: float) -> bool:
    """Return whether somebody has a link that works."""
    row = connection.execute(
        "SELECT 1 FROM letter WHERE account=? AND expires>?", (account, now)
    ).fetchone()
    return row is not None


def has_password(connection: sqlite3.Connection, account: int) -> bool:
    """Return whether somebody has chosen a password."""
    row = connection.execute(
        "SELECT 1 FROM account WHERE id=? AND password<>?", (account, NOT_CHOSEN)
    ).fetchone()
    return row is not None


def whose_letter(connection: sqlite3.Connection, token: str, now: float) -> Person | None:
    """Return whose link has a token and works; None: nobody's, or of somebody on no list now."""
    row = connection.execute(
        "SELECT account FROM letter WHERE digest=? AND expires>?", (digest(token), now)
    ).fetchone()
    person = None if row is None else person_of(connection, row[0])
    return person if person is not None and person.listed else None


def choose_password(
    connection: sqlite3.Connection, token: str, password: str, now: float
) -> Person | None:
    """Use a link: give its person a password, a hash, and end their log-ins of before.

    Returns:
        Whose it was; None: it does not work any more, and nothing was changed.
    """
    person = whose_letter(connection, token, now)
    if person is None:
        return None
    connection.execute("UPDATE account SET password=? WHERE id=?", (password, person.account))
    connection.execute("DELETE FROM letter WHERE account=?", (person.account,))
    connection.execute("DELETE FROM login WHERE account=?", (person.account,))
    return person
