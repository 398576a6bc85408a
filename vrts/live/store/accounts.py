"""Accounts, log-ins and join links. Secrets are kept as digests."""

import json
import sqlite3
from collections.abc import Awaitable, Callable, Iterable
from typing import Final, NamedTuple

from vrts.live.names import display_name
from vrts.live.people.naming import Taken, own_name, person_name
from vrts.live.tokens import digest, new_id, new_token

LOGIN_S: Final = 30 * 86_400.0  # how long a cookie lasts
ONCE_S: Final = 12 * 3600.0  # how long a link for one browser lets in
LINK_S: Final = 200 * 86_400.0  # how long a link for many does, unless it is ended before
MANY: Final = -1  # uses: any number
GUESTS: Final = 5000  # accounts without a password at most
NOT_CHOSEN: Final = ""  # as the hash of a password: the account has none yet, and is no guest's
ALL_ROOMS: Final = ""  # in place of a room's id, in what somebody leads


class Account(NamedTuple):
    """Somebody."""

    id: int
    name: str
    supervisor: bool  # everywhere, the ways in too
    room: str | None  # the only one that may be entered
    leads: frozenset[str] = frozenset()  # ids of the rooms that an assistant leads, or `ALL_ROOMS`

    def leads_in(self, room: str) -> bool:
        """Return whether they may do in a room what a supervisor may do there."""
        return self.supervisor or not self.leads.isdisjoint((room, ALL_ROOMS))

    @property
    def leads_any(self) -> bool:
        """Whether there is a room that they lead."""
        return self.supervisor or bool(self.leads)


_COLUMNS: Final = (
    "account.id, account.name, account.supervisor, account.room,"
    " (SELECT group_concat(leads.room, char(10)) FROM leads WHERE leads.account=account.id)"
)
# who was on a list of the course, and is no more, keeps everything and stays outside
_COMES_IN: Final = (
    "NOT EXISTS (SELECT 1 FROM person WHERE person.account=account.id AND NOT listed)"
)
Who = Callable[[dict[str, str]], Awaitable[Account | None]]  # whose cookies these are


def add_account(
    connection: sqlite3.Connection,
    name: str,
    now: float,
    *,
    password: str | None = None,
    supervisor: bool = False,
    room: str | None = None,
    link: str | None = None,
) -> Account:
    """Make an account; `password` is a hash, `link` what the link is called that it came in by.

    Raises:
        ValueError: The name cannot be shown, or there are too many guests.
    """
    shown = person_name(name)
    if not shown:
        raise ValueError("a name needs a letter or a digit")
    rows = connection.execute("SELECT name, password IS NULL FROM account").fetchall()
    others = [row[0] for row in rows]
    if password is None:
        if sum(row[1] for row in rows) >= GUESTS:
            raise ValueError("there are too many guests")
        shown = own_name(shown, Taken(others), guest=not supervisor)
    elif shown in others:
        raise ValueError(f"there is an account `{shown}` already")
    id_ = _new_id(connection)
    connection.execute(
        "INSERT INTO account (id, name, password, supervisor, room, created, link)"
        " VALUES (?,?,?,?,?,?,?)",
        (id_, shown, password, supervisor, room, now, link),
    )
    return Account(id_, shown, supervisor, room)


def password_of(connection: sqlite3.Connection, name: str) -> tuple[Account, str] | None:
    """Return an account by its name, with the hash of its password."""
    row = connection.execute(
        f"SELECT {_COLUMNS}, password FROM account"  # noqa: S608 -- of ours
        " WHERE name IN (?,?) AND password NOT NULL",
        (person_name(name), display_name(name)),  # as it is kept now, and as it was before
    ).fetchone()
    return None if row is None else (_account(row[:5]), row[5])


def account_of(connection: sqlite3.Connection, id_: int) -> Account | None:
    """Return an account; None: it is gone, or of somebody who may not come in any more."""
    row = connection.execute(
        f"SELECT {_COLUMNS} FROM account WHERE id=? AND {_COMES_IN}",  # noqa: S608 -- of ours
        (id_,),
    ).fetchone()
    return None if row is None else _account(row)


def log_in(connection: sqlite3.Connection, account: int, now: float) -> str:
    """Return a new token for an account's cookie."""
    connection.execute("DELETE FROM login WHERE expires<?", (now,))
    token = new_token()
    connection.execute("INSERT INTO login VALUES (?,?,?)", (digest(token), account, now + LOGIN_S))
    return token


