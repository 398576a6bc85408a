"""What a program should never do: instants to stop at, though nothing in the program says so."""

from collections.abc import Iterator, Sequence
from enum import Enum
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.remembered import Memory
from vrts.base.units import mm
from vrts.check.collision.collision import check_collisions
from vrts.check.goals.reached import judged_at, reached
from vrts.check.task.task import Task
from vrts.check.verdict import CollisionReport, ContactEvent, NearMiss
from vrts.check.verdicts.limits import JOINT_SPEED, check_limits
from vrts.check.verdicts.targets import describe
from vrts.debug.conditions.heard_proposer import HeardProposer
from vrts.debug.conditions.hearing import Hear, nobody
from vrts.debug.passages import Instant, at_time
from vrts.engine.hand.told import CLOSED_ON_NOTHING, DROP_HEIGHT, OFF_CENTRE
from vrts.engine.memory.events import Cause, Found, Released, Toppled
from vrts.engine.memory.records import Lie, Placement
from vrts.engine.run import Run
from vrts.why.hands import Closing, nearest_closing
from vrts.why.slicing.executed import Steps


class Filter(Enum):
    """A kind of alarm; the value is its name for clients."""

    CONTACT = "contact"
    NEAR_MISS = "near-miss"
    JOINT_LIMIT = "joint-limit"
    SINGULARITY = "singularity"
    SPEED = "speed"
    ERROR = "run-time-error"
    DROPPED = "dropped"
    MISSED = "not-picked-up"
    GOAL = "goal-not-reached"


DEFAULT = frozenset({Filter.CONTACT, Filter.ERROR, Filter.DROPPED, Filter.MISSED, Filter.GOAL})
"""Alarms that are on unless somebody says so."""

LABELS = {
    Filter.CONTACT: "Contact",
    Filter.NEAR_MISS: "Near miss",
    Filter.JOINT_LIMIT: "Joint limit",
    Filter.SINGULARITY: "Singularity",
    Filter.SPEED: "Joint speed",
    Filter.ERROR: "Run-time error",
    Filter.DROPPED: "Object dropped or toppled",
    Filter.MISSED: "Object not picked up",
    Filter.GOAL: "Goal not reached",
}
_BY_CODE = {
    "V302": Filter.SPEED,
    "V303": Filter.JOINT_LIMIT,
    "V430": Filter.JOINT_LIMIT,
    "V305": Filter.SINGULARITY,
    "V306": Filter.SINGULARITY,
    "V331": Filter.SINGULARITY,
    "V332": Filter.SINGULARITY,
}
_MISSES = (CLOSED_ON_NOTHING, OFF_CENTRE)
_CHECKED = frozenset({Filter.CONTACT, Filter.NEAR_MISS})


class Alarm(NamedTuple):
    """Something that happened, at the instant at which it began."""

    instant: Instant
    filter: Filter
    text: str
    diagnostic: Diagnostic | None = None
    cause: Cause | None = None  # the step to blame: it may be an earlier one than the present


