"""Signs what a server's transactions change, in the same transactions.

Nothing is signed over what does not fit what was signed before: then the old signs stay, and show
it for as long as nobody has accepted it.
"""

import logging
import secrets
import sqlite3
import time
from pathlib import Path
from typing import Final

from vrts.live.lasting.clock import wall
from vrts.live.store.seals.connection import SealedConnection, Touched
from vrts.live.store.seals.heads import (
    HEAD,
    NAME,
    PURGED,
    Head,
    Root,
    digest_of,
    head_of,
    keep_head,
    keep_root,
    present,
    root_of,
    seals_of_heads,
)
from vrts.live.store.seals.key import Field, LogKey, make_key, read_key, require_outside, usual_key
from vrts.live.store.seals.witness import Seen, Witness
from vrts.pipeline.files import CannotRead

UNSIGNED: Final = "the logs in this folder were signed, and are not any more"
BEFORE: Final = "purged before logs were signed"
WITNESS_S: Final = 5.0  # how often the file beside the key is written at most
ACCEPT: Final = "`vrts serve --folder FOLDER --accept-logs`"

_log = logging.getLogger("vrts.live")


class Seals:
    """The signs of one database."""

    def __init__(self, path: Path, key: LogKey, witness: Witness) -> None:
        """Take the database's path and its key; `attach` begins."""
        self.key = key
        self.witness = witness
        self.fault = ""  # why nothing is signed
        self.unfit: set[str] = set()  # rooms whose logs do not fit their heads
        self._folder = path.parent
        self._database = b""
        self._times = 0
        self._due = 0.0

    def attach(self, connection: SealedConnection) -> None:
        """Sign what this connection changes from now on; what was never signed is signed first.

        Raises:
            CannotRead: It is signed with another key.
        """
        connection.execute("BEGIN IMMEDIATE")
        try:
            root = root_of(connection)
            if root is None:
                self._begin(connection)
            else:
                self._go_on(connection, root)
            connection.execute("COMMIT")
        finally:
            if connection.in_transaction:
                connection.execute("ROLLBACK")
        connection.touched.clear()
        if self._database:
            connection.sign = self._sign
        if self.fault:
            _log.error("%s", f"{self.fault}: nothing is signed until you have run {ACCEPT}")
        self.remember(connection, at_once=True)

    def seal(self, connection: SealedConnection) -> None:
        """Sign what the present transaction has changed."""
        if not connection.touched or self.fault:
            return
        root, seals = root_of(connection), seals_of_heads(connection)
        self.fault = self._unlike(root, seals)
        if self.fault or root is None:
            _log.error("logs are not signed any more: %s", self.fault)
            return
        for room, touched in connection.touched.items():
            head = self._next(connection, room, touched)
            if head is not None:
                seals[room] = keep_head(connection, self.key, root.database, head)
        rooms = sorted(seals)
        heads = digest_of(seals[room] for room in rooms)
        if heads != root.heads:
            self._times = root.times + 1
            root = root._replace(times=self._times, rooms=len(rooms), heads=heads)
            keep_root(connection, root.sign(self.key))

    def remember(self, connection: sqlite3.Connection, *, at_once: bool = False) -> None:
        """Keep beside the key how far the database has come, when that is safely on its disk."""
        if self.fault or not self._database or (time.monotonic() < self._due and not at_once):
            return
        try:
            root = root_of(connection)
            busy, pages, done = connection.execute("PRAGMA wal_checkpoint(PASSIVE)").fetchone()
            if root is None or busy or pages != done:
                return  # somebody reads what is older
            self._due = time.monotonic() + WITNESS_S
            folder = str(self._folder.resolve())
            self.witness.write(Seen(root.database.hex(), folder, root.times))
        except (OSError, sqlite3.Error) as problem:  # such as a full disk; it is tried again
            _log.error("cannot write beside the key of the logs: %s", problem)

    def _begin(self, connection: sqlite3.Connection) -> None:
        """Sign a database for the first time, unless it was signed before."""
        known = self.witness.in_folder(self._folder)
        (used,) = connection.execute(
            "SELECT EXISTS (SELECT 1 FROM log) OR EXISTS (SELECT 1 FROM room)"
        ).fetchone()
        if used and known:
            self.fault = UNSIGNED
            return
        self._database = new_database()
        seal_all(connection, self.key, Root(self._database, self.key.id, 1, 0, b"", 0), BEFORE)
        self._times = 1

    def _go_on(self, connection: sqlite3.Connection, root: Root) -> None:
        require_key(root, self.key)
        self.fault = self._unlike(root, seals_of_heads(connection))
        if self.fault:
            return
        self._database, self._times = root.database, root.times
        self.fault = older(root, self.witness.of(root.database))

    def _unlike(self, root: Root | None, seals: dict[str, bytes]) -> str:
        """Return what is wrong with the list of rooms; empty: nothing."""
        if root is None:
            return "the signed list of rooms is missing"
        if not root.is_signed(self.key):
            return "the signed list of rooms was changed"
        if root.times < self._times:
            return "the database is an older one than a moment ago"
        try:
            heads = digest_of(seals.values())
        except TypeError:  # foreign values
            heads = b""
        return "" if root.heads == heads else "the list of rooms was changed"

    def _next(self, connection: sqlite3.Connection, room: str, touched: Touched) -> Head | None:
        """Return the head that a room is to have; None: it stays as it is."""
        now, before = present(connection, room), head_of(connection, room)
        if now is None:  # it was to be made, and was not
            return None
        if before is None:
            fits = touched.records in (None, 0) and touched.name is None
            head = Head("", "", 0, b"") if fits else None
        else:
            head, seal = before
            fits = self.key.signed(seal, HEAD, self._database, *head)
            fits = fits and touched.records in (None, head.records)
            fits = fits and touched.last in (None, head.last)
            fits = fits and (not touched.named or touched.name == head.name)
        if not fits or head is None:
            if room not in self.unfit:
                self.unfit.add(room)
                _log.error("the log of room %r does not fit what was signed", room)
            return None
        if before is None or touched.named:
            head = head._replace(room=room, name=now.name)
        if before is None or touched.records is not None:
            head = head._replace(records=now.records, last=now.last)
        return head

    def _sign(self, kind: str, *fields: Field) -> bytes:
        return self.key.sign(kind, self._database, *fields)


