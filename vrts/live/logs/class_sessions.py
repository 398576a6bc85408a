"""Sessions that are to be marked: from exported logs, or from the database of a server."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import msgspec

from vrts.base.safe_names import safe
from vrts.live.logs.log_file import read_log
from vrts.live.logs.logged_sessions import LogFault, LoggedSession, sessions_of
from vrts.live.logs.unfinished import log_row
from vrts.live.settings import DATABASE
from vrts.live.store import log, progress
from vrts.live.store.database import Connection, is_database, read_only
from vrts.pipeline.files import CannotRead, read_bytes

NOTHING = "nothing was done in this room"


class RoomSession(NamedTuple):
    """The last session of a room in which something was done."""

    identifier: str  # unique, safe for file names
    name: str  # of the room, or of its log
    origin: str  # file it is from
    session: LoggedSession | None
    problem: str = ""  # why there is none


def sessions_in(given: Sequence[str], folder: Path) -> tuple[RoomSession, ...]:
    """Return the last session of every room that is meant.

    Args:
        given: Exported logs; databases or folders of servers: all rooms; ids or names of rooms.
        folder: Of the server whose rooms have those names.

    Raises:
        CannotRead: There is nothing of the kind.
    """
    found: list[RoomSession] = []
    for one in given:
        path = Path(one)
        if path.is_dir() and (path / DATABASE).is_file():
            path = path / DATABASE
        if not path.is_file():
            found += _named(one, folder / DATABASE)
        elif is_database(path):
            found += _of_database(path, None)
        else:
            found.append(_of_log(path))
    taken: set[str] = set()
    return tuple(_unique(one, taken) for one in found)


def _named(room: str, database: Path) -> list[RoomSession]:
    if not database.is_file():
        raise CannotRead(
            f"there is no log, database or room `{room}`",
            (f"rooms are looked up in `{database}`: say `--folder` for another server",),
        )
    found = _of_database(database, room)
    if not found:
        raise CannotRead(f"there is no room `{room}` in `{database}`")
    return found


def _of_database(path: Path, room: str | None) -> list[RoomSession]:
    try:
        with read_only(path) as connection:
            rooms = progress.rooms_with_logs(connection)
            return [
                _of_room(connection, id_, name, path.name)
                for id_, name in rooms
                if room in (None, id_, name)
            ]
    except ValueError as problem:
        raise CannotRead(f"cannot read `{path}`: {problem}") from problem


def _of_room(connection: Connection, room: str, name: str, origin: str) -> RoomSession:
    start = RoomSession(safe(name), name, origin, None)
    wrong = log.verify(connection, room)
    if wrong:
        return start._replace(problem=wrong)
    try:
        return _last(start, sessions_of(map(log_row, progress.all_records(connection, room))))
    except (LogFault, msgspec.DecodeError) as problem:
        return start._replace(problem=str(problem))


def _of_log(path: Path) -> RoomSession:
    start = RoomSession(safe(path.stem), path.stem, path.name, None)
    try:
        return _last(start, read_log(read_bytes(path)))
    except LogFault as problem:
        return start._replace(problem=str(problem))


def _last(start: RoomSession, sessions: Sequence[LoggedSession]) -> RoomSession:
    """Return the last session in which something was done."""
    eventful = [one for one in sessions if one.entries]
    if not eventful:
        return start._replace(problem=NOTHING)
    return start._replace(session=eventful[-1].require_whole())


def _unique(one: RoomSession, taken: set[str]) -> RoomSession:
    name, number = one.identifier, 2
    while name.lower() in taken:
        name = f"{one.identifier}-{number}"
        number += 1
    taken.add(name.lower())
    return one._replace(identifier=name)
