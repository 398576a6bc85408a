"""Notices in the database: what everybody has to see is seen again after a restart."""

from typing import Final, NamedTuple

from vrts.live.store.accounts import existing
from vrts.live.store.database import Connection

EVERYWHERE: Final = ""  # in place of a room: an announcement
SOMEBODY: Final = "somebody"  # in place of a name that was purged


class KeptNotice(NamedTuple):
    """One notice: of each room, and everywhere, there is one at most."""

    room: str
    number: int
    at: float  # Unix time [s]
    account: int | None
    name: str  # of who announced or stopped something
    text: str  # of an announcement; of a stop the role of who stopped the arm


def keep_notice(connection: Connection, notice: KeptNotice) -> None:
    """Keep a notice in place of the one before."""
    connection.execute("INSERT OR REPLACE INTO notice VALUES (?,?,?,?,?,?)", notice)


def end_notice(connection: Connection, room: str) -> None:
    """Keep it no longer."""
    connection.execute("DELETE FROM notice WHERE room=?", (room,))


def keep_wanted(connection: Connection, room: str, notice: KeptNotice | None) -> None:
    """Keep what is to be seen of a room, or everywhere, now; None: nothing.

    Who was purged before it could be kept is not named.
    """
    account = None if notice is None else notice.account
    gone = account is not None and not existing(connection, (account,))
    if notice is None or (gone and room == EVERYWHERE):
        end_notice(connection, room)
    else:
        kept = notice._replace(account=None, name=SOMEBODY) if gone else notice
        keep_notice(connection, kept)


def notice_of(connection: Connection, room: str) -> KeptNotice | None:
    """Return what is kept of a room, or everywhere."""
    row = connection.execute("SELECT * FROM notice WHERE room=?", (room,)).fetchone()
    return None if row is None else KeptNotice._make(row)


def forget_notices(connection: Connection, account: int) -> None:
    """Forget what somebody has announced, and that it was they who stopped an arm."""
    connection.execute("DELETE FROM notice WHERE account=? AND room=?", (account, EVERYWHERE))
    connection.execute(
        "UPDATE notice SET account=NULL, name=? WHERE account=?", (SOMEBODY, account)
    )
