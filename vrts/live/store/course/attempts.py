"""Hand-ins of a course: each an attempt at an assignment, with its public mark when there is one.

What was handed in is a file of the course's folder; here stands what the board and the pages ask.
"""

import sqlite3
from collections.abc import Iterable
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
    line: int | None = None  # of the program
    time_s: float | None = None  # moment in the run [s]
    hint: str = ""
    why: tuple[str, ...] = ()  # what led to it, the nearest first, as far as the task tells


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
    said: str = ""  # in words: what became of it, where losses do not tell
    variant: str = ""  # tag of the variant that it is marked by; empty: the task has none


_COLUMNS = (
    "account, assignment, number, at, by, digest, state, mark, total, late, said, variant, causes"
)


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


def add_attempts(
    connection: sqlite3.Connection, attempts: Iterable[Attempt], assignment: str
) -> dict[int, int]:
    """Write what was handed in for several people at once; return the number each of them has.

    What is there already stays: that of the same person, time and program is the same hand-in.
    """
    numbers: dict[int, int] = {}
    for one in attempts:
        found = connection.execute(
            "SELECT number FROM attempt WHERE account=? AND assignment=? AND at=? AND digest=?",
            (one.account, assignment, one.at, one.digest),
        ).fetchone()
        if found is not None:
            numbers[one.account] = int(found[0])
            continue
        by = one.account if one.by is None else one.by
        number = add_attempt(connection, one.account, assignment, one.at, by, one.digest)
        numbers[one.account] = number
        keep_mark(connection, one._replace(assignment=assignment, number=number))
    return numbers


def keep_mark(connection: sqlite3.Connection, attempt: Attempt) -> None:
    """Write what became of an attempt."""
    connection.execute(
        "UPDATE attempt SET state=?, mark=?, total=?, late=?, said=?, variant=?, causes=?"
        " WHERE account=? AND assignment=? AND number=?",
        (
            attempt.state,
            attempt.mark,
            attempt.total,
            attempt.late,
            attempt.said,
            attempt.variant,
            msgspec.json.encode(attempt.causes).decode(),
            attempt.account,
            attempt.assignment,
            attempt.number,
        ),
    )


def keep_public_mark(connection: sqlite3.Connection, marked: Attempt) -> None:
    """Write what became of a program, to all attempts with it that wait for their mark.

    What is marked by another variant of the task is another program.
    """
    connection.execute(
        "UPDATE attempt SET state=?, mark=?, total=?, said=?, causes=?"
        " WHERE assignment=? AND digest=? AND variant=? AND state='waiting'",
        (
            marked.state,
            marked.mark,
            marked.total,
            marked.said,
            msgspec.json.encode(marked.causes).decode(),
            marked.assignment,
            marked.digest,
            marked.variant,
        ),
    )


def waiting(connection: sqlite3.Connection) -> list[Attempt]:
    """Return the attempts that wait for their mark, in the order of time."""
    rows = connection.execute(
        f"SELECT {_COLUMNS} FROM attempt WHERE state='waiting' ORDER BY at, account"  # noqa: S608
    )
    return [_attempt(row) for row in rows]


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
    *first, said, variant, causes = row
    found = msgspec.json.decode(str(causes), type=tuple[Loss, ...])
    return msgspec.convert((*first, found, said, variant), Attempt)
