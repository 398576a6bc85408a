"""Hand-ins of a course: each an attempt at an assignment, with its public mark when there is one.

What was handed in is a file of the course's folder; here stands what the board and the pages ask.
"""

import sqlite3
from functools import lru_cache
from typing import Final, Literal, NamedTuple

import msgspec

State = Literal["waiting", "marked", "refused", "failed"]
LONGEST_CAUSE: Final = 200  # characters
REMEMBERED: Final = 65_536  # rows that need not be read anew


class Loss(NamedTuple):
    """Points lost, and by what."""

    cause: str  # as the public report says it
    points: str  # a fraction


class Attempt(NamedTuple):
    """A hand-in."""

    account: int  # whose mark it is
    assignment: str
    number: int  # from 1
    at: float  # Unix time [s]
    by: int | None  # account that handed it in, of the same team; None: purged
    digest: str  # sha256 of the program
    state: str  # of `State`
    mark: str | None = None  # public, before lateness: a fraction
    total: str | None = None
    late: str = ""  # in words
    causes: tuple[Loss, ...] = ()


_COLUMNS = "account, assignment, number, at, by, digest, state, mark, total, late, causes"


def add_attempt(
    connection: sqlite3.Connection, account: int, assignment: str, at: float, by: int, digest: str
) -> int:
    """Write that something was handed in; return the number of the attempt."""
    (number,) = connection.execute(
        "SELECT coalesce(max(number), 0) + 1 FROM attempt WHERE account=? AND assignment=?",
        (account, assignment),
    ).fetchone()
    connection.execute(
        "INSERT INTO attempt (account, assignment, number, at, by, digest, state)"
        " VALUES (?,?,?,?,?,?,'waiting')",
        (account, assignment, number, at, by, digest),
    )
    return int(number)


def keep_mark(connection: sqlite3.Connection, attempt: Attempt) -> None:
    """Write what became of an attempt."""
    connection.execute(
        "UPDATE attempt SET state=?, mark=?, total=?, late=?, causes=?"
        " WHERE account=? AND assignment=? AND number=?",
        (
            attempt.state,
            attempt.mark,
            attempt.total,
            attempt.late,
            msgspec.json.encode(attempt.causes).decode(),
            attempt.account,
            attempt.assignment,
            attempt.number,
        ),
    )


def attempts_of(
    connection: sqlite3.Connection, account: int, assignment: str | None = None
) -> list[Attempt]:
    """Return the attempts of somebody, at one assignment or all, in the order of time."""
    rows = connection.execute(
        f"SELECT {_COLUMNS} FROM attempt WHERE account=?1"  # noqa: S608 -- constants
        " AND (?2 IS NULL OR assignment=?2) ORDER BY at, number",
        (account, assignment),
    )
    return [_attempt(row) for row in rows]


def all_attempts(connection: sqlite3.Connection, assignment: str | None = None) -> list[Attempt]:
    """Return the attempts of everybody, at one assignment or all, in the order of time."""
    rows = connection.execute(
        f"SELECT {_COLUMNS} FROM attempt WHERE ?1 IS NULL OR assignment=?1"  # noqa: S608
        " ORDER BY at, account, number",
        (assignment,),
    )
    return [_attempt(row) for row in rows]


def state_of(connection: sqlite3.Connection) -> tuple[object, ...]:
    """Return what is another value when people or attempts are others: quick to ask."""
    row: tuple[object, ...] = connection.execute(
        "SELECT count(*), total(state='waiting'), max(at), total(length(causes)),"
        " (SELECT count(*) FROM person), (SELECT total(listed) FROM person),"
        " (SELECT group_concat(team) FROM person) FROM attempt"
    ).fetchone()
    return row


@lru_cache(maxsize=REMEMBERED)
def _attempt(row: tuple[object, ...]) -> Attempt:
    causes = msgspec.json.decode(str(row[-1]), type=tuple[Loss, ...])
    return msgspec.convert((*row[:-1], causes), Attempt)
