"""Contacts and near misses of what was moved, certified beside the session, and the mark of it.

What is new is checked in a child forked from the session, so no frame is late; where there is no
fork, in the session itself. A check begins where nothing is in the hand, so that the rules of
grasps hold: what may touch whom depends on how it was grasped.
"""

import dataclasses
import math
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import msgspec

from vrts.check.collision.collision import check_collisions
from vrts.check.collision.pairs.findings import EVENT_GAP
from vrts.check.verdict import CollisionReport
from vrts.engine.memory.events import Cause, Event, Grasped, HandCommanded, Released
from vrts.engine.memory.records import Lie, Motion, Placement, Segment
from vrts.engine.run import Run
from vrts.live.session.channel.messages import Checked, Json
from vrts.live.session.growing.growing_run import GrowingRun
from vrts.live.session.growing.tidying import tidy
from vrts.live.session.live_session import Session
from vrts.live.session.marks.public_mark import Judged, PublicMark, judged
from vrts.live.session.marks.turns import NoTurns, Turns
from vrts.live.session.operator.motions import instructed
from vrts.marking.supervise.aside import FORKS, Aside
from vrts.marking.supervise.limits import Limits
from vrts.monitor.desk import ALONE
from vrts.pipeline.setting import Setting
from vrts.report.page.replay_data import contact_rows, near_rows
from vrts.scene.model import Scenario

PAUSE = 1.0  # [s] of session time between checks
STRETCH = 300.0  # [s] of session time that is checked at once at most, as after a restart
REST = 40.0  # times as long as a check took is waited at least: ten sessions share the machine
LONGEST_PAUSE = 10.0  # [s]
TURN = 2.0  # [s] of session time after which others may check beside one that takes long
NICENESS = 10  # of what may be late, such as checks, to frames, which may not
BEFORE = 0.1  # [s] before a hand begins to close
CLOSING = 10.0  # [s], longer than any hand takes to close
LIMITS = Limits(
    cpu_s=60, wall_s=120.0, memory=1_000_000_000, niceness=NICENESS, among_all=NICENESS // 2
)


class _Segments(NamedTuple):
    """The part of a timeline that is checked."""

    segments: Sequence[Segment]


class _Window(NamedTuple):
    """The part of a run that is checked."""

    timeline: _Segments
    motions: Sequence[Motion]
    events: Sequence[Event]
    placements: Mapping[str, Sequence[Placement]]


class Found(msgspec.Struct, frozen=True):
    """What a check answers with."""

    until_s: float
    contacts: tuple[Json, ...]
    near: tuple[Json, ...]
    undetermined: bool
    judged: Judged | None = None  # the public mark, where it was asked for


class Checker:
    """Checks what a session does, some time after it was done."""

    def __init__(
        self, session: Session, *, forks: bool = FORKS, turns: Turns | None = None
    ) -> None:
        """Check from the beginning of a session.

        Args:
            session: Whose.
            forks: Whether there are children.
            turns: Who of several sessions may check now; None: all of them.
        """
        self._session = session
        self._turns = turns or NoTurns()
        self.aside = Aside(LIMITS, forks=forks)
        self._asked = (0.0, 0)  # until when, and of which growing run
        self._looked_s = 0.0
        self._pause = PAUSE
        self._mark = PublicMark(session)
        self._judges = False  # whether the mark was asked for

    def close(self) -> None:
        """End with the session."""
        self.aside.close()
        self._turns.give_back()

    @property
    def settled(self) -> bool:
        """Whether all that was done is checked and judged."""
        session = self._session
        moved = _anything_moved(session.growing, session.showing.checked_s)
        return not (self.aside.busy or moved or self._mark.stale)

    def beat(self) -> None:
        """Take the answer that has come, and ask for what is new, if it is time."""
        self._take()
        showing, growing = self._session.showing, self._session.growing
        since = growing.time_s - self._looked_s
        if self.aside.busy:
            if not 0.0 <= since < TURN:
                self._turns.give_back()
            return
        if 0.0 <= since < self._pause:
            return
        if not _anything_moved(growing, showing.checked_s):
            showing.checked_s = growing.time_s
            if not self._mark.due:
                self._looked_s = growing.time_s
                return
        if not self._turns.take():
            return  # at the next beat, then
        self._looked_s = growing.time_s
        until_s = min(growing.time_s, showing.checked_s + STRETCH)
        self._asked = (until_s, id(growing))
        self._judges = until_s == growing.time_s and self._mark.due
        if self._judges:
            self._mark.asked()
        growing.drop_run()
        tidy()  # forking freezes what there is, garbage too
        self.aside.begin(self._check)
        self._take()

    def _take(self) -> None:
        """Take the answer, if it has come, and rest from it."""
        done = self.aside.take()
        if done is not None:
            self._turns.give_back()
            checking_s = done.took_s - self._answered(done.answer)
            self._pause = min(max(PAUSE, REST * checking_s), LONGEST_PAUSE)

    def _check(self) -> bytes:
        """Check what is new."""
        session, showing = self._session, self._session.showing
        task = session.setting.task
        near_miss = None if task is None else task.near_miss
        run = session.growing.run_since(needed_from(session.growing, showing.checked_s))
        found = checked(run or session.run, showing.checked_s, near_miss, self._asked[0])
        whole = session.growing.run_since(0.0) if self._judges else None
        if whole is not None and task is not None:
            contacts = list(showing.contacts)
            for _ in _news(contacts, found.contacts):
                pass
            found = msgspec.structs.replace(found, judged=judged(whole, task, contacts))
        return msgspec.json.encode(found)

    def _answered(self, answer: bytes | None) -> float:
        """Take an answer; return how long the judging in it took [s]."""
        showing, growing = self._session.showing, self._session.growing
        until_s, of = self._asked
        if of != id(growing) or until_s > growing.time_s:
            return 0.0  # the session was reset or rewound meanwhile
        if answer is None:
            showing.checked_s = until_s
            showing.tell(Checked(until_s, (), (), undetermined=True, mark=showing.mark))
            return 0.0
        found = msgspec.json.decode(answer, type=Found)
        changed = self._mark.answered(found.judged)
        fresh = Checked(
            until_s,
            tuple(_news(showing.contacts, found.contacts)),
            tuple(_news(showing.near, found.near)),
            found.undetermined,
            showing.mark,
        )
        showing.forget_contacts()
        showing.checked_s = until_s
        if fresh.contacts or fresh.near or fresh.undetermined or changed:
            showing.tell(fresh)
        return 0.0 if found.judged is None else found.judged.took_s


