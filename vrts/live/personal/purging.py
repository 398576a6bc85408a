"""Forgets a person everywhere in a server's folder, while the server runs or not.

Rows go, and what they were is overwritten: the database is written again without them, and its
journal is emptied. Chains of logs stay, with a signed note for every text that is gone.
"""

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final, NamedTuple

from vrts.live.lasting.folder_lock import holder
from vrts.live.logs.logged_sessions import NO_COMMANDS
from vrts.live.notices.kept import EVERYWHERE, forget_notices
from vrts.live.personal.names import Names, accounts_of
from vrts.live.session.growing.folder import ASLEEP, FILE, OFF, SHOWN
from vrts.live.settings import DATABASE, SESSIONS
from vrts.live.store import log
from vrts.live.store.course.own_rooms import forget_hands
from vrts.live.store.database import Connection, opened
from vrts.live.store.programs import purge_programs
from vrts.live.store.rooms import PURGES, next_number
from vrts.live.store.seals.connection import naming, signature
from vrts.live.store.seals.heads import ACCEPTED
from vrts.live.store.seals.sealing import seals_for

BEFORE: Final = "before.jsonl"  # in a session's folder, until it is read
LATER: Final = "purge once more when the server has ended, to empty the unused parts of the file"
LARGE: Final = 200_000_000  # bytes of a database that is not written again while a server works

_NAMED: Final = (  # rows that are about who is called so
    "DELETE FROM link WHERE NOT supervisor AND name=?",
    "DELETE FROM barred WHERE name=?",
    "DELETE FROM muted WHERE name=?",
    "DELETE FROM chat WHERE name=?",
)
_EMPTY: Final = (  # programs of which no version is left
    "DELETE FROM program_version AS one WHERE NOT EXISTS (SELECT 1 FROM program_version"
    " WHERE shelf=one.shelf AND name=one.name AND text NOT NULL)"
)


class Forgotten(NamedTuple):
    """What became of a purge."""

    accounts: int  # that had the name
    copies: tuple[str, ...] = ()  # of the database that were removed
    mentions: int = 0  # texts of others in which the name still stands
    left: str = ""  # what has to be done besides; empty: nothing


def purge(folder: Path, name: str, key: Path | None, *, mentions: bool = False) -> Forgotten:
    """Forget all accounts of a name, what they wrote, and the name.

    A server that is running ends their connections within a second or so. Sessions in which they
    acted lose the file of their history: they go on, and know the last ten minutes.

    Args:
        folder: Of the server.
        name: Of the person.
        key: File with the key of the logs, if not the usual one.
        mentions: Whether texts that others wrote are forgotten too if the name stands in them.

    Raises:
        CannotRead: There is no key of the logs that fits.
    """
    path, names = folder / DATABASE, Names(name)
    connection = opened(path)
    try:
        seals = seals_for(path, key, connection)
        seals.attach(connection)
        connection.execute("BEGIN IMMEDIATE")
        accounts = accounts_of(connection, names)
        if not accounts:
            return Forgotten(0)
        rooms = {room for account in accounts for room in _rooms_of(connection, account)}
        for account in accounts:
            purge_programs(connection, account)
            forget_notices(connection, account)
            forget_hands(connection, account)
            log.purge(connection, account)
        left = _forget_name(connection, names, mentions=mentions)
        connection.execute(_EMPTY)
        next_number(connection, PURGES)
        seals.seal(connection)
        connection.execute("COMMIT")
        _forget_files(folder, accounts, rooms)
        left += _forget_files_of_others(folder, names, everywhere=mentions)
        copies = tuple(_remove_copies(path))
        words = _overwrite(connection, path)
        seals.remember(connection, at_once=True)
    finally:
        if connection.in_transaction:
            connection.execute("ROLLBACK")
        connection.close()
    return Forgotten(len(accounts), copies, left, words)


def _rooms_of(connection: Connection, account: int) -> Iterator[str]:
    rows = connection.execute("SELECT DISTINCT room FROM log_text WHERE account=?", (account,))
    yield from (row[0] for row in rows)


