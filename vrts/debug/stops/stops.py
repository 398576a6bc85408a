"""Every place of a run where the user wishes to stop: the next one, and the last one before."""

from collections.abc import Callable, Mapping, Sequence
from itertools import islice, repeat
from typing import NamedTuple

from vrts.debug.alarms import Alarms
from vrts.debug.breakpoints import Breakpoint, Watch, resolve
from vrts.debug.changes import changes
from vrts.debug.conditions.expression import Expressions
from vrts.debug.conditions.hearing import Hear
from vrts.debug.messages import Message
from vrts.debug.passages import Instant, Passages
from vrts.debug.stops.came import MOST, Came, Chosen, Look, Place, came_to
from vrts.debug.stops.stop import Logged, Stop, Why, Wishes
from vrts.engine.memory.trace import Activation
from vrts.engine.run import Run
from vrts.ir.values import Value
from vrts.lang.dialect import Dialect
from vrts.lang.uncollected import uncollected

MOST_TEXTS = 4  # alarms of one instant that are told


class _Wished(NamedTuple):
    """A place, and the breakpoint or watch that wishes it."""

    place: Place
    point: Breakpoint | Watch

    def stop(self, chosen: Chosen) -> Stop:
        came = self.place.came[chosen.number]
        why = Why.CHANGE if isinstance(self.point, Watch) else Why.BREAKPOINT
        text = chosen.text or came.text
        return Stop(came.instant, why, text, process=came.process, ids=(self.point.id,))


class Stops:
    """The stops of one run; what was worked out is remembered.

    A full pass of the garbage collector over a long run takes longer than anybody may wait to be
    heard, so it is held back meanwhile.
    """

    def __init__(
        self,
        run: Run,
        passages: Mapping[bool, Passages],
        alarms: Alarms,
        dialect: Dialect,
    ) -> None:
        """Take a run; nothing is worked out before it is asked for."""
        self._run, self._alarms = run, alarms
        self._both = tuple(passages.values())
        self._expressions = Expressions(run, dialect)
        self._places: dict[tuple[str, int, str, str], Place] = {}

    @uncollected()
    def following(self, wishes: Wishes, at: Instant, hear: Hear) -> Stop | None:
        """Return the first stop after an instant.

        Raises:
            Interrupted: `hear` has heard somebody.
        """
        look = Look(self._run, hear)
        found = self._found(wishes, lambda place: place.following(at, look), hear)
        found += [stop for stop in self._alarmed(wishes) if stop.instant > at]
        return _joined(found, min(map(_when, found), default=at))

    @uncollected()
    def before(self, wishes: Wishes, at: Instant, hear: Hear) -> Stop | None:
        """Return the last stop before an instant; raises as `following`."""
        look = Look(self._run, hear)
        found = self._found(wishes, lambda place: place.before(at, look), hear)
        found += [stop for stop in self._alarmed(wishes) if stop.instant < at]
        return _joined(found, max(map(_when, found), default=at))

    @uncollected()
    def passing(self, point: Breakpoint, at: Instant, hear: Hear) -> Stop | None:
        """Return the first stop of one line after an instant; raises as `following`."""
        wished = self._of_line(point, hear)
        chosen = None if wished is None else wished.place.following(at, Look(self._run, hear))
        return None if wished is None or chosen is None else wished.stop(chosen)

    @uncollected()
    def logged(
        self, points: Sequence[Breakpoint], begin: Instant, end: Instant, hear: Hear
    ) -> list[Logged]:
        """Return what log points write after an instant, up to another one; raises as above."""
        look = Look(self._run, hear)
        found: list[Logged] = []
        for point in points:
            wished, message = self._of_line(point, hear), Message(point.log, self._expressions)
            if wished is None:
                continue
            passed = wished.place.passed(begin, end, look)
            while part := list(islice(passed, MOST)):
                instants = [came.instant for came in part]
                texts = message.filled_all(
                    instants,
                    [look.activation(came) for came in part],
                    [came.process for came in part],
                    look.heard,
                )
                found += map(Logged, instants, texts, repeat(point.id))
        return sorted(found, key=_when) if len(points) > 1 else found

    def value(
        self, text: str, at: Instant, activation: Activation | None, hear: Hear, *, process: bool
    ) -> Value:
        """Return the value of an expression for a program at an instant; raises as there."""
        return self._expressions.of(text).value(at, activation, hear, process=process)

    def _found(
        self, wishes: Wishes, choose: Callable[[Place], Chosen | None], hear: Hear
    ) -> list[Stop]:
        lines = (self._of_line(point, hear) for point in wishes.lines if not point.log)
        watches = (self._of_watch(watch, hear) for watch in wishes.watches)
        return [
            wished.stop(chosen)
            for wished in (*lines, *watches)
            if wished is not None and (chosen := choose(wished.place)) is not None
        ]

    def _alarmed(self, wishes: Wishes) -> list[Stop]:
        found = self._alarms.of(wishes.filters)
        return [Stop(alarm.instant, Why.ALARM, alarm.text, alarm=alarm) for alarm in found]

    def _of_line(self, point: Breakpoint, hear: Hear) -> _Wished | None:
        resolved = resolve(self._run.history.code, point.source, point.line)
        if resolved is None:
            return None
        key = (point.source, resolved.line, point.condition, point.hits)
        place = self._places.get(key)
        if place is None:
            came = came_to(self._run, self._both, resolved, hear)
            place = self._places[key] = self._place(point, came)
        return _Wished(place, point)

    def _of_watch(self, watch: Watch, hear: Hear) -> _Wished:
        key = (watch.name, 0, watch.condition, watch.hits)
        place = self._places.get(key)
        if place is None:
            found = changes(self._run, watch.name, hear)
            came = [Came(c.instant, c.process, c.text, c.call) for c in found]
            place = self._places[key] = self._place(watch, came)
        return _Wished(place, watch)

    def _place(self, point: Breakpoint | Watch, came: Sequence[Came]) -> Place:
        condition = self._expressions.of(point.condition) if point.condition else None
        return Place(came, condition, point.hits)


def _when(stop: Stop | Logged) -> Instant:
    return stop.instant


def _joined(stops: Sequence[Stop], instant: Instant) -> Stop | None:
    """Return one stop for all that are at an instant."""
    here = [stop for stop in stops if stop.instant == instant]
    if not here:
        return None
    chosen = next((stop for stop in here if stop.alarm is not None), here[0])
    same = [stop for stop in here if stop.why is chosen.why]
    if chosen.alarm is not None:
        texts = list(dict.fromkeys(stop.text for stop in same))
        more = f"; and {len(texts) - MOST_TEXTS} more" if len(texts) > MOST_TEXTS else ""
        chosen = chosen._replace(text="; ".join(texts[:MOST_TEXTS]) + more)
    return chosen._replace(ids=tuple(dict.fromkeys(id_ for stop in same for id_ in stop.ids)))
