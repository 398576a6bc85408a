"""A run, a place in it, and ways to go from there: forward, backward, or into another future.

Everything is looked up in the run, which is executed to its end before anybody looks: going back
is asking for an earlier instant. Only a change (a value, another next step, a command) makes a new
run, from the instant of the change on.
"""

from collections.abc import Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from enum import Enum
from heapq import merge
from typing import NamedTuple

import numpy as np

from vrts.debug.alarms import Alarm, Alarms, Filter
from vrts.debug.breakpoints import Breakpoint, Watch, counts, passes, resolve
from vrts.debug.changes import changes
from vrts.debug.evaluating import CannotTell, commands_at, evaluate
from vrts.debug.frames import frames
from vrts.debug.messages import filled
from vrts.debug.passages import (
    Instant,
    Passages,
    at_time,
    first_instant,
    last_instant,
)
from vrts.engine.controller import AFTERWARDS, forked
from vrts.engine.faults import NO_ANSWER
from vrts.engine.memory.events import CommandRefused
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run, State
from vrts.ir.commands import Command
from vrts.ir.values import Value
from vrts.lang.dialect import Dialect

MOST_LOOKS = 5_000  # passes of one breakpoint whose condition is worked out in one go


class Why(Enum):
    """Why it stands where it stands; the values are words of the debug adapter protocol."""

    ENTRY = "entry"
    STEP = "step"
    BREAKPOINT = "breakpoint"
    CHANGE = "data breakpoint"
    ALARM = "exception"
    GOTO = "goto"
    BEGIN = "begin"
    END = "end"


class Way(Enum):
    """How far a step goes."""

    INTO = "into"  # to the next step of any program
    OVER = "over"  # ... of this program, or of what called it
    OUT = "out"  # ... of what called it


class Stop(NamedTuple):
    """Where it has come to stand, and why."""

    instant: Instant
    why: Why
    text: str = ""
    process: bool = False  # the process control program came there
    ids: tuple[int, ...] = ()  # of breakpoints
    alarm: Alarm | None = None


class Logged(NamedTuple):
    """What a log point wrote on the way."""

    instant: Instant
    text: str
    breakpoint: int


@dataclass(slots=True)
class Wishes:
    """Where the user wishes to stop."""

    lines: list[Breakpoint] = field(default_factory=list[Breakpoint])
    watches: list[Watch] = field(default_factory=list[Watch])
    filters: frozenset[Filter] = frozenset()


