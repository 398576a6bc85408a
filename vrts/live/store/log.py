"""The evaluation log of a room: append, export, verify, and purge of a person."""

import secrets
import sqlite3
from collections.abc import Iterator
from typing import Any, Final, NamedTuple, TypeGuard

import msgspec

from vrts.live.lasting.clock import wall
from vrts.live.store.chain import START, Record, record_hash, salted
from vrts.live.store.seals.connection import appending, signature
from vrts.live.store.seals.heads import NAME, PURGED

RECORD: Final = 300  # bytes that a record takes beside its text, about
SALT: Final = 16  # bytes
NOBODY: Final = bytes(32)  # in place of a person's digest: the server itself, or who was purged
ASKED: Final = "somebody was purged"
LATE: Final = "recorded after its person was purged"

_KINDS: Final = (str, int, int, float, float, str, int, bytes, bytes, bytes, bytes)


class Entry(NamedTuple):
    """What is to be recorded."""

    room: str
    session: int
    at_s: float
    wall: float
    kind: str
    accepted: bool
    account: int | None  # None: the server itself
    name: str
    text: str  # JSON of the command and what became of it


class Logged(NamedTuple):
    """A record with what is still known about it."""

    record: Record
    hash: bytes
    name: str | None  # None: purged, or the server
    text: str | None  # None: purged
    salt: bytes | None  # with which the text's digest was made


def size(connection: sqlite3.Connection, room: str) -> int:
    """Return how many bytes the log of a room's last session takes, about."""
    count, texts = connection.execute(
        "SELECT count(*), total(length(text)) FROM log LEFT JOIN log_text USING (room, seq)"
        " WHERE room=?1 AND seq>=(SELECT max(seq) FROM log WHERE room=?1 AND kind='begin')",
        (room,),
    ).fetchone()
    return int(count * RECORD + texts)


def counts(connection: sqlite3.Connection, room: str) -> dict[str, int]:
    """Return how many records of each kind the log of a room's last session has."""
    rows = connection.execute(
        "SELECT kind, count(*) FROM log WHERE room=?1"
        " AND seq>=(SELECT max(seq) FROM log WHERE room=?1 AND kind='begin') GROUP BY kind",
        (room,),
    )
    return dict(rows.fetchall())


def append(connection: sqlite3.Connection, entry: Entry) -> int:
    """Append a record; return its number."""
    last = connection.execute(
        "SELECT seq, hash FROM log WHERE room=? ORDER BY seq DESC LIMIT 1", (entry.room,)
    ).fetchone()
    seq, previous = (last[0] + 1, last[1]) if last else (1, START)
    appending(connection, entry.room, seq - 1, previous)
    salt = secrets.token_bytes(SALT)
    record = Record(
        entry.room,
        seq,
        entry.session,
        round(entry.at_s, 6),
        round(entry.wall, 3),
        entry.kind,
        entry.accepted,
        _person(connection, entry),
        salted(salt, entry.text),
        previous,
    )
    connection.execute(
        "INSERT INTO log VALUES (?,?,?,?,?,?,?,?,?,?,?)", (*record, record_hash(record))
    )
    connection.execute(
        "INSERT INTO log_text VALUES (?,?,?,?,?)",
        (entry.room, seq, entry.account, salt, entry.text),
    )
    return seq


def append_now(connection: sqlite3.Connection, entry: Entry) -> None:
    """Append a record of what has just happened; of who was purged meanwhile no more is kept."""
    if entry.account is None:
        append(connection, entry)
        return
    row = connection.execute("SELECT 1 FROM account WHERE id=?", (entry.account,)).fetchone()
    seq = append(connection, entry if row else entry._replace(account=None, name=""))
    if row is None:
        purge_text(connection, entry.room, seq, LATE)


def records(connection: sqlite3.Connection, room: str) -> Iterator[Logged]:
    """Return the records of a room in order."""
    rows = connection.execute(
        "SELECT log.*, log_name.name, log_text.text, log_text.salt FROM log"
        " LEFT JOIN log_text USING (room, seq)"
        " LEFT JOIN log_name ON log_name.room=log.room AND log_name.account=log_text.account"
        " WHERE log.room=? ORDER BY seq",
        (room,),
    )
    for row in rows:
        record = Record._make((*row[:6], bool(row[6]), *row[7:10]))
        yield Logged(record, *row[10:14])