def who(connection: sqlite3.Connection, token: str, now: float) -> Account | None:
    """Return whose cookie holds a token."""
    row = connection.execute(
        f"SELECT {_COLUMNS} FROM login JOIN account ON login.account=account.id"  # noqa: S608 -- ours
        f" WHERE digest=? AND expires>? AND {_COMES_IN}",
        (digest(token), now),
    ).fetchone()
    return None if row is None else _account(row)


def log_out(connection: sqlite3.Connection, token: str) -> None:
    """End one cookie."""
    connection.execute("DELETE FROM login WHERE digest=?", (digest(token),))


def knows(connection: sqlite3.Connection, account: int, browser: bytes) -> bool:
    """Return whether somebody was logged in to an account with a browser of this digest."""
    row = connection.execute(
        "SELECT 1 FROM browser WHERE account=? AND digest=?", (account, browser)
    ).fetchone()
    return row is not None


def add_link(
    connection: sqlite3.Connection,
    token: str,
    expires: float,
    *,
    supervisor: bool = False,
    room: str | None = None,
    name: str | None = None,
    uses: int = 1,
    code: bool = False,
    made: float = 0.0,
) -> str:
    """Let who knows a token or code enter; return what the link is called.

    Args:
        connection: Of the database.
        token: What they know.
        expires: Until when it lets in, Unix time [s].
        supervisor: Whether they may supervise.
        room: The only one that they may enter.
        name: That they have; without one they say it.
        uses: How often it lets in, or `MANY`.
        code: Whether it is the class code.
        made: When it was made, Unix time [s].
    """
    id_ = new_id()
    connection.execute(
        "INSERT INTO link (digest, supervisor, room, name, uses, expires, id, made, code)"
        " VALUES (?,?,?,?,?,?,?,?,?)",
        (digest(token), supervisor, room, name, uses, expires, id_, made, code),
    )
    return id_


def lets_in(connection: sqlite3.Connection, token: str, now: float) -> bool:
    """Return whether there is such a link or code now."""
    return _link_of(connection, token, now) is not None


def lets_supervise(connection: sqlite3.Connection, token: str, now: float) -> bool:
    """Return whether a token is that of a supervisor's link, which works now."""
    row = _link_of(connection, token, now)
    return row is not None and bool(row[0])


def enter(connection: sqlite3.Connection, token: str, name: str, now: float) -> Account | None:
    """Use a link or code; return the new account, None when there is no such link any more.

    Raises:
        ValueError: The name cannot be shown.
    """
    row = _link_of(connection, token, now)
    if row is None:
        return None
    supervisor, room, own, link = row
    connection.execute(
        "UPDATE link SET uses=uses-(uses>0), used=used+1 WHERE digest=?", (digest(token),)
    )
    return add_account(
        connection, own or name, now, supervisor=bool(supervisor), room=room, link=link
    )


def existing(connection: sqlite3.Connection, accounts: Iterable[int]) -> set[int]:
    """Return which of some accounts are there."""
    found = connection.execute(
        "SELECT id FROM account WHERE id IN (SELECT value FROM json_each(?))",
        (json.dumps(sorted(accounts)),),
    )
    return {row[0] for row in found}


def _link_of(
    connection: sqlite3.Connection, token: str, now: float
) -> tuple[int, str | None, str | None, str] | None:
    """Return supervisor, room, name and id of the link or code that lets in by a token."""
    row: tuple[int, str | None, str | None, str] | None = connection.execute(
        "SELECT supervisor, room, name, id FROM link"
        " WHERE digest=? AND expires>? AND uses<>0 AND ended IS NULL",
        (digest(token), now),
    ).fetchone()
    return row


def _account(row: tuple[int, str, int, str | None, str | None]) -> Account:
    leads = () if row[4] is None else row[4].split("\n")
    return Account(row[0], row[1], bool(row[2]), row[3], frozenset(leads))


def _new_id(connection: sqlite3.Connection) -> int:
    """Return a number that no account ever had: what is kept of who is gone stays theirs."""
    (last,) = connection.execute("SELECT coalesce(max(id), 0) FROM account").fetchone()
    (found,) = connection.execute(
        "INSERT INTO counter VALUES ('account', ?1 + 1)"
        " ON CONFLICT (name) DO UPDATE SET value=max(value, ?1) + 1 RETURNING value",
        (last,),
    ).fetchone()
    return int(found)
