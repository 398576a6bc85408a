"""The session that a room had when it or the server ended, from its log."""

from typing import NamedTuple

import msgspec

from vrts.live.logs.logged_sessions import NO_COMMANDS, LogFault, LoggedSession, LogRow, sessions_of
from vrts.live.session.channel.entries import Entry
from vrts.live.store import log, progress
from vrts.live.store.chain import salted
from vrts.live.store.database import Connection
from vrts.live.store.progress import Kept

_BESIDE = NO_COMMANDS - {"sleep", "wake"}


class Sleeping(msgspec.Struct, frozen=True):
    """How a room fell asleep, as its log has it."""

    at_s: float  # session time
    state: str = ""  # SHA-256 of the state in its folder; empty: it wakes from the log
    folder: str = ""  # name of the session's folder
    session: int = 0  # number of the session


class Unfinished(NamedTuple):
    """What is to be carried on."""

    session: LoggedSession
    until_s: float  # how far it had come
    slept: bool = False  # it fell asleep there, and nothing is to be stopped

    @property
    def last(self) -> Entry | None:
        """The last command that somebody gave; None: there is none."""
        given = (one for one in reversed(self.session.entries) if one.done is not None)
        return next(given, None)


def unfinished(connection: Connection, room: str, scene: str) -> Unfinished | None:
    """Return the session of a room that is to go on; None: it has had none, or it is over.

    Args:
        connection: Of the database.
        room: The room's id.
        scene: The scene that it has.

    Raises:
        LogFault: The log was changed, or a part of it purged.
    """
    rows = progress.last_session(connection, room)
    if not rows:
        return None
    wrong = log.verify(connection, room)
    if wrong:
        raise LogFault(wrong)
    try:
        (session,) = sessions_of(map(log_row, rows))
    except msgspec.DecodeError as problem:
        raise LogFault(f"its log cannot be read: {problem}") from problem
    if session.over or session.scene != scene:
        return None
    session.require_whole()
    sleeping = asleep(connection, room)
    if sleeping is not None:
        return Unfinished(session, sleeping.at_s, slept=True)
    until_s = progress.reached(connection, room, session.number, session.jumped)
    return Unfinished(session, max(until_s, session.least_s))


def asleep(connection: Connection, room: str) -> Sleeping | None:
    """Return how a room fell asleep that has not been woken since; None: it is awake.

    Raises:
        LogFault: That record was changed.
    """
    kept = progress.last_sleep(connection, room, _BESIDE)
    if kept is None or kept.text is None:
        return None
    if salted(kept.salt, kept.text) != kept.content:
        raise LogFault(f"the text of record {kept.seq} was changed")
    found = msgspec.json.decode(kept.text, type=Sleeping)
    return msgspec.structs.replace(found, session=kept.session)


def log_row(kept: Kept) -> LogRow:
    """Return a record of the database as what sessions are made of."""
    text = None if kept.text is None else kept.text.encode()
    return LogRow(kept.seq, kept.session, kept.kind, f"p{kept.account}", text)
