"""A room that goes on from a moment of another room's session: its log begins with what was done.

The records until that moment are copied into the log of the new room, where they are done again as
after a restart of the server; so its log is complete in itself, and is verified, replayed and
purged like every other.
"""

from collections.abc import Sequence
from typing import Final, NamedTuple

import msgspec

from vrts.live.logs.logged_sessions import JUMPS, NO_COMMANDS, LogFault
from vrts.live.session.channel.messages import Done
from vrts.live.store import log
from vrts.live.store.branches import Branch, CopiedRow, keep_branch, rows_to_copy
from vrts.live.store.database import Connection
from vrts.live.store.progress import Reached, keep_reached
from vrts.live.store.rooms import KeptRoom, keep_room

NOTHING: Final = "there is no session to go on from"


class _Command(msgspec.Struct, frozen=True):
    action: msgspec.Raw
    result: Done | None


class _Rewind(msgspec.Struct, frozen=True):
    time_s: float


class _CarryOn(msgspec.Struct, frozen=True):
    at_s: float


class _Without(msgspec.Struct, frozen=True):
    seq: int


class _Step(NamedTuple):
    """A record that is done again."""

    row: CopiedRow
    at_s: float  # session time at which it took effect
    then_s: float | None = None  # session time after it; None: the same


def begin_branch(connection: Connection, kept: KeptRoom, branch: Branch, session: int) -> None:
    """Write a room that goes on from a moment of another, with all that was done until then.

    Args:
        connection: Of the database.
        kept: The new room.
        branch: Whose it is, and from where it goes on.
        session: Number of a session that is only in its log.

    Raises:
        LogFault: What was done cannot be done again.
    """
    rows = rows_to_copy(connection, branch.origin)
    wrong = log.verify(connection, branch.origin)
    if wrong:
        raise LogFault(wrong)
    try:
        records = until(rows, branch.at_s, kept.scene)
    except msgspec.DecodeError as problem:
        raise LogFault(f"its log cannot be read: {problem}") from problem
    keep_room(connection, kept)
    for row in records:
        text = _begun(row, branch) if row.kind == "begin" else row.text or ""
        what = (row.at_s, row.wall, row.kind, row.accepted, row.account, row.name or "", text)
        log.append(connection, log.Entry(kept.id, session, *what))
    keep_reached(connection, (Reached(kept.id, session, branch.at_s),))
    keep_branch(connection, branch)


def until(rows: Sequence[CopiedRow], at_s: float, scene: str) -> list[CopiedRow]:
    """Return the records that lead to a moment of the last session of a log.

    Args:
        rows: From its beginning on.
        at_s: Session time, as it counts now [s].
        scene: That the session is to have.

    Raises:
        LogFault: There is no such session, or a part of what was done was purged.
        msgspec.DecodeError: A text is none of a log.
    """
    if not rows or rows[0].kind != "begin" or rows[0].text is None:
        raise LogFault(NOTHING)
    if any(row.kind == "scene" for row in rows) or _scene(rows[0].text) != scene:
        raise LogFault("the session is over: another scene was asked for")
    steps = _steps(rows)
    jumped = max((n for n, step in enumerate(steps) if step.then_s is not None), default=-1)
    begun_s = steps[jumped].then_s or 0.0 if jumped >= 0 else 0.0
    found = [step.row for step in steps[: jumped + 1]]
    if at_s >= begun_s:
        found += [step.row for step in steps[jumped + 1 :] if step.at_s <= at_s]
    else:
        found.append(_rewound(steps[jumped].row, begun_s, at_s))
    purged = next((row.seq for row in found if row.text is None), 0)
    if purged:
        raise LogFault(f"record {purged} was purged, so nobody can go on from this session")
    return [rows[0], *found]


def _steps(rows: Sequence[CopiedRow]) -> list[_Step]:
    """Return the records that count, with their times; what was taken back is left out."""
    found: list[_Step] = []
    number = rows[0].session
    for row in rows[1:]:
        if row.kind == "carry_on":
            number = row.session
            stopped = msgspec.json.decode(row.text or "", type=_CarryOn)
            found.append(_Step(row, stopped.at_s))
        elif row.kind == "without":
            seq = msgspec.json.decode(row.text or "", type=_Without).seq
            at = next((n for n, step in enumerate(found) if step.row.seq == seq), len(found))
            del found[at:]
        elif row.kind not in NO_COMMANDS and row.session == number:
            step = _command(row)
            if step is not None:
                found.append(step)
    return found


def _command(row: CopiedRow) -> _Step | None:
    if row.text is None:
        return _Step(row, row.at_s)
    command = msgspec.json.decode(row.text, type=_Command)
    done = command.result
    if done is None or not done.counts:
        return None
    if row.kind not in JUMPS or not done.accepted:
        return _Step(row, done.at_s)
    rewinds = row.kind == "rewind"
    then_s = msgspec.json.decode(command.action, type=_Rewind).time_s if rewinds else 0.0
    return _Step(row, done.at_s, then_s)


def _rewound(after: CopiedRow, now_s: float, at_s: float) -> CopiedRow:
    """Return a record that takes a session back to a moment before its last jump."""
    action = {"type": "rewind", "time_s": at_s}
    text = msgspec.json.encode({"action": action, "result": Done(0, now_s, True)}).decode()
    return after._replace(at_s=now_s, kind="rewind", accepted=True, text=text)


def _scene(text: str) -> object:
    return msgspec.json.decode(text, type=dict[str, object]).get("scene")


def _begun(row: CopiedRow, branch: Branch) -> str:
    """Return the text of a beginning, which says from where the room goes on."""
    begun = msgspec.json.decode(row.text or "{}", type=dict[str, object])
    begun |= {"branch_of": branch.origin, "branch_s": branch.at_s}
    return msgspec.json.encode(begun).decode()