class Debugger:
    """One debugging session."""

    def __init__(self, run: Run, dialect: Dialect, near_miss_m: float | None = None) -> None:
        """Begin before the first step of a run that was executed to its end."""
        self.wishes = Wishes()
        self.dialect = dialect
        self.log: list[Logged] = []  # written since somebody last took it
        self._near_miss_m = near_miss_m
        self._first = run
        self._take(run)
        self.stop = Stop(self._entry(), Why.ENTRY)
        self._trail: list[Stop] = []  # where forward steps came from

    # --- where it is --------------------------------------------------------------------------

    @property
    def run(self) -> Run:
        """The run as it goes with all changes so far."""
        return self._run

    @property
    def at(self) -> Instant:
        """The instant at which it stands."""
        return self.stop.instant

    @property
    def state(self) -> State:
        """The run there."""
        return self._run.at_moment(self.at.time_s, self.at.finished)

    @property
    def alarms(self) -> Alarms:
        """What should never happen, of the run as it goes."""
        return self._alarms

    @property
    def at_end(self) -> bool:
        """Whether nothing happens after this instant."""
        return self.at >= last_instant(self._run)

    @property
    def asks(self) -> bool:
        """Whether the program waits for a line of the terminal that nobody has typed yet."""
        findings = self._run.findings
        unanswered = bool(findings) and findings[-1].rule == NO_ANSWER
        return self.state.awaits_answer or (self.at_end and unanswered)

    def passages(self, *, process: bool) -> Passages:
        """Return what the robot program or the process control program executes."""
        return self._passages[process]

    def seen(self, at: Instant, *, process: bool) -> Mapping[str, Value]:
        """Return arguments and automatic variables of the innermost program at an instant."""
        inside = frames(self._run, at, process=process)
        return inside[0].locals(self._run, at) if inside else {}

    # --- steps --------------------------------------------------------------------------------

    def step(self, way: Way, *, process: bool = False) -> Stop:
        """Go forward to another step of a program."""
        if self.at_end:
            return self._stand(self.stop._replace(why=Why.END))
        passages = self._passages[process]
        here = passages.following(self.at)
        self._trail.append(self.stop)
        first = here + (here < passages.count and passages.instant(here) <= self.at)
        later = np.flatnonzero(passages.begins[first:]) + first
        if way is not Way.INTO and here < passages.count:
            depth = passages.depths[here] - (way is Way.OUT)
            later = later[passages.depths[later] <= depth]
        if not len(later):
            return self._stand(Stop(last_instant(self._run), Why.END, process=process))
        return self._stand(Stop(passages.instant(int(later[0])), Why.STEP, process=process))

    def step_back(self, *, process: bool = False) -> Stop:
        """Go back: to where the last step came from, else to the step before in this program."""
        if self._trail and self._trail[-1].instant < self.at:
            return self._stand(self._trail.pop())
        passages = self._passages[process]
        here = passages.following(self.at)
        begun = np.flatnonzero(passages.begins[: here + 1])
        earlier = [k for k in begun[-2:].tolist() if passages.instant(k) < self.at]
        if (
            here < passages.count
            and earlier
            and passages.depths[earlier[-1]] > passages.depths[here]
        ):
            fit = begun[passages.depths[begun] <= passages.depths[here]]
            earlier = [k for k in fit[-2:].tolist() if passages.instant(k) < self.at]
        if not earlier:
            return self._stand(Stop(first_instant(self._run), Why.BEGIN, process=process))
        return self._stand(Stop(passages.instant(earlier[-1]), Why.STEP, process=process))

    def tick(self, count: int) -> Stop:
        """Go some set points of the arm forward, or backward."""
        tick = self._run.history.tick_s
        number = self.at.time_s / tick
        whole = round(number) if abs(number - round(number)) < 1e-6 else None
        if whole is None:
            whole = int(number) + (count < 0)
        if count > 0:
            self._trail.append(self.stop)
        return self.seek((whole + count) * tick)

    def seek(self, time_s: float) -> Stop:
        """Go to a time [s], as near to it as the run reaches."""
        return self._stand(Stop(at_time(self._run, time_s), Why.STEP))

    def jump(self, time_s: float) -> Stop:
        """Go to a time [s] as `seek` does; a step back leads to the step before, and not here."""
        self._trail.clear()
        return self.seek(time_s)

    # --- going on -----------------------------------------------------------------------------

    def go_on(self) -> Stop:
        """Go forward to the next place where the user wishes to stop, or to the end."""
        self._trail.clear()
        begin, end = self.at, last_instant(self._run)
        stops = [s for s in self._stops() if s.instant > begin]
        found = self._joined(stops) or Stop(end, Why.END, self._ending())
        self._write_log(begin, found.instant)
        return self._stand(found)

    def reverse(self) -> Stop:
        """Go backward to the last place before where the user wishes to stop, or to the begin."""
        self._trail.clear()
        stops = [s for s in self._stops() if s.instant < self.at]
        found = self._joined(list(reversed(stops)))
        return self._stand(found or Stop(self._entry(), Why.BEGIN))

    def run_to(self, source: str, line: int) -> Stop:
        """Go forward to a line, once; to the end if it is not passed."""
        for_once = Breakpoint(0, source, line)
        found = [s for s in self._of_lines([for_once]) if s.instant > self.at]
        return self._stand(min(found, default=Stop(last_instant(self._run), Why.END)))

    def restart(self) -> Stop:
        """Go back to the beginning, with all changes forgotten."""
        self._trail.clear()
        self._take(self._first)
        return self._stand(Stop(self._entry(), Why.ENTRY))

    def take_over(self, other: "Debugger") -> Stop:
        """Begin with what another debugger has opened; the wishes stay."""
        self.dialect = other.dialect
        self._near_miss_m = other._near_miss_m
        self._first = other._first
        return self.restart()

    # --- changes ------------------------------------------------------------------------------

    def change(self, commands: Sequence[Command]) -> list[str]:
        """Let the controller be told something here; return its words where it refuses.

        What comes later is another future from now on.
        """
        timed = commands_at(self._run, self.at, commands)
        limit = self._run.scenario.limits.time_s + AFTERWARDS
        other = forked(self._run, timed, max(limit, self.at.time_s + AFTERWARDS))
        refused = [
            event.words
            for event, number in zip(other.events, other.event_numbers, strict=True)
            if isinstance(event, CommandRefused)
            and self.at.finished < number <= self.at.finished + len(timed)
        ]
        self._trail.clear()
        self._take(other)
        after = self.at.finished + len(timed)
        time_s = self.at.time_s if timed[0].after is not None else other.history.time_of(after)
        self.stop = self.stop._replace(instant=Instant(time_s, after))
        return refused

    @contextmanager
    def whole(self) -> Generator[None]:
        """Let what is done inside be done as a whole: interrupted, all is as it was before."""
        run, alarms, passages = self._run, self._alarms, self._passages
        stop, trail = self.stop, list(self._trail)
        try:
            yield
        except KeyboardInterrupt:
            self._run, self._alarms, self._passages = run, alarms, passages
            self.stop, self._trail = stop, trail
            raise

    # --- parts --------------------------------------------------------------------------------

    def _take(self, run: Run) -> None:
        self._run = run
        self._alarms = Alarms(run, self._near_miss_m)
        self._passages = {of: Passages(run, process=of) for of in (False, True)}

    def _entry(self) -> Instant:
        robot = self._passages[False]
        return robot.instant(0) if robot.count else first_instant(self._run)

    def _ending(self) -> str:
        ending = self._run.ending
        return "" if ending is Ending.COMPLETED else ending.value

    def _stand(self, stop: Stop) -> Stop:
        self.stop = stop
        return stop

    def _stops(self) -> list[Stop]:
        """Return every place where the user wishes to stop, in order."""
        wishes = self.wishes
        lines = self._of_lines([b for b in wishes.lines if not b.log])
        watched = [
            stop
            for watch in wishes.watches
            for stop in self._wanted(
                watch,
                [
                    Stop(change.instant, Why.CHANGE, change.text, ids=(watch.id,))
                    for change in changes(self._run, watch.name)
                ],
            )
        ]
        alarms = [
            Stop(alarm.instant, Why.ALARM, alarm.text, alarm=alarm)
            for alarm in self._alarms.of(wishes.filters)
        ]
        return list(merge(sorted(lines, key=_when), sorted(watched, key=_when), alarms, key=_when))

    def _of_lines(self, breakpoints: Sequence[Breakpoint]) -> list[Stop]:
        return [stop for point in breakpoints for stop in self._of_line(point)]

    def _of_line(self, point: Breakpoint) -> Iterator[Stop]:
        resolved = resolve(self._run.history.code, point.source, point.line)
        if resolved is None:
            return
        came = sorted(
            (passages.instant(k), of)
            for of, passages in self._passages.items()
            for k in passes(passages, resolved)
        )
        yield from self._wanted(
            point,
            [Stop(at, Why.BREAKPOINT, process=process, ids=(point.id,)) for at, process in came],
        )

    def _wanted(self, point: Breakpoint | Watch, came: Sequence[Stop]) -> Iterator[Stop]:
        """Choose those stops, of all in order, that fit the condition and the hits of a point."""
        hit = 0
        for looked, stop in enumerate(came):
            if point.condition:
                if looked >= MOST_LOOKS:
                    yield stop._replace(text=f"passed {MOST_LOOKS:,} times: not looked at further")
                    return
                seen = self.seen(stop.instant, process=stop.process)
                try:
                    value = evaluate(self._run, stop.instant, point.condition, self.dialect, seen)
                except CannotTell as problem:
                    yield stop._replace(text=f"the condition cannot be worked out: {problem}")
                    continue
                if value == 0.0:
                    continue
            hit += 1
            if counts(point.hits, hit):
                yield stop

    def _joined(self, stops: Sequence[Stop]) -> Stop | None:
        """Return the first of some stops, with what else is there."""
        if not stops:
            return None
        here = [stop for stop in stops if stop.instant == stops[0].instant]
        alarm = next((stop for stop in here if stop.alarm is not None), here[0])
        ids = tuple(
            dict.fromkeys(id_ for stop in here if stop.why is alarm.why for id_ in stop.ids)
        )
        return alarm._replace(ids=ids)

    def _write_log(self, begin: Instant, end: Instant) -> None:
        points = {point.id: point for point in self.wishes.lines if point.log}
        for stop in sorted(self._of_lines(list(points.values())), key=_when):
            if begin < stop.instant <= end:
                seen = self.seen(stop.instant, process=stop.process)
                point = points[stop.ids[0]]
                text = filled(point.log, self._run, stop.instant, self.dialect, seen)
                self.log.append(Logged(stop.instant, text, stop.ids[0]))


def _when(stop: Stop) -> Instant:
    return stop.instant
