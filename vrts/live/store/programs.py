"""Programs that people write in the page: every save is a version, and none is lost unseen.

A shelf is where programs lie: one's own, or that of a room, which all who may enter it share. What
a person has saved counts against that person alone, so nobody pushes out what others saved. When a
room is closed, its shelf ends: the newest that each person saved there goes to their own,
under a name with the room's where they have another text of that name.
"""

import logging
import math
import re
import sqlite3
from typing import Final, NamedTuple

MOST_VERSIONS: Final = 300  # that one person has saved, everywhere
MOST_CHARACTERS: Final = 4_000_000  # of them all together
MOST_OF_A_PROGRAM: Final = 100  # versions of one program that one person has saved
LONGEST_NAME: Final = 40  # characters
MOST_OF_A_SHELF: Final = 200  # programs of a room
MOST_OF_A_ROOM: Final = 20_000_000  # characters, of all versions
MOST_OF_GUESTS: Final = 400_000_000  # characters, of all that have no password together
ROOM_IN_NAME: Final = 16  # characters of a room's name in that of a program
COUNT_S: Final = 60.0  # how often what guests have is counted at most: that reads it all
_log = logging.getLogger("vrts.live")


class Version(NamedTuple):
    """One save."""

    name: str  # of the program
    number: int  # from 1
    at: float  # when, by the clock of the wall [s]
    account: int | None  # who; None: purged
    saver: str  # name of that person then; empty: purged
    length: int  # characters


class Outcome(NamedTuple):
    """What became of a save."""

    version: Version | None  # the newest now; None: nothing is kept under that name
    saved: bool  # false: there is a version that the saver has not seen
    full: bool = False  # nothing more fits into what a person may keep


def own_shelf(account: int) -> str:
    """Return the shelf of a person."""
    return f"own {account}"


def room_shelf(room: str) -> str:
    """Return the shelf of a room."""
    return f"room {room}"


def programs(connection: sqlite3.Connection, shelf: str) -> list[Version]:
    """Return the newest version of every program of a shelf, by name."""
    rows = connection.execute(
        "SELECT name, number, at, account, saver, coalesce(length(text), 0)"
        " FROM program_version AS one WHERE shelf=? AND number=("
        "SELECT max(number) FROM program_version WHERE shelf=one.shelf AND name=one.name)"
        " ORDER BY name",
        (shelf,),
    )
    return [Version._make(row) for row in rows]


def versions(connection: sqlite3.Connection, shelf: str, name: str) -> list[Version]:
    """Return all that is kept of a program, the newest first."""
    rows = connection.execute(
        "SELECT name, number, at, account, saver, coalesce(length(text), 0)"
        " FROM program_version WHERE shelf=? AND name=? ORDER BY number DESC",
        (shelf, name),
    )
    return [Version._make(row) for row in rows]


def text_of(connection: sqlite3.Connection, shelf: str, name: str, number: int) -> str | None:
    """Return a version; None where there is none, or it was purged."""
    row = connection.execute(
        "SELECT text FROM program_version WHERE shelf=? AND name=? AND number=?",
        (shelf, name, number),
    ).fetchone()
    return row[0] if row else None


def save(
    connection: sqlite3.Connection, shelf: str, version: Version, text: str, seen: int
) -> Outcome:
    """Keep a text as the next version of a program.

    Args:
        connection: To the database.
        shelf: Where the program lies.
        version: Name, time and saver; its number and length are found here.
        text: The program.
        seen: Number of the newest version that the saver knows of; 0: of none.
    """
    newest = next(iter(versions(connection, shelf, version.name)), None)
    if newest is not None:
        if newest.number != seen:
            return Outcome(newest, saved=False)
        if text_of(connection, shelf, version.name, newest.number) == text:
            return Outcome(newest, saved=True)  # nothing is new
    number = 1 if newest is None else newest.number + 1
    kept = version._replace(number=number, length=len(text))
    connection.execute(
        "INSERT INTO program_version VALUES (?,?,?,?,?,?,?)",
        (shelf, kept.name, number, kept.at, kept.account, kept.saver, text),
    )
    if kept.account is not None and not _made_room(connection, kept.account, shelf, kept.name):
        connection.execute(
            "DELETE FROM program_version WHERE shelf=? AND name=? AND number=?",
            (shelf, kept.name, number),
        )
        return Outcome(newest, saved=False, full=True)
    return Outcome(kept, saved=True)


def remove(connection: sqlite3.Connection, shelf: str, name: str) -> None:
    """Forget a program with all its versions."""
    connection.execute("DELETE FROM program_version WHERE shelf=? AND name=?", (shelf, name))