class Alarms:
    """The alarms of one run; each kind is looked for when it is first asked for."""

    def __init__(
        self,
        run: Run,
        near_miss_m: float | None,
        task: Task | None = None,
        memory: Memory | None = None,
        hear: Hear = nobody,
    ) -> None:
        """Take a run, how near a near miss is, its task, and who is heard while it is checked.

        Args:
            run: The run.
            near_miss_m: How near a near miss is [m]; None: as the check assumes.
            task: What is asked for, if goals that are not reached are alarms.
            memory: Holds what was found out of other futures of the run.
            hear: May end what takes long; then nothing is known yet.
        """
        self.run = run
        self._memory = memory or Memory()
        self._hear = hear
        self._task = task
        self._near_miss_m = near_miss_m
        self._report: CollisionReport | None = None
        self._known: dict[Filter, list[Alarm]] | None = None

    @property
    def report(self) -> CollisionReport:
        """The certified collisions of the run."""
        if self._report is None:
            with self._memory.in_use():
                self._report = check_collisions(
                    *(self.run.scene, self.run),
                    near_miss=self._near_miss_m,
                    proposer=HeardProposer(self._hear),
                )
        return self._report

    def of(self, filters: frozenset[Filter]) -> list[Alarm]:
        """Return the alarms of some kinds, in time order."""
        found: list[Alarm] = []
        if filters & _CHECKED:
            found += self._collisions(filters)
        if filters - _CHECKED:
            if self._known is None:
                self._known = self._found()
            found += [alarm for kind in filters for alarm in self._known.get(kind, ())]
        order = {kind: place for place, kind in enumerate(Filter)}
        return sorted(found, key=lambda alarm: (alarm.instant, order[alarm.filter], alarm.text))

    def met(self) -> list[tuple[Alarm, ContactEvent | NearMiss]]:
        """Return the contacts and the near misses, each with its alarm."""
        contacts = [(self._alarm(Filter.CONTACT, e), e) for e in self.report.contacts]
        return [
            *contacts,
            *((self._alarm(Filter.NEAR_MISS, e), e) for e in self.report.near_misses),
        ]

    def _collisions(self, filters: frozenset[Filter]) -> list[Alarm]:
        return [alarm for alarm, _ in self.met() if alarm.filter in filters]

    def _alarm(self, kind: Filter, event: ContactEvent | NearMiss) -> Alarm:
        first, second = event.parts
        holding = f", holding {event.held}" if event.held else ""
        if isinstance(event, ContactEvent):
            text = f"{first} touches {second}{holding}; {mm(event.depth_m):.1f} mm deep at most"
        else:
            near = mm(event.distance_m)
            text = f"{first} comes near {second}{holding}: {near:.1f} mm at {event.nearest_s:.3f} s"
        return Alarm(at_time(self.run, event.start_s), kind, text, cause=event.cause)

    def _found(self) -> dict[Filter, list[Alarm]]:
        known: dict[Filter, list[Alarm]] = {}
        for event, number in zip(self.run.events, self.run.event_numbers, strict=True):
            instant = Instant(event.time_s, number)
            match event:
                case Found(diagnostic=diagnostic) if diagnostic.rule == JOINT_SPEED:
                    pass  # foretold; what came of it is found below
                case Found(diagnostic=diagnostic) if diagnostic.rule in _MISSES:
                    alarm = Alarm(
                        instant, Filter.MISSED, diagnostic.headline, diagnostic, event.cause
                    )
                    known.setdefault(Filter.MISSED, []).append(alarm)
                case Found(diagnostic=diagnostic):
                    kind = _BY_CODE.get(diagnostic.rule.code)
                    if kind is None and diagnostic.is_error:
                        kind = Filter.ERROR
                    if kind is not None:
                        alarm = Alarm(instant, kind, diagnostic.headline, diagnostic, event.cause)
                        known.setdefault(kind, []).append(alarm)
                case Released(body=body, height_m=height) if height > DROP_HEIGHT:
                    text = f"{body} is let go and falls {mm(height):.0f} mm"
                    known.setdefault(Filter.DROPPED, []).append(
                        Alarm(instant, Filter.DROPPED, text, cause=event.cause)
                    )
                case Toppled(body=body, support=support, also=also):
                    on = " and ".join((support, *also))
                    text = f"{body} cannot stand on {on}" if support else f"{body} has fallen"
                    known.setdefault(Filter.DROPPED, []).append(
                        Alarm(instant, Filter.DROPPED, text, cause=event.cause)
                    )
                case _:
                    pass
        for diagnostic in check_limits(self.run).findings:
            kind = _BY_CODE.get(diagnostic.rule.code)
            if kind is not None and diagnostic.moment is not None:
                instant = at_time(self.run, diagnostic.moment.time_s)
                cause = _cause_of(self.run, diagnostic)
                alarm = Alarm(instant, kind, diagnostic.headline, diagnostic, cause)
                known.setdefault(kind, []).append(alarm)
        if self._task is not None:
            misses = known.setdefault(Filter.MISSED, [])
            for alarm in goal_alarms(self.run, self._task, tuple(misses)):
                known.setdefault(alarm.filter, []).append(alarm)
            told = {alarm.instant for alarm in misses if alarm.diagnostic is None}
            misses[:] = [a for a in misses if a.diagnostic is None or a.instant not in told]
        return known


def goal_alarms(run: Run, task: Task, misses: Sequence[Alarm] = ()) -> Iterator[Alarm]:
    """Yield what a task asks for and a run does not do, at the moment that decides it.

    A thing that lies at a wrong place is told when it came to rest there, one that was never
    picked up at the nearest try, all else when the task judges. `misses` are the times at which
    the hand closed on nothing.
    """
    judged = judged_at(run, task)
    steps = Steps(run)
    for result in reached(run, task):
        if result.share >= 1:
            continue
        body, text = result.body, f"{result.body} {describe(result)}"
        track = [p for p in run.placements.get(body, ()) if p.start_s <= judged]
        moved = len(track) > 1
        yield _goal_missed(run, body, text, track[-1] if moved else None, judged)
        if not moved and body in run.placements:
            yield _never_picked_up(run, body, nearest_closing(steps, body), judged, misses)


def _never_picked_up(
    run: Run, body: str, nearest: Closing | None, judged: float, misses: Sequence[Alarm]
) -> Alarm:
    """Return the alarm of a thing that was never gripped, at the nearest try."""
    text = f"{body} is never picked up"
    if nearest is None:
        return Alarm(at_time(run, judged), Filter.MISSED, text)
    cause, begun = nearest.event.cause, nearest.event.time_s
    miss = next((a for a in misses if a.cause == cause and a.instant.time_s >= begun - 1e-9), None)
    if miss is None:
        return Alarm(at_time(run, begun), Filter.MISSED, text, cause=cause)
    return Alarm(miss.instant, Filter.MISSED, f"{text}: {miss.text}", cause=cause)


def _goal_missed(run: Run, body: str, text: str, last: Placement | None, judged: float) -> Alarm:
    """Return the alarm of a goal, at the moment at which its object was left."""
    if last is None or last.lie in (Lie.HELD, Lie.FALLING):
        return Alarm(at_time(run, judged), Filter.GOAL, text)
    releases = [e for e in run.events if isinstance(e, Released) and e.body == body]
    cause = next((e.cause for e in reversed(releases) if e.time_s <= last.start_s + 1e-9), None)
    return Alarm(at_time(run, last.start_s), Filter.GOAL, text, cause=cause)


def _cause_of(run: Run, diagnostic: Diagnostic) -> Cause | None:
    """Return the step that a finding points at."""
    if diagnostic.primary is None:
        return None
    span = diagnostic.primary.span
    return next((c for c in run.history.code.causes if c.span == span), None)
