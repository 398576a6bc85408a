"""A session repeated from its log: what was done, when it took effect, and the same run again."""

import math
import tempfile
from collections.abc import Iterable
from typing import NamedTuple

from vrts.engine.run import Run
from vrts.live.session.messages import Act, Halt, News, Start
from vrts.live.session.session import Session
from vrts.live.session.setting import setting_of
from vrts.pipeline.settings import Setting


class Entry(NamedTuple):
    """A line of the log; entries whose `Done.counts` is false may be left out."""

    at_s: float  # `Done.at_s`
    order: Act | Halt


def replay(
    start: Start,
    entries: Iterable[Entry],
    until_s: float | None = None,
    setting: Setting | None = None,
) -> Run:
    """Return the run of a session, with a horizon at its last entry or at a time [s].

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
        begun = Start(
            start.session,
            folder,
            start.scene,
            start.task,
            start.lab,
            start.dialect,
            start.quota,
        )
        session = Session(begun, setting or setting_of(start), _ignore, _no_clock)
        for entry in entries:
            session.repeat(entry.order, entry.at_s)
        if until_s is not None and not math.isnan(until_s):
            session.go_on(until_s)
        return session.run


def _ignore(news: News | bytes) -> None:
    """Tell nobody."""


def _no_clock() -> float:
    return 0.0
