"""An exported log: read, verified, and made into what a session repeats."""

from collections.abc import Sequence
from typing import NamedTuple

import msgspec

from vrts.live.actions import Action
from vrts.live.session.messages import Act, Halt
from vrts.live.session.replay import Entry
from vrts.live.store.chain import START, Record, record_hash, salted

NO_COMMANDS = frozenset(  # records of what else happened in a room
    ("begin", "close", "control", "freeze", "hand_over", "kick", "lock", "scene")
)


class LogFault(Exception):  # noqa: N818 -- names the situation
    """A log cannot be read, was changed, or cannot be replayed."""


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


class _Done(msgspec.Struct, frozen=True):
    at_s: float
    counts: bool = True


class _Command(msgspec.Struct, frozen=True):
    action: msgspec.Raw
    result: _Done | None


class _Begin(msgspec.Struct, frozen=True):
    scene: str


class LoggedSession(NamedTuple):
    """One session of a room, from one beginning to the next."""

    number: int
    scene: str  # id of a scene of the set
    entries: tuple[Entry, ...]


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
        return _sessions(rows)
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


def _sessions(rows: Sequence[_Row]) -> tuple[LoggedSession, ...]:
    found: list[LoggedSession] = []
    for row in rows:
        if row.kind == "begin":
            begun = msgspec.json.decode(row.text, type=_Begin)
            found.append(LoggedSession(row.session, begun.scene, ()))
        elif found and row.session == found[-1].number:
            entry = _entry(row)
            if entry is not None:
                found[-1] = found[-1]._replace(entries=(*found[-1].entries, entry))
    return tuple(found)


def _entry(row: _Row) -> Entry | None:
    """Return a command that a replay needs, None when the row is something else."""
    if row.kind in NO_COMMANDS:
        return None
    if row.salt is None:
        raise LogFault(f"record {row.seq} was purged, so the session cannot be replayed")
    command = msgspec.json.decode(row.text, type=_Command)
    done = command.result
    if done is None or not done.counts:
        return None
    if row.kind == "panic":
        return Entry(done.at_s, Halt(row.seq, done.at_s))
    action = msgspec.json.decode(command.action, type=Action)
    owner = f"p{row.person[:16]}"  # the same for all that one person does
    return Entry(done.at_s, Act(row.seq, done.at_s, owner, action))
