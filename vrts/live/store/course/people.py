"""People of a course's lists: who they are, with the account by which the server knows them."""

import sqlite3
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


_COLUMNS = "account, account.name, key, email, ids, rank, team, subject, listed"
_FROM = "FROM person JOIN account ON account.id=account"


def keep_person(connection: sqlite3.Connection, person: Person) -> None:
    """Write who somebody is; the account is there, and has the name."""
    connection.execute(
        "INSERT INTO person (account, key, email, ids, rank, team, subject, listed)"
        " VALUES (?,?,?,?,?,?,?,?) ON CONFLICT (account) DO UPDATE SET key=excluded.key,"
        " email=excluded.email, ids=excluded.ids, rank=excluded.rank, team=excluded.team,"
        " subject=excluded.subject, listed=excluded.listed",
        (
            person.account,
            person.key,
            person.email,
            msgspec.json.encode(person.ids).decode(),
            person.rank,
            person.team,
            person.subject,
            person.listed,
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


def _person(row: tuple[object, ...]) -> Person:
    account, name, key, email, ids, rank, team, subject, listed = row
    known = msgspec.json.decode(str(ids), type=dict[str, str])
    return msgspec.convert(
        (account, name, key, email, known, rank, team, subject, bool(listed)), Person
    )
