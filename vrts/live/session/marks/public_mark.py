"""The mark that a session would have now by the public checks of its task: shown live.

It is that of marking the session (`marking.session_run`), with the contacts found so far. Hidden
checks are not read by a session, so they can appear nowhere in it.
"""

import time
from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.units import MM
from vrts.check.judge import judge
from vrts.check.mark.mark import grade
from vrts.check.task.task import Task
from vrts.check.verdict import CollisionReport, ContactEvent
from vrts.engine.run import Run
from vrts.live.session.channel.messages import Json
from vrts.live.session.live_session import Session
from vrts.marking.submission.session_run import session_run

NOWHERE = (0.0, 0.0, 0.0)
PAUSE = 1.0  # [s] of session time between judgements at least
REST = 20.0  # times as long as one took is waited at least


class _Key(NamedTuple):
    """What a mark depends on, as far as it is told cheaply."""

    growing: int  # id of the run, another one after a reset
    time_s: float  # while something goes on, else 0
    statements: int
    motions: int
    events: int


class Judged(NamedTuple):
    """A mark, and how long it took to find."""

    mark: float
    took_s: float


class PublicMark:
    """Knows when to judge a session, and the mark of last time."""

    def __init__(self, session: Session) -> None:
        """Begin without one."""
        self._session = session
        self._key: _Key | None = None
        self._asked_s = -PAUSE
        self._pause = PAUSE

    @property
    def due(self) -> bool:
        """Whether the mark may be another one now."""
        session = self._session
        growing, task = session.growing, session.setting.task
        if task is None or not growing.knows_all:  # of a part nobody can tell the mark
            session.showing.mark = None
            return False
        rests = not 0.0 <= growing.time_s - self._asked_s < self._pause
        return rests and self._now != self._key

    def asked(self) -> None:
        """Take note that it is judged as it is now."""
        self._key, self._asked_s = self._now, self._session.growing.time_s

    def answered(self, judged: Judged | None) -> bool:
        """Take the answer; return whether the mark is another one."""
        if judged is None:
            return False
        self._pause = max(PAUSE, REST * judged.took_s)
        changed = judged.mark != self._session.showing.mark
        self._session.showing.mark = judged.mark
        return changed

    @property
    def _now(self) -> _Key:
        growing = self._session.growing
        system = growing.machine.system
        return _Key(
            id(growing),
            0.0 if self._session.at_rest else growing.time_s,
            growing.machine.finished,
            len(system.planner.given.motions),
            len(system.events),
        )


def judged(run: Run, task: Task, contacts: Sequence[Json]) -> Judged:
    """Return the mark of a session so far.

    Args:
        run: All of it.
        task: Its public part.
        contacts: Rows of the contacts found.
    """
    begun = time.monotonic()
    seen = session_run(run, task.t_max)
    report = CollisionReport(
        tuple(map(_event, contacts)), (), (), None, certified=True, statistics={}
    )
    judgement = judge(run.scene, seen, task, report=report)
    mark = float(grade(task, seen, judgement).mark)
    return Judged(mark, time.monotonic() - begun)


def _event(row: Json) -> ContactEvent:
    """Return what a mark needs of a contact: of what, when, and how deep."""
    start, end, depth = row["start"], row["end"], row["depthMm"]
    assert isinstance(depth, float | int)
    assert isinstance(start, float | int)
    assert isinstance(end, float | int)
    names = str(row["first"]), str(row["second"])
    return ContactEvent(*names, names, start, end, start, depth * MM, NOWHERE, None, None)
