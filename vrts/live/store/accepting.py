"""Accepts logs that do not fit their signs, such as those of a backup that was put back."""

from pathlib import Path
from typing import Final

from vrts.live.store.database import Connection, opened
from vrts.live.store.seals.heads import ACCEPTED, Root, root_of
from vrts.live.store.seals.key import LogKey, make_key, read_key, require_outside, usual_key
from vrts.live.store.seals.sealing import new_database, seal_all
from vrts.live.store.seals.witness import Seen, Witness
from vrts.live.store.verifying import of_signed
from vrts.pipeline.files import CannotRead

MOST: Final = 20  # faults that are noted one by one
WHY: Final = "missing when the logs were accepted"
OTHER_KEY: Final = "the key that had signed the logs was not there"
_STRAYS: Final = (
    "DELETE FROM log_purged WHERE (room, seq) NOT IN (SELECT room, seq FROM log)",
    "DELETE FROM log_purged WHERE (room, seq) IN (SELECT room, seq FROM log_text)",
    "DELETE FROM log_text WHERE (room, seq) NOT IN (SELECT room, seq FROM log)",
)


def accept(path: Path, key_file: Path | None, now: float) -> list[str]:
    """Sign the logs of a database as they are, and note what did not fit; return that.

    What a chain itself tells against a log stays wrong. No server may use the database meanwhile.

    Args:
        path: Of the database.
        key_file: With the key of the logs, if not the usual one; a missing one is made.
        now: Unix time [s].

    Raises:
        CannotRead: There is no key, and none can be made.
    """
    file = usual_key() if key_file is None else key_file
    require_outside(file, path.parent)
    key, witness = read_key(file) or make_key(file), Witness(file)
    connection = opened(path)
    try:
        connection.execute("BEGIN IMMEDIATE")
        root, here = root_of(connection), witness.in_folder(path.parent)
        known = root if root is not None and root.is_signed(key) else None
        seen = None if known is None else witness.of(known.database)
        try:
            found = [one for one in of_signed(connection, key, seen, here) if one.wrong]
            what = [f"{one.room}: {one.text}" if one.room else one.text for one in found]
        except CannotRead:
            what = [OTHER_KEY]
        if not what:
            return []
        if len(what) > MOST:
            what = [*what[:MOST], f"and {len(what) - MOST} more"]
        times = [one.count for one in (seen, *here) if one is not None]
        last = max(*times, 0 if known is None else known.times, 0)
        database = new_database() if known is None else known.database
        for statement in _STRAYS:
            connection.execute(statement)
        count = _note(connection, key, database, round(now, 3), "; ".join(what))
        seal_all(connection, key, Root(database, key.id, last + 1, 0, b"", count), WHY)
        connection.execute("COMMIT")
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
    finally:
        if connection.in_transaction:
            connection.execute("ROLLBACK")
        connection.close()
    for one in here:
        witness.forget(one)
    witness.write(Seen(database.hex(), str(path.parent.resolve()), last + 1))
    return what


def _note(connection: Connection, key: LogKey, database: bytes, at: float, what: str) -> int:
    """Note what was accepted, after what was accepted before; return how often that was."""
    rows = connection.execute("SELECT at, what FROM log_accepted ORDER BY number").fetchall()
    connection.execute("DELETE FROM log_accepted")
    for number, note in enumerate((*rows, (at, what)), 1):
        seal = key.sign(ACCEPTED, database, number, *note)
        connection.execute("INSERT INTO log_accepted VALUES (?,?,?,?)", (number, *note, seal))
    return len(rows) + 1
