"""The sessions that the log of a room holds: what was done in each, to be done again.

A session goes on under another number after the server was started again: then its arm and programs
were stopped, which is part of what is done again.
"""

from collections.abc import Iterable
from typing import NamedTuple

import msgspec

from vrts.controllers.models import FIRST
from vrts.live.actions import Action
from vrts.live.session.channel.entries import Entry
from vrts.live.session.channel.messages import Act, Done, Halt

NO_COMMANDS = frozenset(  # records of what else happened in a room
    ("allow", "close", "control", "freeze", "hand_over", "join", "kick", "lock", "note")
) | {"sleep", "wake"}  # as if nothing had been: session time stands still meanwhile
JUMPS = frozenset(("reset", "rewind"))  # after which session time is another one


class LogFault(ValueError):  # noqa: N818 -- names the situation
    """A log cannot be read, was changed, or cannot be replayed."""


class LogRow(NamedTuple):
    """A record of the log of a room, as far as it matters here."""

    seq: int
    session: int  # number of the session
    kind: str
    owner: str  # whose folder the monitor used, the same for all that one person does
    text: bytes | None  # JSON; None: purged


class LoggedSession(NamedTuple):
    """One session of a room, from one beginning to the next."""

    number: int  # the last one that it had
    scene: str  # id of a scene of the set
    scene_sha256: str  # of what is drawn
    entries: tuple[Entry, ...]
    jumped: int = 0  # record after which session time was another one; 0: none
    least_s: float = 0.0  # how far it has to go on at least: a command there was taken back
    over: bool = False  # another scene was asked for
    branched: int = 0  # number that it has while it is only copied; 0: it goes on from no other
    purged: int = 0  # the first record of which a part was purged; 0: none
    controller: str = FIRST.name  # model that it went by; before logs said so, the first
    controller_sha256: str = ""  # of what that model said; empty: the log does not say

    @property
    def exact(self) -> bool:
        """Whether it is to stand where another session stood: nothing was done in it yet."""
        return self.branched == self.number

    def require_whole(self) -> "LoggedSession":
        """Return it if it can be done again.

        Raises:
            LogFault: What a person did in it was purged.
        """
        if self.purged:
            problem = f"record {self.purged} was purged, so the session cannot be replayed"
            raise LogFault(problem)
        return self


class _Begin(msgspec.Struct, frozen=True):
    scene: str
    scene_sha256: str = ""
    controller: str = FIRST.name
    controller_sha256: str = ""
    branch_of: str = ""  # room


class _CarryOn(msgspec.Struct, frozen=True):
    at_s: float


class _Without(msgspec.Struct, frozen=True):
    seq: int  # of the record that does not count any more


class _Command(msgspec.Struct, frozen=True):
    action: msgspec.Raw
    result: Done | None


def sessions_of(rows: Iterable[LogRow]) -> tuple[LoggedSession, ...]:
    """Return the sessions of a room from its records, in order.

    Raises:
        msgspec.DecodeError: A text is none of a log.
    """
    found: list[LoggedSession] = []
    entries: list[Entry] = []
    for row in rows:
        if row.kind == "begin":
            _close(found, entries)
            begun = msgspec.json.decode(row.text or b"", type=_Begin)
            session = LoggedSession(row.session, begun.scene, begun.scene_sha256, ())
            model = (begun.controller, begun.controller_sha256)
            session = session._replace(branched=row.session if begun.branch_of else 0)
            found.append(session._replace(controller=model[0], controller_sha256=model[1]))
        elif found and row.kind == "scene":
            found[-1] = found[-1]._replace(over=True)
        elif found and row.kind == "carry_on":
            stopped = msgspec.json.decode(row.text or b"", type=_CarryOn)
            entries.append(Entry(stopped.at_s, Halt(row.seq, stopped.at_s)))
            found[-1] = found[-1]._replace(number=row.session)
        elif found and row.kind == "without":
            seq = msgspec.json.decode(row.text or b"", type=_Without).seq
            found[-1] = found[-1]._replace(jumped=row.seq, least_s=_take_back(entries, seq))
        elif found and row.session == found[-1].number and row.kind not in NO_COMMANDS:
            if row.text is None:
                found[-1] = found[-1]._replace(purged=found[-1].purged or row.seq)
                continue
            entry = _entry(row, row.text)
            if entry is not None:
                entries.append(entry)
            if row.kind in JUMPS:
                found[-1] = found[-1]._replace(jumped=row.seq, least_s=0.0)
    _close(found, entries)
    return tuple(found)


def _close(found: list[LoggedSession], entries: list[Entry]) -> None:
    """Give the session that has come to its end what was done in it."""
    if found:
        found[-1] = found[-1]._replace(entries=tuple(entries))
    entries.clear()


def _take_back(entries: list[Entry], seq: int) -> float:
    """Take off the last command, and what the server did after it; return when it was given [s]."""
    at = next((n for n, entry in enumerate(entries) if entry.order.ref == seq), len(entries))
    taken = entries[at:]
    del entries[at:]
    if not taken or (isinstance(taken[0].order, Act) and _jumps(taken[0].order)):
        return 0.0
    return taken[0].at_s


def _jumps(order: Act) -> bool:
    return order.action.__struct_config__.tag in JUMPS


def _entry(row: LogRow, text: bytes) -> Entry | None:
    """Return a command that a replay needs, None when it had no effect."""
    command = msgspec.json.decode(text, type=_Command)
    done = command.result
    if done is None or not done.counts:
        return None
    if row.kind == "panic":
        return Entry(done.at_s, Halt(row.seq, done.at_s), done)
    action = msgspec.json.decode(command.action, type=Action)
    return Entry(done.at_s, Act(row.seq, done.at_s, row.owner, action), done)