def warm_up(setting: Setting) -> None:
    """Check a short motion, so that no child has to load and prepare what all of them need."""
    growing = GrowingRun(setting.scene, Scenario())
    growing.issue(instructed("DRIVE 6,1,100"))
    growing.advance(1.0)
    checked(growing.run, 0.0, None)


def checked(run: Run, since_s: float, near_miss: float | None, until_s: float = math.inf) -> Found:
    """Return the contacts and near misses that end after a time and begin before another [s]."""
    report = certified(run, since_s, near_miss, until_s)
    contacts, near = report.contacts, report.near_misses
    return Found(
        run.until_s,
        tuple(map(_placed_in_program, contact_rows(contacts, None), [c.cause for c in contacts])),
        tuple(map(_placed_in_program, near_rows(near, None), [n.cause for n in near])),
        bool(report.undetermined),
    )


def certified(
    run: Run, since_s: float, near_miss: float | None, until_s: float = math.inf
) -> CollisionReport:
    """Return the certified contacts of a run that end after a time and begin before another [s]."""
    begin_s = _begin(run, since_s)
    segments = [s for s in run.timeline.segments if begin_s < s.end_s and s.start_s < until_s]
    window = _Window(
        _Segments(segments),
        run.motions,
        run.events,
        {name: [p for p in track if p.end_s > begin_s] for name, track in run.placements.items()},
    )
    report = check_collisions(run.scene, window, near_miss=near_miss)
    contacts = [c for c in report.contacts if c.end_s >= since_s]
    near = [n for n in report.near_misses if n.end_s >= since_s]
    return dataclasses.replace(report, contacts=tuple(contacts), near_misses=tuple(near))


def needed_from(growing: GrowingRun, since_s: float) -> float:
    """Return from when on a run has to be known to be checked from a time on [s].

    What was grasped long ago, or left unchecked when the server ended, is in the file.
    """
    tracks = growing.machine.system.hand.placements.values()
    held = [track[-1].start_s for track in tracks if track[-1].lie is Lie.HELD]
    return max(min([since_s, *(start_s - CLOSING for start_s in held)]), 0.0)


def _begin(run: Run, since_s: float) -> float:
    """Return from when on to check, so that no grasp is cut in two."""
    begin_s = since_s
    for closing_s, free_s in reversed(_grasps(run)):
        if free_s > begin_s:
            begin_s = min(begin_s, max(closing_s - BEFORE, 0.0))
    return begin_s


def _grasps(run: Run) -> list[tuple[float, float]]:
    """Return of every grasp when the hand began to close, and when it had left the object."""
    found: list[tuple[float, float]] = []
    closing_s = 0.0
    for event in run.events:
        match event:
            case HandCommanded(time_s=time_s):
                closing_s = time_s
            case Grasped():
                found.append((closing_s, math.inf))
            case Released(time_s=time_s) if found:
                left = (m.end_s for m in run.motions if m.start_s >= time_s)
                found[-1] = (found[-1][0], next(left, math.inf))
            case _:
                pass
    return found


def _placed_in_program(row: Json, cause: Cause | None) -> Json:
    """Return a row with the program and the step that brought it about."""
    if cause is None or cause.program == ALONE:
        return {**row, "program": "", "line": 0}
    return {**row, "program": cause.program, "line": cause.step}


def _anything_moved(growing: GrowingRun, since_s: float) -> bool:
    """Return whether arm, hand or an object moved after a time [s]."""
    system = growing.machine.system
    planner, hand = system.planner, system.hand
    if planner.given.motions and planner.scale.time(planner.given.end_s) > since_s:
        return True
    if hand.strokes and hand.strokes[-1].end_s > since_s:
        return True
    return any(track[-1].start_s > since_s for track in hand.placements.values())


def _news(known: list[Json], found: Iterable[Json]) -> Iterable[Json]:
    """Take rows among those that are known; return those that are new, or say more than before."""
    for row in found:
        same = next((k for k, other in enumerate(known) if _one_event(other, row)), None)
        if same is None:
            known.append(row)
            yield row
            continue
        before = known[same]
        merged = {**_worse(before, row), "start": before["start"]}
        merged["end"] = max(_number(before, "end"), _number(row, "end"))
        if merged != before:
            known[same] = merged
            yield merged


def _one_event(before: Json, row: Json) -> bool:
    pair = (row["first"], row["second"])
    gap = max(
        _number(row, "start") - _number(before, "end"),
        _number(before, "start") - _number(row, "end"),
    )
    return (before["first"], before["second"]) == pair and gap < EVENT_GAP


def _worse(before: Json, row: Json) -> Json:
    if "depthMm" in row:
        return row if _number(row, "depthMm") > _number(before, "depthMm") else before
    return row if _number(row, "distanceMm") < _number(before, "distanceMm") else before


def _number(row: Json, name: str) -> float:
    value = row[name]
    assert isinstance(value, float | int)
    return value
