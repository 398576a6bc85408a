"""An exported log: read, verified, and made into what a session repeats."""

from collections.abc import Sequence

import msgspec

from vrts.live.logs.logged_sessions import LogFault, LoggedSession, LogRow, sessions_of
from vrts.live.store.chain import START, Record, record_hash, salted


class _Head(msgspec.Struct, frozen=True):
    schema: str
    version: int
    room: str
    records: int
    last: str


class _Row(msgspec.Struct, frozen=True):
    seq: int
    session: int
    at_s: float
    wall: float
    kind: str
    accepted: bool
    person: str
    content: str
    previous: str
    hash: str
    salt: str | None
    text: msgspec.Raw


def read_log(data: bytes) -> tuple[LoggedSession, ...]:
    """Return the sessions of an exported log whose chain is unbroken.

    Raises:
        LogFault: It is none, was changed, or what a person did was purged.
    """
    lines = data.splitlines()
    try:
        head = msgspec.json.decode(lines[0] if lines else b"", type=_Head)
        rows = [msgspec.json.decode(line, type=_Row) for line in lines[1:]]
        if (head.schema, head.version) != ("vrts/live-log", 1):
            raise LogFault("this is no log of a live session")
        _verify(head, rows)
        return tuple(s.require_whole() for s in sessions_of(map(_log_row, rows)))
    except msgspec.DecodeError as problem:
        raise LogFault(f"this is no log of a live session: {problem}") from problem


def _verify(head: _Head, rows: Sequence[_Row]) -> None:
    previous = START
    for number, row in enumerate(rows, 1):
        try:
            record = Record(
                head.room,
                row.seq,
                row.session,
                row.at_s,
                row.wall,
                row.kind,
                row.accepted,
                bytes.fromhex(row.person),
                bytes.fromhex(row.content),
                bytes.fromhex(row.previous),
            )
            salt = None if row.salt is None else bytes.fromhex(row.salt)
        except ValueError as problem:
            raise LogFault(f"record {number} was changed") from problem
        unbroken = row.seq == number and record.previous == previous
        if not unbroken or record_hash(record).hex() != row.hash:
            raise LogFault(f"record {number} was changed, or one is missing")
        if salt is not None and salted(salt, bytes(row.text).decode()) != record.content:
            raise LogFault(f"the text of record {number} was changed")
        previous = record_hash(record)
    if head.records != len(rows) or head.last != previous.hex():
        raise LogFault("the end of the log is missing")


def _log_row(row: _Row) -> LogRow:
    owner = f"p{row.person[:16]}"  # the same for all that one person does
    text = None if row.salt is None else bytes(row.text)
    return LogRow(row.seq, row.session, row.kind, owner, text)
