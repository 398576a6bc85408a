"""The mark that a session would have now by the public checks of its task: shown live.

It is that of marking the session (`marking.session_run`), with the contacts found so far. Hidden
checks are not read by a session, so they can appear nowhere in it.
"""

import time
from collections.abc import Sequence
from typing import NamedTuple, cast

from msgspec.structs import replace

from vrts.base.units import MM
from vrts.check.collision.of_run import motion_of
from vrts.check.collision.telling.cause import cause_at
from vrts.check.judge import judge
from vrts.check.mark.grade import Grade
from vrts.check.mark.losses import Mishap, mishaps_of
from vrts.check.mark.mark import grade
from vrts.check.task.task import Task
from vrts.check.verdict import CollisionReport, ContactEvent
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.live.session.channel.messages import Json, Marked
from vrts.live.session.channel.rows import Lost, Part
from vrts.live.session.live_session import Session
from vrts.marking.submission.session_run import session_run
from vrts.report.plain import capital, one_line
from vrts.report.quantities import MINUS, lost, points, seconds

NOWHERE = (0.0, 0.0, 0.0)
ROUNDED = 0.0005  # [s] by which times of rows may be early
STILL_RUNS = "the program still runs: what is not reached yet counts as lost"
MOST = 100  # lost points, and things asked for, that are told
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
    """A mark with every lost point, and how long it took to find."""

    told: Marked
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
            session.showing.marked = None
            return False
        rests = not 0.0 <= growing.time_s - self._asked_s < self._pause
        return rests and self._now != self._key

    @property
    def stale(self) -> bool:
        """Whether the mark that is shown is not of now."""
        known = self._session.setting.task is None or not self._session.growing.knows_all
        return not known and self._now != self._key

    def asked(self) -> None:
        """Take note that it is judged as it is now."""
        self._key, self._asked_s = self._now, self._session.growing.time_s

    def answered(self, judged: Judged | None) -> bool:
        """Take the answer, and tell what has changed; return whether the mark is another one."""
        if judged is None:
            return False
        self._pause = max(PAUSE, REST * judged.took_s)
        showing = self._session.showing
        before, showing.marked = showing.marked, judged.told
        if before is None or before != replace(judged.told, time_s=before.time_s):
            showing.tell(judged.told)
        return before is None or judged.told.mark != before.mark

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
    events = [contact_event(row, run) for row in contacts]
    counted = tuple(event for event in events if event.start_s < seen.horizon_s)
    report = CollisionReport(counted, (), (), None, certified=True, statistics={})
    judgement = judge(run.scene, seen, task, report=report)
    told = marked(grade(task, seen, judgement), seen, mishaps_of(seen, judgement))
    return Judged(told, time.monotonic() - begun)


def marked(grade: Grade, run: Run, mishaps: Sequence[Mishap]) -> Marked:
    """Return a mark as clients take it, in the words of the report.

    Args:
        grade: The mark.
        run: Of which it is.
        mishaps: All contacts and drops; those that cost nothing, or nothing yet, are told too.
    """
    losses = [
        loss._replace(sentence=STILL_RUNS)
        if loss.kind == "program" and run.ending is Ending.RUNNING
        else loss
        for loss in grade.losses
    ]
    known = {loss.sentence for loss in losses}
    losses += [mishap.loss for mishap in mishaps if mishap.loss.sentence not in known]
    return Marked(
        seconds(run.horizon_s),
        float(grade.mark),
        float(grade.total),
        tuple(
            Lost(
                lost(loss.points),
                loss.kind,
                capital(one_line(loss.sentence)),
                None if loss.moment is None else seconds(loss.moment.time_s),
            )
            for loss in losses[:MOST]
        ),
        tuple(
            Part(
                part.check,
                one_line(part.title),
                part.kind,
                "" if part.answer is None else part.answer.value,
                f"{MINUS if part.points < 0 else ''}{points(abs(part.points))}",
                points(part.most),
                capital(one_line(part.message)),
            )
            for part in grade.earned[:MOST]
        ),
    )


def contact_event(row: Json, run: Run) -> ContactEvent:
    """Return what a mark needs of a contact: of what, when, how deep, and by which step."""
    start, end, depth = (_number(row, name) for name in ("start", "end", "depthMm"))
    first, second = str(row["first"]), str(row["second"])
    one, other, *_ = (*_parts(row), first, second)
    held = row.get("held")
    held_then = held if isinstance(held, str) and held else None
    deepest = _number(row, "deepest")
    cause = cause_at(run, motion_of(run), min(start + ROUNDED, run.horizon_s))
    return ContactEvent(
        *(first, second, (one, other), start, end, deepest, depth * MM, NOWHERE),
        *(held_then, cause),
    )


def _parts(row: Json) -> list[str]:
    parts = cast("Sequence[object]", row.get("parts", ()))
    return [str(part) for part in parts]


def _number(row: Json, name: str) -> float:
    value = row[name]
    assert isinstance(value, float | int)
    return value
