"""The voices of a session, from the log of its room and the chat, at the session's own times.

What everybody could read is taken and nothing else: private lines are left out. Of who was purged
nothing is there. Lines of the chat are known by the clock on the wall; what the log knows of both
times tells when in the session that was.
"""

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Final

import msgspec

from vrts.report.voices.rows import Voice

SERVER: Final = "Server"
NOBODY: Final = ""
BEFORE: Final = " (before the session went back)"


class Said(msgspec.Struct, frozen=True):
    """A line of the chat that everybody could read."""

    at: float  # Unix time [s]
    name: str  # empty: the server
    text: str


class _Row(msgspec.Struct, frozen=True):
    """What is read of a record."""

    at_s: float
    wall: float
    kind: str
    accepted: bool
    text: msgspec.Raw
    name: str | None = None

    @property
    def purged(self) -> bool:
        return bytes(self.text) == b"null"


class _Text(msgspec.Struct, frozen=True):
    """What is read of the texts of records."""

    on: bool = True
    at_s: float = 0.0
    text: str = ""
    action: msgspec.Raw = msgspec.Raw(b"{}")


class _Rewind(msgspec.Struct, frozen=True):
    time_s: float = 0.0


@dataclass
class _Clock:
    """What the clock on the wall showed at some session times, in order."""

    walls: list[float] = field(default_factory=list[float])
    times_s: list[float] = field(default_factory=list[float])

    def note(self, wall: float, at_s: float) -> None:
        if not self.walls or wall >= self.walls[-1]:  # who sets a clock back makes no order
            self.walls.append(wall)
            self.times_s.append(at_s)

    def at_s(self, wall: float) -> float:
        """Return the session time, never later than what is known to have come after it."""
        k = bisect_right(self.walls, wall)
        if k == 0:
            return 0.0
        found = self.times_s[k - 1] + wall - self.walls[k - 1]
        following = self.times_s[k] if k < len(self.times_s) else found
        return min(found, following) if following >= self.times_s[k - 1] else found


def voices_of(
    log: bytes, session: int, chat: Iterable[Said] = (), end_s: float = 0.0
) -> tuple[Voice, ...]:
    """Return the voices of a session.

    Args:
        log: Exported, with names or without; its chain was verified.
        session: Which one of the log, from 0.
        chat: Of the room, in order.
        end_s: When the replay ends [s].
    """
    rows = [msgspec.json.decode(line, type=_Row) for line in log.splitlines()[1:]]
    begins = [k for k, row in enumerate(rows) if row.kind == "begin"]
    first = begins[session]
    last = begins[session + 1] if session + 1 < len(begins) else len(rows)
    until = rows[last].wall if last < len(rows) else float("inf")
    holder = next((r.name for r in reversed(rows[:first]) if r.kind == "control"), None)
    told = _Telling(holder or NOBODY)
    pending = [line for line in chat if rows[first].wall <= line.at < until]
    for row in rows[first:last]:
        while pending and pending[0].at < row.wall:
            told.say(pending.pop(0))
        told.take(row)
    for line in pending:
        told.say(line)
    return told.all(end_s)


class _Telling:
    """Goes through a session in the order in which things happened."""

    def __init__(self, holder: str) -> None:
        self._voices: list[Voice] = []
        self._clock = _Clock()
        self._now_s = 0.0
        self._held: list[tuple[float, str]] = [(0.0, holder)]  # from when on, by whom

    def say(self, line: Said) -> None:
        self._now_s = max(self._now_s, self._clock.at_s(line.at))
        self._add("chat", line.name or SERVER, line.text)

    def take(self, row: _Row) -> None:
        known = row.at_s > 0.0 or row.kind == "begin"
        if known:
            self._clock.note(row.wall, row.at_s)
            self._now_s = row.at_s
        else:
            self._now_s = max(self._now_s, self._clock.at_s(row.wall))
        name = row.name or ("" if row.purged else SERVER)
        text = _Text() if row.purged else msgspec.json.decode(row.text, type=_Text)
        match row.kind:
            case "begin":
                self._now_s = 0.0
            case "carry_on":
                self._now_s = text.at_s
                self._clock.note(row.wall, text.at_s)
            case "control":
                self._held.append((self._now_s, row.name or NOBODY))
            case "reset" if row.accepted:
                self._back(row.wall, 0.0)
            case "rewind" if row.accepted and not row.purged:
                wanted = msgspec.json.decode(text.action, type=_Rewind)
                self._back(row.wall, min(wanted.time_s, self._now_s))
            case _ if not row.purged:
                for kind, words in _told(row, text):
                    self._add(kind, name, words)
            case _:
                pass

    def all(self, end_s: float) -> tuple[Voice, ...]:
        """Return everything, with who had control for how long."""
        found = list(self._voices)
        ends = [since for since, _ in self._held[1:]] + [max(end_s, self._held[-1][0])]
        for (since, name), end in zip(self._held, ends, strict=True):
            if name and end > since:
                found.append(Voice(since, "control", name, "has control", end))
        return tuple(sorted(found, key=lambda voice: voice.at_s))

    def _add(self, kind: str, name: str, text: str) -> None:
        self._voices.append(Voice(self._now_s, kind, name, text))

    def _back(self, wall: float, to_s: float) -> None:
        """Session time is an earlier one from here on: what lies later is of another future."""
        self._voices = [
            v if v.at_s <= to_s else v._replace(at_s=to_s, text=v.text + BEFORE)
            for v in self._voices
        ]
        self._held = [(min(since, to_s), name) for since, name in self._held]
        self._now_s = to_s
        self._clock.note(wall, to_s)


def _told(row: _Row, text: _Text) -> Iterator[tuple[str, str]]:
    """Yield the kind and the words of what somebody did, if it is for this list."""
    match row.kind:
        case "note":
            yield "note", text.text
        case "join":
            yield "people", "comes in"
        case "kick":
            yield "people", "sends somebody away"
        case "panic":
            yield "stop", "presses PANIC"
        case "freeze":
            yield "stop", "freezes the room" if text.on else "lets the room go on"
        case "lock":
            yield "stop", "locks the control right" if text.on else "unlocks the control right"
        case _:
            pass


def index_of(sessions: Sequence[object], wanted: object) -> int:
    """Return which session of a log one is."""
    return next(k for k, session in enumerate(sessions) if session is wanted)
