"""What a program should never do: instants to stop at, though nothing in the program says so."""

from enum import Enum
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.units import mm
from vrts.check.collision.collision import check_collisions
from vrts.check.verdict import CollisionReport, ContactEvent, NearMiss
from vrts.check.verdicts.limits import JOINT_SPEED, check_limits
from vrts.debug.passages import Instant, at_time
from vrts.engine.hand.told import DROP_HEIGHT
from vrts.engine.memory.events import Cause, Found, Released, Toppled
from vrts.engine.run import Run


class Filter(Enum):
    """A kind of alarm; the value is its name for clients."""

    CONTACT = "contact"
    NEAR_MISS = "near-miss"
    JOINT_LIMIT = "joint-limit"
    SINGULARITY = "singularity"
    SPEED = "speed"
    ERROR = "run-time-error"
    DROPPED = "dropped"


LABELS = {
    Filter.CONTACT: "Contact",
    Filter.NEAR_MISS: "Near miss",
    Filter.JOINT_LIMIT: "Joint limit",
    Filter.SINGULARITY: "Singularity",
    Filter.SPEED: "Joint speed",
    Filter.ERROR: "Run-time error",
    Filter.DROPPED: "Object dropped",
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

    def __init__(self, run: Run, near_miss_m: float | None) -> None:
        """Take a run, and how near a near miss is [m]; None: as the check assumes."""
        self.run = run
        self._near_miss_m = near_miss_m
        self._report: CollisionReport | None = None
        self._known: dict[Filter, list[Alarm]] | None = None

    @property
    def report(self) -> CollisionReport:
        """The certified collisions of the run."""
        if self._report is None:
            self._report = check_collisions(self.run.scene, self.run, near_miss=self._near_miss_m)
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
        return sorted(found, key=lambda alarm: alarm.instant)

    def _collisions(self, filters: frozenset[Filter]) -> list[Alarm]:
        found: list[Alarm] = []
        if Filter.CONTACT in filters:
            found += [self._alarm(Filter.CONTACT, event) for event in self.report.contacts]
        if Filter.NEAR_MISS in filters:
            found += [self._alarm(Filter.NEAR_MISS, event) for event in self.report.near_misses]
        return found

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
                case Found(diagnostic=diagnostic):
                    kind = _BY_CODE.get(diagnostic.rule.code)
                    if kind is None and diagnostic.is_error:
                        kind = Filter.ERROR
                    if kind is not None:
                        alarm = Alarm(instant, kind, diagnostic.headline, diagnostic)
                        known.setdefault(kind, []).append(alarm)
                case Released(body=body, height_m=height) if height > DROP_HEIGHT:
                    text = f"{body} is let go and falls {mm(height):.0f} mm"
                    known.setdefault(Filter.DROPPED, []).append(
                        Alarm(instant, Filter.DROPPED, text)
                    )
                case Toppled(body=body, support=support):
                    text = f"{body} cannot stand on {support}" if support else f"{body} has fallen"
                    known.setdefault(Filter.DROPPED, []).append(
                        Alarm(instant, Filter.DROPPED, text)
                    )
                case _:
                    pass
        for diagnostic in check_limits(self.run).findings:
            kind = _BY_CODE.get(diagnostic.rule.code)
            if kind is not None and diagnostic.moment is not None:
                instant = at_time(self.run, diagnostic.moment.time_s)
                alarm = Alarm(instant, kind, diagnostic.headline, diagnostic)
                known.setdefault(kind, []).append(alarm)
        return known
