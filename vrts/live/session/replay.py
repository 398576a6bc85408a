"""A session repeated from its log: what was done, when it took effect, and the same run again."""

import math
import tempfile
from collections.abc import Iterable
from typing import NamedTuple

from vrts.engine.run import Run
from vrts.live.actions import Rewind, Save
from vrts.live.session.messages import Act, Done, Halt, News, Start
from vrts.live.session.session import Session
from vrts.live.session.setting import setting_of
from vrts.pipeline.settings import Setting


class Entry(NamedTuple):
    """A line of the log; entries whose `Done.counts` is false may be left out."""

    at_s: float  # `Done.at_s`
    order: Act | Halt
    done: Done | None = None  # what became of it, if that is known

    @property
    def was_refused(self) -> bool:
        """Whether it was refused for want of history, of which a replay may know more."""
        asked = self.order.action if isinstance(self.order, Act) else None
        return isinstance(asked, Rewind | Save) and self.done is not None and not self.done.accepted


def replay(
    start: Start,
    entries: Iterable[Entry],
    until_s: float | None = None,
    setting: Setting | None = None,
    *,
    whole: bool = False,
) -> Run:
    """Return the run of a session, with a horizon at its last entry or at a time [s].

    Files of users are written into a folder that is removed again.

    Args:
        start: What the session was about.
        entries: Its log, in order.
        until_s: How far it went on after the last entry; None: not at all.
        setting: Scene and task, if they are read already.
        whole: Whether all of it can be asked, however long it is; otherwise the last hour.

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
        setting = setting or setting_of(start)
        session = Session(begun, setting, _ignore, _no_clock, forgets=not whole)
        for entry in entries:
            if not entry.was_refused:
                session.repeat(entry.order, entry.at_s)
            session.showing.news()  # nobody hears it, and it is not to pile up
        if until_s is not None and not math.isnan(until_s):
            session.go_on(until_s)
        return session.run


def _ignore(news: News | bytes) -> None:
    """Tell nobody."""


def _no_clock() -> float:
    return 0.0
