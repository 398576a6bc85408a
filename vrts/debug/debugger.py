"""A run, a place in it, and ways to go from there: forward, backward, or into another future.

Everything is looked up in the run, which is executed to its end before anybody looks: going back
is asking for an earlier instant. Only a change (a value, another next step, a command) makes a new
run, from the instant of the change on.
"""

from collections.abc import Generator, Sequence
from contextlib import contextmanager

import numpy as np

from vrts.base.remembered import Memory
from vrts.check.task.task import Task
from vrts.debug.alarms import Alarms
from vrts.debug.branches.by_what import by_what
from vrts.debug.branches.tree import Branch, By, Tree, first_branch
from vrts.debug.breakpoints import Breakpoint
from vrts.debug.conditions.hearing import Hear, nobody
from vrts.debug.evaluating import commands_at
from vrts.debug.events.asking import Tables
from vrts.debug.passages import (
    Instant,
    Passages,
    at_time,
    first_instant,
    last_instant,
)
from vrts.debug.stops.stop import Logged, Stop, Way, Why, Wishes
from vrts.debug.stops.stops import Stops
from vrts.engine.controller import AFTERWARDS, forked
from vrts.engine.faults import NO_ANSWER
from vrts.engine.memory.events import Cause, CommandRefused
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run, State
from vrts.ir.commands import Command
from vrts.lang.dialect import Dialect

__all__ = ["Debugger", "Logged", "Stop", "Way", "Why", "Wishes"]