def new_database() -> bytes:
    """Return what a database is called."""
    return secrets.token_bytes(16)


def seals_for(path: Path, key_file: Path | None, connection: sqlite3.Connection) -> Seals:
    """Return the signs of a database, with the key that is used if nobody names another.

    A database that was signed needs its key; for another one a key is made.

    Raises:
        CannotRead: The key is missing, or cannot be used.
    """
    file = usual_key() if key_file is None else key_file
    require_outside(file, path.parent)
    key, witness = read_key(file), Witness(file)
    if key is None:
        if root_of(connection) is not None or witness.in_folder(path.parent):
            raise missing(file)
        key = make_key(file)
    return Seals(path, key, witness)


def missing(file: Path) -> CannotRead:
    """Return what is said where there is no key."""
    return CannotRead(
        f"the key of the logs is missing: `{file}`",
        (
            "put it back, or name it: `--log-key FILE`",
            "if it is lost for good, `--accept-logs` makes another one",
        ),
    )


def require_key(root: Root, key: LogKey) -> None:
    """See to it that a key is the one of a database.

    Raises:
        CannotRead: It is another one.
    """
    if root.key and root.key != key.id:
        raise CannotRead(
            f"the logs are signed with another key than `{key.path}`",
            ("name the right one: `--log-key FILE`", "`--accept-logs` signs them again"),
        )


def older(root: Root, seen: Seen | None) -> str:
    """Return how a database is older than what is known of it; empty: it is not."""
    if seen is None and root.times > 1:  # the first time, it is written a moment later
        return "the file beside the key is missing, which tells how far these logs had come"
    if seen is not None and root.times < seen.count:
        return (
            f"this is an older state of the database: it was signed {root.times} times,"
            f" and {seen.count} times before"
        )
    return ""


def seal_all(connection: sqlite3.Connection, key: LogKey, root: Root, why: str) -> None:
    """Sign everything as it is now; records without a text count as purged.

    Args:
        connection: In a transaction.
        key: To sign with.
        root: The database, how often it was signed, what was accepted.
        why: What is said of texts that are missing.
    """
    database = root.database
    connection.execute("DELETE FROM log_head")
    rooms = connection.execute(
        "SELECT id FROM room UNION SELECT room FROM log ORDER BY 1"
    ).fetchall()
    seals: list[bytes] = []
    for (room,) in rooms:
        head = present(connection, room)
        if head is not None:
            seals.append(keep_head(connection, key, database, head))
    names = connection.execute("SELECT room, account, salt, name FROM log_name").fetchall()
    connection.executemany(
        "UPDATE log_name SET seal=? WHERE room=? AND account=?",
        ((key.sign(NAME, database, *row), *row[:2]) for row in names),
    )
    missing = connection.execute(
        "SELECT room, seq, content, coalesce(at, ?), coalesce(why, ?) FROM log"
        " LEFT JOIN log_text USING (room, seq) LEFT JOIN log_purged USING (room, seq)"
        " WHERE log_text.seq IS NULL",
        (round(wall(), 3), why),
    ).fetchall()
    connection.executemany(
        "INSERT OR REPLACE INTO log_purged VALUES (?,?,?,?,?)",
        (
            (room, seq, at, why, key.sign(PURGED, database, room, seq, content, at, why))
            for room, seq, content, at, why in missing
        ),
    )
    root = root._replace(key=key.id, rooms=len(seals), heads=digest_of(seals))
    keep_root(connection, root.sign(key))