def verify(connection: sqlite3.Connection, room: str) -> str:
    """Return what is wrong with the log of a room; empty: nothing, purged or not.

    Records, texts and persons have to fit the chain. What is missing at the end, or was purged
    by nobody, only signs tell (`seals`).
    """
    number, previous = 0, START
    rows = connection.execute(
        "SELECT log.*, log_text.account, log_text.salt, log_text.text, log_name.salt"
        " FROM log LEFT JOIN log_text USING (room, seq) LEFT JOIN log_name"
        " ON log_name.room=log.room AND log_name.account=log_text.account"
        " WHERE log.room=? ORDER BY seq",
        (room,),
    )
    try:
        for number, row in enumerate(rows, 1):
            wrong = _wrong(number, previous, row)
            if wrong:
                return wrong
            previous = row[10]
    except sqlite3.Error as problem:
        return f"record {number + 1} cannot be read: {problem}"
    return ""


def _wrong(number: int, previous: bytes, row: tuple[Any, ...]) -> str:
    """Return what is wrong with a record, its text and its person; empty: nothing."""
    if row[1] != number:
        return f"record {number} is missing"
    if not all(isinstance(value, kind) for value, kind in zip(row, _KINDS, strict=False)):
        return f"record {number} has values of foreign kinds"
    record = Record._make((*row[:6], bool(row[6]), *row[7:10]))
    if record.previous != previous or record_hash(record) != row[10]:
        return f"record {number} was changed"
    account, salt, text, salt_of_person = row[11:]
    if text is None and salt is None and account is None:
        return ""
    if not (isinstance(text, str) and _is_salt(salt)) or salted(salt, text) != record.content:
        return f"the text of record {number} was changed"
    if account is None:
        person = NOBODY
    elif isinstance(account, int) and _is_salt(salt_of_person):
        person = salted(salt_of_person, str(account))
    else:
        person = b""
    return "" if person == record.person else f"the person of record {number} was exchanged"


def _is_salt(value: object) -> TypeGuard[bytes]:
    return isinstance(value, bytes) and len(value) == SALT


def export(connection: sqlite3.Connection, room: str, *, names: bool) -> bytes:
    """Return the log of a room as JSON Lines: a head, then one record a line."""
    lines: list[bytes] = []
    last = START
    for logged in records(connection, room):
        r = logged.record
        last = logged.hash
        row: dict[str, object] = {
            "seq": r.seq,
            "session": r.session,
            "at_s": r.at_s,
            "wall": r.wall,
            "kind": r.kind,
            "accepted": r.accepted,
            "person": r.person.hex(),
            "content": r.content.hex(),
            "previous": r.previous.hex(),
            "hash": logged.hash.hex(),
            "salt": None if logged.salt is None else logged.salt.hex(),
            "text": None if logged.text is None else msgspec.Raw(logged.text.encode()),
        }
        if names:
            row["name"] = logged.name
        lines.append(msgspec.json.encode(row))
    head = {"schema": "vrts/live-log", "version": 1, "room": room, "records": len(lines)}
    return b"\n".join([msgspec.json.encode({**head, "last": last.hex()}), *lines]) + b"\n"


def purge(connection: sqlite3.Connection, account: int) -> None:
    """Forget who somebody was and what they wrote; the chains stay, with a note for each text."""
    rows = connection.execute("SELECT room, seq FROM log_text WHERE account=?", (account,))
    for room, seq in rows.fetchall():
        purge_text(connection, room, seq)
    connection.execute("DELETE FROM log_name WHERE account=?", (account,))
    connection.execute("DELETE FROM chat WHERE account=? OR reader=?", (account, account))
    connection.execute("DELETE FROM account WHERE id=?", (account,))


def purge_text(connection: sqlite3.Connection, room: str, seq: int, why: str = ASKED) -> None:
    """Remove the text of a record, and note that it was purged."""
    at = round(wall(), 3)
    (content,) = connection.execute(
        "SELECT content FROM log WHERE room=? AND seq=?", (room, seq)
    ).fetchone()
    connection.execute("DELETE FROM log_text WHERE room=? AND seq=?", (room, seq))
    seal = signature(connection, PURGED, room, seq, content, at, why)
    connection.execute(
        "INSERT OR REPLACE INTO log_purged VALUES (?,?,?,?,?)", (room, seq, at, why, seal)
    )


def _person(connection: sqlite3.Connection, entry: Entry) -> bytes:
    """Return the digest of who did it, the same for all that one person does in a room."""
    if entry.account is None:
        return NOBODY
    of = (entry.room, entry.account)
    row = connection.execute("SELECT salt FROM log_name WHERE room=? AND account=?", of).fetchone()
    salt = row[0] if row else secrets.token_bytes(SALT)
    if row is None:
        connection.execute(
            "INSERT INTO log_name (room, account, salt, name, seal) VALUES (?,?,?,?,?)",
            (*of, salt, entry.name, signature(connection, NAME, *of, salt, entry.name)),
        )
    return salted(salt, str(entry.account))
