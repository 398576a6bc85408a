"""A session carried on after it or its server has ended: all that was done is done again, exactly.

What the machine answers is compared with what it answered before, so a session either stands where
it stood, or is not carried on.
"""

import time
from collections.abc import Callable, Iterable
from enum import Enum
from pathlib import Path

import msgspec

from vrts.live.session.again.replay import same_answer
from vrts.live.session.channel.entries import Entry
from vrts.live.session.channel.messages import Done, News
from vrts.live.session.live_session import Session

LONGEST = 300.0  # [s] of processor time; an hour of a class takes a few
EFFECT = 0.1  # [s] of session time after the last command: it takes effect at the next tick
STRETCH = 10.0  # [s] of session time between looks whether to go on
STOPPED_HERE = "the room goes on from here: arm and programs were stopped"
STOPPED = "the session was started again: arm and programs were stopped, and it goes on"

_entry = msgspec.json.Decoder(Entry)


class How(Enum):
    """How a session goes on that was repeated."""

    STOPPED = "stopped"  # its process or server has ended: everything stands still
    EXACT = "exact"  # just where another session stood, stopped
    SLEPT = "slept"  # just where it fell asleep, as if nothing had been


class CannotCarryOn(Exception):  # noqa: N818 -- names the situation
    """A session has to begin anew; the text says why."""


class Interrupted(Exception):  # noqa: N818 -- names the situation
    """Nobody wants the session any more."""


class Voice:
    """Where a session speaks to: nobody while it is repeated, then the server."""

    def __init__(self) -> None:
        """Speak to nobody."""
        self.to: Callable[[News | bytes], None] | None = None
        self.done: Done | None = None  # the last answer to an order

    def __call__(self, news: News | bytes) -> None:
        """Say something."""
        if self.to is not None:
            self.to(news)
        elif isinstance(news, Done):
            self.done = news


def read_entries(path: Path) -> list[Entry]:
    """Return what was done before, and remove the file.

    Raises:
        CannotCarryOn: It cannot be read.
    """
    try:
        return [_entry.decode(line) for line in path.read_bytes().splitlines()]
    except (OSError, msgspec.DecodeError) as problem:
        raise CannotCarryOn(f"its log cannot be read: {problem}") from problem
    finally:
        path.unlink(missing_ok=True)


def carry_on(
    session: Session,
    voice: Voice,
    entries: Iterable[Entry],
    until_s: float,
    *,
    how: How = How.STOPPED,
    wanted: Callable[[], bool] = lambda: True,
) -> None:
    """Do again what was done before, go on to a time, and stop everything there.

    Args:
        session: One that has just begun.
        voice: Its own, that speaks to nobody yet.
        entries: What was done, with what was answered.
        until_s: How far it had come [s]; commands may have come later. What was
            acknowledged takes effect before it is stopped.
        how: How it goes on from there.
        wanted: Asked now and then whether anybody still waits for it.

    Raises:
        CannotCarryOn: It would not be the same, or takes too long.
        Interrupted: Nobody waits.
    """
    latest = time.process_time() + LONGEST

    def go_on(time_s: float) -> None:
        while (following := min(session.growing.time_s + STRETCH, time_s)) < time_s:
            session.go_on(following)
            look()
        session.go_on(time_s)
        look()

    def look() -> None:
        session.showing.news()  # it was told before
        if time.process_time() > latest:
            raise CannotCarryOn("it takes too long to repeat all that was done")
        if not wanted():
            raise Interrupted

    try:
        for entry in entries:
            if entry.was_refused:  # of which the file of its history may know more or less now
                continue
            go_on(entry.at_s)
            voice.done = None
            session.repeat(entry.order, entry.at_s)
            if not same_answer(entry.done, voice.done):
                raise CannotCarryOn("the same commands have other results now")
        go_on(max(until_s, session.growing.time_s + (EFFECT if how is How.STOPPED else 0.0)))
    except ValueError as problem:  # an order before the one that came earlier
        raise CannotCarryOn(f"its log does not fit: {problem}") from problem
    if how is How.SLEPT:
        session.go_on_from_here()
    else:
        session.stand_still(STOPPED_HERE if how is How.EXACT else STOPPED)
