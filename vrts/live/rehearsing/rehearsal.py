"""A run of a text, a place in it, and ways to go from there: what the process of a rehearsal holds.

Everything is looked up in the run (`debug.debugger`): going back costs what going forward costs.
"""

from collections.abc import Sequence
from typing import Final

from vrts.base.source import SourceFile
from vrts.debug.breakpoints import Breakpoint, resolve
from vrts.debug.debugger import Debugger, Stop, Way, Why
from vrts.debug.frames import frames
from vrts.debug.passages import Instant, instant_of
from vrts.debug.values import scopes
from vrts.engine.memory.events import Cause, Printed
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.lang.dialect import Dialect
from vrts.live.rehearsing.asked import What
from vrts.live.rehearsing.told import Block, Place, Stopped, Variable
from vrts.live.session.channel.messages import BLOCK
from vrts.live.session.looking.block import block
from vrts.report.plain import one_line

MOST_VARIABLES: Final = 300
LONGEST_VALUE: Final = 200  # characters
MOST_LINES: Final = 20  # of output
LONGEST_LINE: Final = 200  # characters
NOTHING: Final = "the rehearsal does not reach so far"

_WORDS: Final = {
    Why.ENTRY: "start",
    Why.BEGIN: "start",
    Why.BREAKPOINT: "breakpoint",
    Why.END: "end",
}
_GROUPS: Final = {
    "Arguments and AUTO": "local",
    "Variables": "variable",
    "Locations": "location",
}


class Rehearsal:
    """One run, and where one stands in it."""

    def __init__(self, run: Run, source: SourceFile, dialect: Dialect, begin: Instant) -> None:
        """Stand before the first step.

        Args:
            run: Executed to its end; what was before it began does not count.
            source: The rehearsed text.
            dialect: Of the text.
            begin: When the program was begun.
        """
        # up to the horizon: nothing happens between it and the time up to which it was executed
        self.run = Run(run.machine, run.horizon_s, run.checkpoints)
        self.source = source
        self.begin_s = begin.time_s
        self._debugger = Debugger(self.run, dialect)
        self._entry = self._first(begin)
        self._debugger.stop = Stop(self._entry, Why.ENTRY)
        self._fresh = True  # nobody has gone anywhere yet

    @property
    def debugger(self) -> Debugger:
        """What is asked."""
        return self._debugger

    # --- breakpoints --------------------------------------------------------------------------

    def stop_at(self, lines: Sequence[int]) -> tuple[Place, ...]:
        """Stop at lines of the text from now on; return where each stands."""
        name, code = self.source.name, self.run.history.code
        wanted = sorted(set(lines))
        self._debugger.wishes.lines = [Breakpoint(line, name, line) for line in wanted]
        found = [(line, resolve(code, name, line)) for line in wanted]
        return tuple(
            Place(line, known is not None, line if known is None else known.line)
            for line, known in found
        )

    # --- places -------------------------------------------------------------------------------

    def go(self, of: int, what: What) -> Stopped:
        """Go somewhere, and return what is there."""
        debugger, fresh = self._debugger, self._fresh
        self._fresh = False
        match what:
            case "run" if fresh and self._stops_at_once:
                debugger.stop = Stop(self._entry, Why.BREAKPOINT)
            case "run":
                debugger.go_on()
            case "over":
                debugger.step(Way.OVER)
            case "into":
                debugger.step(Way.INTO)
            case "out":
                debugger.step(Way.OUT)
            case "back":
                debugger.step_back()
            case "back_run":
                debugger.reverse()
            case "start":
                self._to_start()
            case "end":
                stop = debugger.jump(self.run.horizon_s)
                debugger.stop = stop._replace(why=Why.END)
        if debugger.at < self._entry:
            self._to_start()
        return self._told(of)

    def at(self, of: int, time_s: float) -> Stopped:
        """Go to a time [s], as near to it as the run reaches, and return what is there."""
        self._fresh = False
        stop = self._debugger.jump(max(time_s, self.begin_s))
        if stop.instant < self._entry:
            self._to_start()
        return self._told(of, "time")

    def block(self, of: int, number: int) -> Block:
        """Return a minute of the run."""
        if not self.begin_s // BLOCK <= number <= self.run.until_s // BLOCK:
            return Block(of, number, message=NOTHING)
        data = block(self.run, number, self.begin_s)
        return Block(of, number, {**data, "whole": True})  # it never grows

    def line_of(self, cause: Cause | None) -> int:
        """Return the line of a step, where it is one of the text."""
        known = cause is not None and cause.span.source.name == self.source.name
        return cause.span.line if cause is not None and known else 0

    @property
    def _stops_at_once(self) -> bool:
        """Whether a breakpoint is at the first step."""
        passages, code = self._debugger.passages(process=False), self.run.history.code
        first = passages.following(self._entry)
        if first >= passages.count:
            return False
        lines = [point.line for point in self._debugger.wishes.lines]
        found = [resolve(code, self.source.name, line) for line in lines]
        number = int(passages.instructions[first])
        return any(known is not None and number in known.instructions for known in found)

    # --- parts --------------------------------------------------------------------------------

    def _first(self, begin: Instant) -> Instant:
        """Return the instant of the first step, once the program was begun."""
        passages = self._debugger.passages(process=False)
        first = passages.following(begin)
        if first >= passages.count:
            return begin
        return instant_of(self.run, int(passages.before[first]))

    def _to_start(self) -> None:
        self._debugger.restart()
        self._debugger.stop = Stop(self._entry, Why.ENTRY)

    def _told(self, of: int, why: str = "") -> Stopped:
        debugger, run = self._debugger, self.run
        stop = debugger.stop
        inside = frames(run, stop.instant, process=stop.process)
        frame = inside[0] if inside else None
        failed = stop.why is Why.END and run.ending is Ending.ERROR
        cause = frame.cause if frame is not None else self._last_cause() if failed else None
        shown = [
            Variable(one.name, one.value[:LONGEST_VALUE], _GROUPS[scope.name])
            for scope in scopes(debugger, frame)
            if scope.name in _GROUPS
            for one in scope.shown
        ]
        return Stopped(
            of,
            why or ("error" if failed else _WORDS.get(stop.why, "step")),
            stop.instant.time_s,
            "" if cause is None else cause.program,
            self.line_of(cause),
            "" if cause is None else one_line(cause.span.text.strip())[:LONGEST_LINE],
            len(inside),
            tuple(shown[:MOST_VARIABLES]),
            max(len(shown) - MOST_VARIABLES, 0),
            self._typed(stop.instant),
            one_line(run.findings[-1].headline) if failed and run.findings else stop.text,
        )

    def _last_cause(self) -> Cause | None:
        """Return the step at which the program failed."""
        events = reversed(self.run.events)
        return next((event.cause for event in events if event.cause is not None), None)

    def _typed(self, at: Instant) -> tuple[str, ...]:
        """Return the last lines that programs have written."""
        run = self.run
        rows = zip(run.events, run.event_numbers, strict=True)
        texts = [
            event.text
            for event, number in rows
            if isinstance(event, Printed)
            and self.begin_s <= event.time_s <= at.time_s
            and number <= at.finished
        ]
        lines = "".join(texts[-10 * MOST_LINES :]).splitlines()[-MOST_LINES:]
        return tuple(line[:LONGEST_LINE] for line in lines)
