"""A run of a text, a place in it, and ways to go from there: what the process of a rehearsal holds.

Everything is looked up in the run (`debug.debugger`): going back costs what going forward costs.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from vrts.base.source import SourceFile
from vrts.debug.breakpoints import Breakpoint, resolve
from vrts.debug.debugger import Debugger, Stop, Way, Why
from vrts.debug.frames import frames
from vrts.debug.passages import Instant, instant_of
from vrts.debug.values import FEW, variable
from vrts.engine.memory.events import Cause, Printed
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.ir.values import Value
from vrts.lang.dialect import Dialect
from vrts.live.rehearsing.asked import What
from vrts.live.rehearsing.told import Block, Place, Stopped, Variable
from vrts.live.session.channel.messages import BLOCK
from vrts.live.session.looking.block import block
from vrts.monitor.listings import name_order
from vrts.report.plain import one_line

Passed: TypeAlias = NDArray[np.int64]

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
            case "run":
                self._on(begin=self._entry.finished - 1 if fresh else debugger.at.finished)
            case "over":
                debugger.step(Way.OVER)
            case "into":
                debugger.step(Way.INTO)
            case "out":
                debugger.step(Way.OUT)
            case "back":
                debugger.step_back()
            case "back_run":
                self._back()
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

    # --- parts --------------------------------------------------------------------------------

    def _first(self, begin: Instant) -> Instant:
        """Return the instant of the first step, once the program was begun."""
        passages = self._debugger.passages(process=False)
        first = passages.following(begin)
        if first >= passages.count:
            return begin
        return instant_of(self.run, int(passages.before[first]))

    def _on(self, begin: int) -> None:
        """Go to the first breakpoint after so many finished statements, or to the end."""
        end = self._debugger.jump(self.run.horizon_s)
        found = [
            self._came(process, int(passes[reached > begin][0]))
            for process, passes, reached in self._passes()
            if len(reached) and reached[-1] > begin
        ]
        self._debugger.stop = min(found, key=_when, default=end._replace(why=Why.END))

    def _back(self) -> None:
        """Go to the breakpoint before, or to the start."""
        at = self._debugger.at
        found: list[Stop] = []
        for process, passes, reached in self._passes():
            last = passes[reached <= at.finished][:-3:-1].tolist()  # at most one of them is here
            earlier = (stop for k in last if (stop := self._came(process, k)).instant < at)
            found += list(earlier)
        self._to_start()
        self._debugger.stop = max(found, key=_when, default=self._debugger.stop)

    def _passes(self) -> Iterator[tuple[bool, Passed, Passed]]:
        """Yield how both programs come to breakpoints, in order: with which of their statements.

        And how many statements of both are finished then.
        """
        name, code, entry = self.source.name, self.run.history.code, self._entry.finished
        resolved = [resolve(code, name, point.line) for point in self._debugger.wishes.lines]
        wanted = np.array(
            sorted({number for one in resolved if one is not None for number in one.instructions}),
            np.int64,
        )
        for process in (False, True):
            passages = self._debugger.passages(process=process)
            comes = np.isin(passages.instructions, wanted) & passages.begins
            passes = np.flatnonzero(comes & (passages.before >= entry))
            yield process, passes, np.maximum(passages.reached[passes], entry)

    def _came(self, process: bool, number: int) -> Stop:
        passages = self._debugger.passages(process=process)
        instant = max(passages.instant(number), self._entry)
        return Stop(instant, Why.BREAKPOINT, process=process)

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
        own: Mapping[str, Value] = {} if frame is None else frame.locals(run, stop.instant)
        shown = [*shown_of(own, "local"), *shown_of(debugger.state.variables)]
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


def _when(stop: Stop) -> Instant:
    return stop.instant


def shown_of(values: Mapping[str, Value], group: str = "") -> Iterator[Variable]:
    """Yield variables by name; of an array with many elements only how many it has.

    Args:
        values: By name.
        group: That they are shown in; empty: as their kind is.
    """
    arrays: dict[str, list[str]] = {}
    for name in values:
        arrays.setdefault(name.partition("[")[0], []).append(name)
    for base in sorted(arrays, key=name_order):
        names = arrays[base]
        kind = group or ("location" if isinstance(values[names[0]], tuple) else "variable")
        if len(names) > FEW:
            yield Variable(f"{base}[]", f"{len(names):,} elements", kind)
            continue
        for name in sorted(names, key=name_order):
            yield Variable(name, variable(name, values[name]).value[:LONGEST_VALUE], kind)
