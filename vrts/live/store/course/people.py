"""People of a course's lists: who they are, with the account by which the server knows them."""

import sqlite3
from collections.abc import Iterable
from typing import NamedTuple

import msgspec


class Person(NamedTuple):
    """Somebody on a list of the course."""

    account: int
    name: str  # of the account
    key: str  # what the lists call them: e-mail address in lower case, or an id
    email: str
    ids: dict[str, str]  # on platforms
    rank: str  # teacher, assistant, student
    team: str = ""
    subject: str | None = None  # issuer and subject of the log-in provider that they came by
    listed: bool = True  # False: was on a list, and is no more
    called: str = ""  # by the list; the account may have a number behind it
    origin: str = "file"  # or "page": added by a teacher there, and in no file
    rooms: tuple[str, ...] = ()  # names of those that an assistant leads; empty: all


_COLUMNS = (
    "account, account.name, key, email, ids, rank, team, subject, listed, called, origin, rooms"
)
_FROM = "FROM person JOIN account ON account.id=account"


def keep_person(connection: sqlite3.Connection, person: Person) -> None:
    """Write who somebody is; the account is there, and has the name."""
    connection.execute(
        "INSERT INTO person (account, key, email, ids, rank, team, subject, listed, called, origin,"
        " rooms) VALUES (?,?,?,?,?,?,?,?,?,?,?) ON CONFLICT (account) DO UPDATE SET"
        " key=excluded.key, email=excluded.email, ids=excluded.ids, rank=excluded.rank,"
        " team=excluded.team, subject=excluded.subject, listed=excluded.listed,"
        " called=excluded.called, origin=excluded.origin, rooms=excluded.rooms",
        (
            person.account,
            person.key,
            person.email,
            msgspec.json.encode(person.ids).decode(),
            person.rank,
            person.team,
            person.subject,
            person.listed,
            person.called,
            person.origin,
            msgspec.json.encode(person.rooms).decode(),
        ),
    )


def person_of(connection: sqlite3.Connection, account: int) -> Person | None:
    """Return who has an account; None: it is nobody of a list, such as a guest."""
    row = connection.execute(
        f"SELECT {_COLUMNS} {_FROM} WHERE account=?",
        (account,),
    ).fetchone()
    return None if row is None else _person(row)


def people(connection: sqlite3.Connection) -> list[Person]:
    """Return everybody of the lists, those of before too, by name."""
    rows = connection.execute(f"SELECT {_COLUMNS} {_FROM} ORDER BY account.name")
    return [_person(row) for row in rows]


def by_email(connection: sqlite3.Connection, email: str) -> Person | None:
    """Return who has an e-mail address, in any case; who is on a list now goes first."""
    row = connection.execute(
        f"SELECT {_COLUMNS} {_FROM} WHERE email=? AND email<>'' ORDER BY listed DESC, account",
        (email.strip().casefold(),),
    ).fetchone()
    return None if row is None else _person(row)


def name_of(connection: sqlite3.Connection, typed: str) -> str:
    """Return the name of the account that was meant by a name or an e-mail address."""
    found = by_email(connection, typed) if "@" in typed else None
    return typed if found is None else found.name


def by_claim(connection: sqlite3.Connection, claim: str) -> Person | None:
    """Return whom a provider means: somebody listed, by e-mail address or by an id on a list."""
    found = by_email(connection, claim)
    if found is None or not found.listed:
        known = [one for one in people(connection) if one.listed and claim in _ids(one)]
        found = known[0] if len(known) == 1 else None
    return found


def _ids(person: Person) -> set[str]:
    return {value.casefold() for value in person.ids.values()}


def by_subject(connection: sqlite3.Connection, subject: str) -> Person | None:
    """Return who came by a log-in provider before: issuer and subject."""
    row = connection.execute(
        f"SELECT {_COLUMNS} {_FROM} WHERE subject=?",
        (subject,),
    ).fetchone()
    return None if row is None else _person(row)


def lead(connection: sqlite3.Connection, account: int, rooms: Iterable[str]) -> None:
    """Have somebody lead exactly these rooms, by their ids, or `ALL_ROOMS`."""
    connection.execute("DELETE FROM leads WHERE account=?", (account,))
    connection.executemany("INSERT INTO leads VALUES (?,?)", [(account, room) for room in rooms])


def all_leading(connection: sqlite3.Connection) -> dict[int, frozenset[str]]:
    """Return the rooms that assistants lead, by account."""
    found: dict[int, frozenset[str]] = {}
    for account, room in connection.execute("SELECT account, room FROM leads"):
        found[account] = found.get(account, frozenset()) | {room}
    return found


def _person(row: tuple[object, ...]) -> Person:
    known = msgspec.json.decode(str(row[4]), type=dict[str, str])
    rooms = msgspec.json.decode(str(row[11]), type=tuple[str, ...])
    fields = (*row[:4], known, *row[5:8], bool(row[8]), *row[9:11], rooms)
    return msgspec.convert(fields, Person)