def end_shelf(connection: sqlite3.Connection, room: str) -> None:
    """Give what lies on the shelf of a room to who saved it: of each program their newest.

    Older versions go, and what is of nobody any more.
    """
    shelf = room_shelf(room)
    rows = connection.execute(
        "SELECT name, number, at, account, saver, length(text), text FROM program_version AS one"
        " WHERE shelf=? AND text NOT NULL AND account IN (SELECT id FROM account) AND number=("
        "SELECT max(number) FROM program_version"
        " WHERE shelf=one.shelf AND name=one.name AND account=one.account)",
        (shelf,),
    ).fetchall()
    connection.execute("DELETE FROM program_version WHERE shelf=?", (shelf,))
    for *columns, text in rows:
        version = Version._make(columns)
        assert version.account is not None
        own = own_shelf(version.account)
        name = _free_name(connection, own, version.name, room, text)
        done = save(connection, own, version._replace(name=name), text, 0)
        if done.full:
            _log.warning(f"a program of room {room} has no room among those of who saved it")


def _free_name(connection: sqlite3.Connection, own: str, name: str, room: str, text: str) -> str:
    """Return the name, or one with the room's where another text has it: none is pushed back."""
    row = connection.execute("SELECT name FROM room WHERE id=?", (room,)).fetchone()
    called = re.sub(r"[^\w .-]", "", row[0] if row else "").strip()[:ROOM_IN_NAME]
    tried, number = name, 1
    while (kept := next(iter(versions(connection, own, tried)), None)) is not None:
        if text_of(connection, own, tried, kept.number) == text:
            return tried
        ending = f" {called or room}" if number == 1 else f" {called or room} {number}"
        tried, number = f"{name[: LONGEST_NAME - len(ending)]}{ending}", number + 1
    return tried


def end_closed_shelves(connection: sqlite3.Connection) -> None:
    """End the shelves of all rooms that were closed."""
    rows = connection.execute(
        "SELECT DISTINCT id FROM room JOIN program_version ON shelf='room ' || id WHERE closed"
    ).fetchall()
    for (room,) in rows:
        end_shelf(connection, room)


def purge_programs(connection: sqlite3.Connection, account: int) -> None:
    """Remove what a person has saved: one's own shelf whole, of rooms the texts and the name.

    What others saved in a room stays, with its numbers.
    """
    connection.execute("DELETE FROM program_version WHERE shelf=?", (own_shelf(account),))
    connection.execute(
        "UPDATE program_version SET account=NULL, saver='', text=NULL WHERE account=?", (account,)
    )


def _made_room(connection: sqlite3.Connection, account: int, shelf: str, name: str) -> bool:
    """Drop what is oldest of what a person has saved, never the newest of a program.

    Returns:
        Whether all that is left fits into what a person may keep.
    """
    mine = connection.execute(
        "SELECT shelf, name, number, length(text), number<(SELECT max(number) FROM program_version"
        " WHERE shelf=one.shelf AND name=one.name) FROM program_version AS one WHERE account=?"
        " ORDER BY at, shelf, name, number",
        (account,),
    ).fetchall()
    count, characters = len(mine), sum(row[3] for row in mine)
    here = sum(row[:2] == (shelf, name) for row in mine)
    for row in mine:
        too_many = count > MOST_VERSIONS or characters > MOST_CHARACTERS
        if not row[4] or not (too_many or (here > MOST_OF_A_PROGRAM and row[:2] == (shelf, name))):
            continue
        connection.execute(
            "DELETE FROM program_version WHERE shelf=? AND name=? AND number=?", row[:3]
        )
        count, characters = count - 1, characters - row[3]
        here -= row[:2] == (shelf, name)
    return count <= MOST_VERSIONS and characters <= MOST_CHARACTERS


def room_takes(connection: sqlite3.Connection, room: str, name: str, length: int) -> bool:
    """Return whether the shelf of a room takes one more version of a program."""
    count, known, characters = connection.execute(
        "SELECT count(DISTINCT name), total(name=?), total(length(text)) FROM program_version"
        " WHERE shelf=?",
        (name, room_shelf(room)),
    ).fetchone()
    return bool((known or count < MOST_OF_A_SHELF) and characters + length <= MOST_OF_A_ROOM)


class GuestsTogether:
    """Knows what all guests keep: never too little, and exactly when it is about to be too much."""

    def __init__(self) -> None:
        """Begin without knowing."""
        self._characters = MOST_OF_GUESTS
        self._counted = -math.inf

    def take(self, connection: sqlite3.Connection, account: int, length: int, clock: float) -> bool:
        """Return whether somebody may keep so many characters more; `clock` only goes on [s]."""
        guest = connection.execute(
            "SELECT 1 FROM account WHERE id=? AND password IS NULL AND NOT supervisor", (account,)
        ).fetchone()
        if guest is None:
            return True
        too_much = self._characters + length > MOST_OF_GUESTS
        if too_much and clock - self._counted >= COUNT_S:
            self._characters, self._counted = _characters(connection), clock
        if self._characters + length > MOST_OF_GUESTS:
            return False
        self._characters += length
        return True


def _characters(connection: sqlite3.Connection) -> int:
    """Return what guests keep, those included whose place was given up."""
    (characters,) = connection.execute(
        "SELECT total(length(text)) FROM program_version WHERE account IS NULL OR account NOT IN"
        " (SELECT id FROM account WHERE password IS NOT NULL OR supervisor)"
    ).fetchone()
    return int(characters)