class Debugger:
    """One debugging session."""

    def __init__(
        self,
        run: Run,
        dialect: Dialect,
        near_miss_m: float | None = None,
        task: Task | None = None,
        memory: Memory | None = None,
    ) -> None:
        """Begin before the first step of a run that was executed to its end.

        Args:
            run: The run.
            dialect: Of its program.
            near_miss_m: How near a near miss is [m]; None: as the check assumes.
            task: What is asked for, if goals that are not reached are to be told.
            memory: What was worked out for the run: its other futures need not do it again.
        """
        self.memory = memory or Memory()
        self.wishes = Wishes()
        self.dialect = dialect
        self.log: list[Logged] = []  # written since somebody last took it
        self.hear: Hear = nobody  # called now and then while stops are looked for
        self._near_miss_m, self._task = near_miss_m, task
        self._gone: Branch | None = None  # given up for want of room
        self._tree = first_branch(run, dialect)
        self._take(run)
        self.stop = Stop(self._entry(), Why.ENTRY)
        self._trail: list[Stop] = []  # where forward steps came from

    # --- where it is --------------------------------------------------------------------------

    @property
    def run(self) -> Run:
        """The run as it goes with all changes so far."""
        return self._run

    @property
    def tree(self) -> Tree:
        """All futures, and which one it is on."""
        return self._tree

    @property
    def task(self) -> Task | None:
        """What is asked for, if it may be told whether it is reached."""
        return self._task

    @property
    def first(self) -> Run:
        """The run as it was opened, without any change."""
        return self._tree.branches[0].run

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
    def tables(self) -> Tables:
        """All events and calls of the run as it goes."""
        return self._tables

    @property
    def stops(self) -> Stops:
        """All places to stop at, and all expressions, of the run as it goes."""
        return self._stops

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

    def current(self, *, process: bool) -> Cause | None:
        """Return the step that a program executes next, or executed last."""
        state = self.state
        stack = state.process_stack if process else state.call_stack
        if stack:
            return stack[-1]
        passages = self._passages[process]
        return passages.cause(passages.count - 1) if passages.count else None

    # --- steps --------------------------------------------------------------------------------

    def step(self, way: Way, *, process: bool = False) -> Stop:
        """Go forward to another step of a program."""
        if self.at_end:
            return self._stand(self.stop._replace(why=Why.END))
        passages = self._passages[process]
        here = passages.following(self.at)
        self._trail.append(self.stop)
        first = here + (here < passages.count and passages.instant(here) <= self.at)
        begun = passages.begun
        later = begun[np.searchsorted(begun, first) :]
        next_: int | None = int(later[0]) if len(later) else None
        if way is not Way.INTO and here < passages.count:
            next_ = passages.no_deeper(later, int(passages.depths[here]) - (way is Way.OUT))
        if next_ is None:
            return self._stand(Stop(last_instant(self._run), Why.END, process=process))
        return self._stand(Stop(passages.instant(next_), Why.STEP, process=process))

    def step_back(self, *, process: bool = False) -> Stop:
        """Go back: to where the last step came from, else to the step before in this program.

        From an alarm it leads to the step that caused it.
        """
        if self._trail and self._trail[-1].instant < self.at:
            return self._stand(self._trail.pop())
        caused = self._caused()
        if caused is not None:
            return self._stand(Stop(caused, Why.STEP))
        passages = self._passages[process]
        here = passages.following(self.at)
        begun = passages.begun[: np.searchsorted(passages.begun, here + 1)]
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

    def go(self, instant: Instant) -> Stop:
        """Go to an instant as `jump` does to a time: before or after a statement of its tick."""
        return self.go_to(Stop(instant, Why.STEP))

    def go_to(self, stop: Stop) -> Stop:
        """Go to a place and stand there for the reason it gives."""
        self._trail.clear()
        return self._stand(stop)

    # --- going on -----------------------------------------------------------------------------

    def go_on(self) -> Stop:
        """Go forward to the next place where the user wishes to stop, or to the end.

        Raises:
            Interrupted: `hear` has heard somebody; it stands where it stood.
        """
        begin, end = self.at, last_instant(self._run)
        stop = self._stops.following(self.wishes, begin, self.hear)
        found = stop or Stop(end, Why.END, self._ending())
        points = [point for point in self.wishes.lines if point.log]
        self.log += self._stops.logged(points, begin, found.instant, self.hear)
        self._trail.clear()
        return self._stand(found)

    def reverse(self) -> Stop:
        """Go backward to the last place before where the user wishes to stop, or to the begin.

        Raises:
            Interrupted: As `go_on`.
        """
        found = self._stops.before(self.wishes, self.at, self.hear)
        self._trail.clear()
        return self._stand(found or Stop(self._entry(), Why.BEGIN))

    def run_to(self, source: str, line: int) -> Stop:
        """Go forward to a line, once; to the end if it is not passed."""
        found = self._stops.passing(Breakpoint(0, source, line), self.at, self.hear)
        return self._stand(found or Stop(last_instant(self._run), Why.END))

    def restart(self) -> Stop:
        """Go back to the beginning, as if nothing had been changed; what was is a branch."""
        self._trail.clear()
        self._tree = self._tree.at(self._tree.branches[0])
        self.dialect = self._tree.current.dialect
        self._take(self._tree.current.run)
        return self._stand(Stop(self._entry(), Why.ENTRY))

    def take_over(self, other: "Debugger") -> Stop:
        """Begin with what another debugger has opened; the wishes stay."""
        self.dialect = other.dialect
        self._near_miss_m, self._task = other._near_miss_m, other._task
        self._tree = other._tree
        return self.restart()

    # --- changes ------------------------------------------------------------------------------

    def change(self, commands: Sequence[Command]) -> list[str]:
        """Let the controller be told something here; return its words where it refuses.

        What comes later is another future from now on.
        """
        timed = commands_at(self._run, self.at, commands)
        limit = self._run.scenario.limits.time_s + AFTERWARDS
        with self.memory.in_use():
            other = forked(self._run, timed, max(limit, self.at.time_s + AFTERWARDS))
        refused = [
            event.words
            for event, number in zip(other.events, other.event_numbers, strict=True)
            if isinstance(event, CommandRefused)
            and self.at.finished < number <= self.at.finished + len(timed)
        ]
        self._trail.clear()
        self._grow(other, *by_what(commands), self.at)
        after = self.at.finished + len(timed)
        time_s = self.at.time_s if timed[0].after is not None else other.history.time_of(after)
        self.stop = self.stop._replace(instant=Instant(time_s, after))
        return refused

    def rewrite(self, run: Run, dialect: Dialect, words: str, differs: Instant | None) -> Stop:
        """Go on with a run of another text, from where it stands if both are alike up to there.

        Else it stands at the same time of the other run.

        Args:
            run: As the other text makes it.
            dialect: Of the other text.
            words: What was changed.
            differs: Where the present run comes to what differs; None: nowhere.
        """
        before = self._run
        forked = last_instant(before) if differs is None else differs
        self._trail.clear()
        self._grow(run, By.TEXT, words, forked, dialect)
        return self._stand_again(forked.finished if differs is not None else run.statements)

    def to_branch(self, tree: Tree) -> Stop:
        """Go to another branch: to the same instant if both share it, else to the same time."""
        old, new = self._tree.current, tree.current
        shared = tree.shared(old, new)
        self._trail.clear()
        self._tree, self.dialect = tree, new.dialect
        self._take(new.run)
        return self._stand_again(shared)

    def name_branch(self, name: str) -> None:
        """Give the present branch a name that no other has."""
        self._tree = self._tree.named(name)

    def take_gone(self) -> Branch | None:
        """Return the branch that was given up last, once."""
        gone, self._gone = self._gone, None
        return gone

    @contextmanager
    def whole(self) -> Generator[None]:
        """Let what is done inside be done as a whole: where it fails, all is as it was before."""
        run, alarms, passages, stops = self._run, self._alarms, self._passages, self._stops
        tables, stop, trail = self._tables, self.stop, list(self._trail)
        tree, dialect = self._tree, self.dialect
        try:
            yield
        except BaseException:
            self._run, self._alarms, self._passages, self._stops = run, alarms, passages, stops
            self._tables, self.stop, self._trail = tables, stop, trail
            self._tree, self.dialect = tree, dialect
            raise

    # --- parts --------------------------------------------------------------------------------

    def _grow(
        self, run: Run, by: By, words: str, forked: Instant, dialect: Dialect | None = None
    ) -> None:
        """Go on with another run, as a branch of the present one."""
        self.dialect = dialect or self.dialect
        self._tree, gone = self._tree.grown(run, by, words, forked, self.dialect)
        self._gone = gone or self._gone
        self._take(run)

    def _stand_again(self, shared: int) -> Stop:
        """Stand where it stood if so many statements are the same, else at the same time."""
        if self.at.finished <= shared and self.at.time_s <= self._run.horizon_s:
            return self._stand(Stop(self.at, Why.STEP))
        return self._stand(Stop(at_time(self._run, self.at.time_s), Why.STEP))

    def _take(self, run: Run) -> None:
        if run is getattr(self, "_run", None):
            return  # what was worked out of it still holds
        self._run = run
        hear = lambda: self.hear()  # noqa: E731 -- whoever it is then
        self._alarms = Alarms(run, self._near_miss_m, self._task, self.memory, hear)
        self._passages = {of: Passages(run, process=of) for of in (False, True)}
        self._stops = Stops(run, self._passages, self._alarms, self.dialect)
        self._tables = Tables(run, self._alarms)

    def _caused(self) -> Instant | None:
        """Return when the step that caused the alarm came next, where it stands at one."""
        cause = self.stop.cause
        if cause is None:
            return None
        causes = self._run.history.code.causes
        which = [k for k, known in enumerate(causes) if known[:2] == cause[:2]]
        found: list[Instant] = []
        for passages in self._passages.values():
            begun = passages.begun[np.isin(passages.instructions[passages.begun], which)]
            before = begun[passages.reached[begun] < self.at.finished]
            found += [passages.instant(int(k)) for k in before[-1:]]
        return max(found, default=None)

    def _entry(self) -> Instant:
        robot = self._passages[False]
        return robot.instant(0) if robot.count else first_instant(self._run)

    def _ending(self) -> str:
        ending = self._run.ending
        return "" if ending is Ending.COMPLETED else ending.value

    def _stand(self, stop: Stop) -> Stop:
        self.stop = stop
        return stop
