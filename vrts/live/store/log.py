"""The evaluation log of a room: append, export, verify, and purge of a person."""

import secrets
import sqlite3
from collections.abc import Iterator
from typing import Final, NamedTuple

import msgspec

from vrts.live.store.chain import START, Record, record_hash, salted

RECORD: Final = 300  # bytes that a record takes beside its text, about


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


def append(connection: sqlite3.Connection, entry: Entry) -> int:
    """Append a record; return its number."""
    last = connection.execute(
        "SELECT seq, hash FROM log WHERE room=? ORDER BY seq DESC LIMIT 1", (entry.room,)
    ).fetchone()
    seq, previous = (last[0] + 1, last[1]) if last else (1, START)
    salt = secrets.token_bytes(16)
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
        connection.execute("DELETE FROM log_text WHERE room=? AND seq=?", (entry.room, seq))


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
    """Return what is wrong with the log of a room; empty: nothing, purged or not."""
    previous = START
    for number, logged in enumerate(records(connection, room), 1):
        record = logged.record
        if record.seq != number:
            return f"record {number} is missing"
        if record.previous != previous or record_hash(record) != logged.hash:
            return f"record {number} was changed"
        previous = logged.hash
    rows = connection.execute(
        "SELECT seq, content, salt, text FROM log JOIN log_text USING (room, seq) WHERE room=?"
        " ORDER BY seq",
        (room,),
    )
    for seq, content, salt, text in rows:
        if salted(salt, text) != content:
            return f"the text of record {seq} was changed"
    return ""


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
    """Forget who somebody was and what they wrote; the chains stay as they are."""
    connection.execute("DELETE FROM log_text WHERE account=?", (account,))
    connection.execute("DELETE FROM log_name WHERE account=?", (account,))
    connection.execute("DELETE FROM chat WHERE account=? OR reader=?", (account, account))
    connection.execute("DELETE FROM account WHERE id=?", (account,))


def _person(connection: sqlite3.Connection, entry: Entry) -> bytes:
    """Return the digest of who did it, the same for all that one person does in a room."""
    if entry.account is None:
        return bytes(32)
    of = (entry.room, entry.account)
    row = connection.execute("SELECT salt FROM log_name WHERE room=? AND account=?", of).fetchone()
    salt = row[0] if row else secrets.token_bytes(16)
    if row is None:
        connection.execute(
            "INSERT INTO log_name (room, account, salt, name) VALUES (?,?,?,?)",
            (*of, salt, entry.name),
        )
    return salted(salt, str(entry.account))
