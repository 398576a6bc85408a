"""How much the programs may take that a room and all guests keep; it is asked before each save."""

import math
import sqlite3
from typing import Final

from vrts.live.store.programs import room_shelf

MOST_PROGRAMS: Final = 200  # of a room
MOST_OF_A_ROOM: Final = 20_000_000  # characters, of all versions
MOST_OF_GUESTS: Final = 400_000_000  # characters, of all that have no password together
COUNT_S: Final = 60.0  # how often what guests have is counted at most: that reads it all


def room_takes(connection: sqlite3.Connection, room: str, name: str, length: int) -> bool:
    """Return whether the shelf of a room takes one more version of a program."""
    count, known, characters = connection.execute(
        "SELECT count(DISTINCT name), total(name=?), total(length(text)) FROM program_version"
        " WHERE shelf=?",
        (name, room_shelf(room)),
    ).fetchone()
    return bool((known or count < MOST_PROGRAMS) and characters + length <= MOST_OF_A_ROOM)


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
