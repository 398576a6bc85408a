"""What the admin page shows: load, rooms, quotas, backups, the end of the log; all bounded."""

from typing import Final

import msgspec

from vrts import __version__
from vrts.live.administration import last_backup
from vrts.live.limits import ALL_CONNECTIONS
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.room import Room
from vrts.live.settings import DATABASE
from vrts.live.store.accounts import GUESTS
from vrts.live.store.database import Connection
from vrts.live.watching.health import Health
from vrts.live.watching.log_tail import LogEntry
from vrts.live.watching.machine import Load

MOST_ROOMS: Final = 200  # that are shown


class RoomNow(msgspec.Struct, frozen=True):
    """A room."""

    id: str
    name: str
    scene: str
    people: int
    operator: str  # name; empty: nobody
    state: str
    log: int  # bytes of the session's log, about


class Quota(msgspec.Struct, frozen=True):
    """How much there is of something, and how much there may be; 0: there is no limit."""

    name: str
    used: int
    most: int
    unit: str = ""  # "bytes", or nothing for a count


class Overview(msgspec.Struct, frozen=True):
    """Everything."""

    version: str
    health: Health
    load: dict[str, float]
    rooms: tuple[RoomNow, ...]
    quotas: tuple[Quota, ...]
    backup_at: float  # Unix time of the last one [s]; 0: none is known
    backup_bytes: int
    log: tuple[LogEntry, ...]  # newest first


def guests(connection: Connection) -> int:
    """Return how many accounts without a password there are."""
    (count,) = connection.execute("SELECT count(*) FROM account WHERE password IS NULL").fetchone()
    return int(count)


def may_administer(connection: Connection, account: int) -> bool:
    """Return whether an account is a supervisor's own, with a password: no link leads to it."""
    row = connection.execute(
        "SELECT 1 FROM account WHERE id=? AND supervisor AND password IS NOT NULL", (account,)
    ).fetchone()
    return row is not None


def overview(
    hub: Hub, health: Health, load: Load, log: tuple[LogEntry, ...], guest_count: int
) -> Overview:
    """Return what is shown now."""
    rooms = sorted(hub.rooms.values(), key=lambda room: -room.logged)
    database = hub.settings.folder / DATABASE
    kept = sum(file.stat().st_size for file in database.parent.glob(f"{DATABASE}*"))
    at, size = last_backup(hub.settings.folder)
    return Overview(
        version=__version__,
        health=health,
        load=load._asdict(),
        rooms=tuple(_row(room) for room in list(hub.rooms.values())[:MOST_ROOMS]),
        quotas=(
            Quota(
                "Largest log of a session",
                rooms[0].logged if rooms else 0,
                hub.settings.log_quota,
                "bytes",
            ),
            Quota("Guests", guest_count, GUESTS),
            Quota("Connections", health.people, ALL_CONNECTIONS),
            Quota("Database", kept, 0, "bytes"),
        ),
        backup_at=at,
        backup_bytes=size,
        log=log,
    )


def _row(room: Room) -> RoomNow:
    holder = room.members.get(room.control.holder)
    return RoomNow(
        id=room.id,
        name=room.kept.name,
        scene=room.kept.scene,
        people=room.crowd,
        operator=holder.account.name if holder else "",
        state=_state(room),
        log=room.logged,
    )


def _state(room: Room) -> str:
    if not room.offered:
        return "its scene is not offered"
    if room.waits is not None:
        return "its session keeps dying"
    if room.process is None or not room.process.ready:
        return "being prepared"
    if room.stopped is not None:
        return "stopped by PANIC"
    return "frozen" if room.frozen else "runs"
