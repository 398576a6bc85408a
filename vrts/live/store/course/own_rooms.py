"""Rooms of their own: whose each is, for which assignment, and whether a hand is up in it."""

import sqlite3
from collections import defaultdict
from typing import NamedTuple


class OwnRoom(NamedTuple):
    """What makes a room one of somebody's own, or of a team's."""

    room: str
    owner: int | None  # account; None: a team's, or purged
    team: str = ""  # empty: it is one person's
    assignment: str = ""  # empty: for no assignment
    hand_at: float = 0.0  # when a hand was raised, Unix time [s]; 0: none is
    hand_by: int | None = None  # account
    hand_text: str = ""
    variant: str = ""  # tag of the variant of the task that it has; empty: as it is written

    @property
    def whose(self) -> int | str | None:
        """What tells whose rooms belong together."""
        return self.team or self.owner


_COLUMNS = "room, owner, team, assignment, hand_at, hand_by, hand_text, variant"


def keep_own_room(connection: sqlite3.Connection, own: OwnRoom) -> None:
    """Write whose a room is, that a hand is up in it, and which variant it has."""
    connection.execute(
        f"INSERT INTO own_room ({_COLUMNS}) VALUES (?,?,?,?,?,?,?,?)"  # noqa: S608 -- constants
        " ON CONFLICT (room) DO UPDATE SET hand_at=excluded.hand_at, hand_by=excluded.hand_by,"
        " hand_text=excluded.hand_text, variant=excluded.variant",
        own,
    )


def forget_hands(connection: sqlite3.Connection, account: int) -> None:
    """Forget what somebody wrote beside a raised hand."""
    connection.execute(
        "UPDATE own_room SET hand_at=0, hand_by=NULL, hand_text='' WHERE hand_by=?", (account,)
    )


def own_room_of(connection: sqlite3.Connection, room: str) -> OwnRoom | None:
    """Return whose a room is; None: it is a shared one."""
    row = connection.execute(
        f"SELECT {_COLUMNS} FROM own_room WHERE room=?",  # noqa: S608 -- constants
        (room,),
    ).fetchone()
    return None if row is None else OwnRoom._make(row)


def own_rooms(connection: sqlite3.Connection) -> list[OwnRoom]:
    """Return all of them that are open."""
    rows = connection.execute(
        f"SELECT {_COLUMNS} FROM own_room"  # noqa: S608 -- constants
        " WHERE room IN (SELECT id FROM room WHERE NOT closed)"
    )
    return [OwnRoom._make(row) for row in rows]


def members(connection: sqlite3.Connection, own: OwnRoom) -> dict[int, str]:
    """Return who may enter a room of their own: names by account."""
    if own.team:
        rows = connection.execute(
            "SELECT account.id, account.name FROM person JOIN account ON account.id=account"
            " WHERE team=? AND listed",
            (own.team,),
        )
    else:
        rows = connection.execute("SELECT id, name FROM account WHERE id=?", (own.owner,))
    return dict(rows.fetchall())


def all_members(connection: sqlite3.Connection) -> dict[str, tuple[OwnRoom, dict[int, str]]]:
    """Return for every open room of somebody's own whose it is and who may enter it."""
    teams: dict[str, dict[int, str]] = defaultdict(dict)
    for account, name, team in connection.execute(
        "SELECT account.id, account.name, team FROM person JOIN account ON account.id=account"
        " WHERE team<>'' AND listed"
    ):
        teams[team][account] = name
    names: dict[int, str] = dict(
        connection.execute(
            "SELECT id, name FROM account WHERE id IN (SELECT owner FROM own_room)"
        ).fetchall()
    )
    found: dict[str, tuple[OwnRoom, dict[int, str]]] = {}
    for own in own_rooms(connection):
        alone = {own.owner: names[own.owner]} if own.owner in names else {}
        found[own.room] = (own, dict(teams[own.team]) if own.team else alone)
    return found