def _forget_name(connection: Connection, names: Names, *, mentions: bool) -> int:
    """Remove a name from what others are told; return how many texts of others hold it still."""
    for query in _NAMED:
        connection.executemany(query, ((name,) for name in names.all))
    for room, called in connection.execute("SELECT id, name FROM room").fetchall():
        if names.stands_in(called):
            naming(connection, room, called)
            connection.execute("UPDATE room SET name=? WHERE id=?", (names.without(called), room))
    for room, number, account, text in _holding(connection, names, "chat", "number, account"):
        if account is None or not names.short:
            connection.execute(
                "UPDATE chat SET text=? WHERE room=? AND number=?",
                (names.without(text), room, number),
            )
    for room, _, text in _holding(connection, names, "notice", "number"):
        if room == EVERYWHERE:  # of a stop it is a role
            new = names.without(text)
            connection.execute("UPDATE notice SET text=? WHERE room=?", (new, room))
    for number, at, what in connection.execute("SELECT number, at, what FROM log_accepted"):
        if names.stands_in(what):
            new = names.without(what)
            seal = signature(connection, ACCEPTED, number, at, new)
            connection.execute(
                "UPDATE log_accepted SET what=?, seal=? WHERE number=?", (new, seal, number)
            )
    return _forget_mentions(connection, names, everywhere=mentions)


def _forget_mentions(connection: Connection, names: Names, *, everywhere: bool) -> int:
    """Remove records of what is no command with the name in them, on demand all; count the rest."""
    left = 0
    for room, seq, _ in _holding(connection, names, "log_text", "seq"):
        (kind,) = connection.execute(
            "SELECT kind FROM log WHERE room=? AND seq=?", (room, seq)
        ).fetchone() or ("",)
        if kind in NO_COMMANDS or everywhere:
            log.purge_text(connection, room, seq)
        else:
            left += 1
    rows = connection.execute(
        "SELECT shelf, name, number, text FROM program_version WHERE text NOT NULL"
    ).fetchall()
    for shelf, program, number, text in rows:
        if names.short or not names.stands_in(f"{program}\n{text}"):
            continue
        if everywhere:
            connection.execute(
                "UPDATE program_version SET text=NULL WHERE shelf=? AND name=? AND number=?",
                (shelf, program, number),
            )
        left += not everywhere
    return left


def _holding(
    connection: Connection, names: Names, table: str, columns: str
) -> list[tuple[Any, ...]]:
    """Return room, columns and text of the rows in whose text a name stands."""
    found: list[tuple[Any, ...]] = []
    for spelling in names.written:
        rows = connection.execute(
            f"SELECT room, {columns}, text FROM {table} WHERE instr(text, ?)",  # noqa: S608 -- ours
            (spelling,),
        )
        found += (row for row in rows if names.stands_in(row[-1]) and row not in found)
    return found


def _forget_files(folder: Path, accounts: list[int], rooms: set[str]) -> None:
    """Remove the files that somebody has written, and what sessions remember of them."""
    for session in (folder / SESSIONS).glob("*/"):
        own = [session / f"p{account}" for account in accounts]
        own = [place for place in own if place.is_dir() and not place.is_symlink()]
        if not own and session.name.rpartition("-")[0] not in rooms:
            continue
        (session / OFF).touch(mode=0o600)
        names = (FILE, Path(FILE).with_suffix(".part").name, BEFORE, ASLEEP, SHOWN)
        for file in (session / name for name in names):
            file.unlink(missing_ok=True)
        for place in own:
            shutil.rmtree(place)


def _forget_files_of_others(folder: Path, names: Names, *, everywhere: bool) -> int:
    """Remove files of others with the name in them, on demand; return how many are left."""
    left = 0
    for file in (folder / SESSIONS).glob("*/p*/*"):
        if file.is_file() and not file.is_symlink() and _holds(file, names):
            if everywhere:
                file.unlink()
            left += not everywhere
    for file in (folder / SESSIONS).glob("*/stderr.txt"):
        if not file.is_symlink() and _holds(file, names):
            file.write_bytes(names.without(file.read_text("utf-8", "replace")).encode())
    return left


def _holds(file: Path, names: Names) -> bool:
    return names.stands_in(f"{file.name}\n{file.read_text('utf-8', 'replace')}")


def _remove_copies(path: Path) -> Iterator[str]:
    """Remove copies of the database from before its tables were changed, and halves of copies."""
    for pattern in (f"{path.stem}.version-*", "*.part"):
        for copy in sorted(path.parent.glob(pattern)):
            copy.unlink()
            yield copy.name


def _overwrite(connection: Connection, path: Path) -> str:
    """Leave nothing of what was removed in the file and its journal; return what is left to do."""
    if holder(path.parent) is not None and path.stat().st_size > LARGE:
        return f"{LATER}: the database is too large to be written again while a server works"
    connection.execute("VACUUM")
    busy, _, _ = connection.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchone()
    return f"{LATER}: another program reads the database" if busy else ""
