"""A session repeated from its log: what was done, when it took effect, and the same run again."""

import math
import tempfile
from collections.abc import Iterable

import msgspec

from vrts.engine.run import Run
from vrts.live.session.channel.entries import Entry
from vrts.live.session.channel.messages import Done, News, Start
from vrts.live.session.live_session import Session
from vrts.live.session.setting import setting_of
from vrts.pipeline.setting import Setting


class Differs(ValueError):  # noqa: N818 -- names the situation
    """What is done again has other results than it had."""


def replay(
    start: Start,
    entries: Iterable[Entry],
    until_s: float | None = None,
    setting: Setting | None = None,
) -> Run:
    """Return the run of a session with all of its history, up to its last entry or a time [s].

    Files of users are written into a folder that is removed again.

    Args:
        start: What the session was about.
        entries: Its log, in order.
        until_s: How far it went on after the last entry; None: not at all.
        setting: Scene and task, if they are read already.

    Raises:
        ValueError: The log does not fit: a time lies before what came earlier.
        CannotRead: Scene, task or lab are not there.
        Refused: They have errors.
    """
    with tempfile.TemporaryDirectory() as folder:
        begun = msgspec.structs.replace(start, folder=folder)
        setting = setting or setting_of(start)
        session = Session(begun, setting, _ignore, _no_clock, forgets=False)
        for entry in entries:
            if not entry.was_refused:
                session.repeat(entry.order, entry.at_s)
                session.showing.news()  # nobody hears it, and it is not to pile up
        if until_s is not None and not math.isnan(until_s):
            session.go_on(until_s)
        return session.run


def replay_whole(setting: Setting, entries: Iterable[Entry], most_s: float) -> Run:
    """Return the run of a session with all of its history, until everything is at rest.

    Every answer is compared with the one that was given, so it is the session as it was.

    Args:
        setting: Scene and task.
        entries: Its log, in order.
        most_s: How long to go on after the last entry at most [s].

    Raises:
        Differs: It is not: scene, task or vrts are not what they were.
    """
    heard: dict[int, Done] = {}

    def hear(news: News | bytes) -> None:
        if isinstance(news, Done):
            heard[news.ref] = news

    with tempfile.TemporaryDirectory() as folder:
        session = Session(Start(0, folder), setting, hear, _no_clock, forgets=False)
        for entry in entries:
            if entry.was_refused:
                continue
            if entry.at_s < session.growing.time_s:
                raise Differs(f"{entry.at_s:.3f} s lies before what came earlier")
            session.repeat(entry.order, entry.at_s)
            session.showing.news()
            if not same_answer(entry.done, heard.pop(entry.order.ref, None)):
                raise Differs(f"what was done at {entry.at_s:.3f} s has other results now")
        latest = session.growing.time_s + most_s
        while not session.at_rest and session.growing.time_s < latest:
            session.go_on(min(session.growing.time_s + 1.0, latest))
            session.showing.news()
        return session.run


def same_answer(before: Done | None, now: Done | None) -> bool:
    """Return whether an answer is the one that was given before, as far as both are known."""
    if before is None or now is None:
        return True
    return (before.accepted, before.code, before.text, before.row) == (
        now.accepted,
        now.code,
        now.text,
        now.row,
    )


def _ignore(news: News | bytes) -> None:
    """Tell nobody."""


def _no_clock() -> float:
    return 0.0
