"""What one client debugs, and what it has been told of it so far.

The robot program is thread 1, the process control program thread 2; both always stand at the same
instant.
"""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias

from vrts.base.source import SourceFile
from vrts.debug.alarms import DEFAULT
from vrts.debug.breakpoints import Breakpoint
from vrts.debug.console import Console
from vrts.debug.dap.arguments import BadRequest, Fields
from vrts.debug.dap.handles import Handles
from vrts.debug.debugger import Debugger, Stop, Why
from vrts.debug.editing.futures import gave_up
from vrts.debug.editing.text import sources_of
from vrts.debug.files import Files
from vrts.debug.frames import Frame, frames
from vrts.engine.memory.events import Cause
from vrts.engine.memory.records import Ending
from vrts.report.plain import one_line, plain_text

Json: TypeAlias = dict[str, Any]
Event: TypeAlias = tuple[str, Json]  # its name and its body

ROBOT, PROCESS = 1, 2  # threads
FRAMES = 100_000  # numbers of frames that a thread may have
OF_CAUSE = FRAMES - 1  # that of the step that caused an alarm
MOST_OUTPUT = 200_000  # characters sent at once
_REASONS = {Why.BEGIN: "entry", Why.END: "pause", Why.GO: "goto"}
_WORDS = {
    Why.ENTRY: "At the beginning,",
    Why.STEP: "Step,",
    Why.BREAKPOINT: "Breakpoint,",
    Why.CHANGE: "Change,",
    Why.ALARM: "Alarm,",
    Why.GOTO: "Another step,",
    Why.GO: "Gone to,",
    Why.BEGIN: "At the beginning,",
    Why.END: "At the end,",
}


class Answer(NamedTuple):
    """What a request is answered with."""

    body: Json
    events: Sequence[Event] = ()  # sent after the response
    go: Callable[[], Stop] | None = None  # what may take long: done after the response was sent


class Session:
    """A program being debugged by a client."""

    def __init__(self, debugger: Debugger, console: Console, files: Files) -> None:
        """Begin before the first step."""
        self.debugger = debugger
        self.console = console
        self.files = files
        self.handles = Handles()
        self.lines: dict[str, list[Breakpoint]] = {}  # by source
        self.paused = False  # it was stopped by the client, which has been told so
        self._next_id = 1
        self._told = 0  # characters of the terminal that the client has seen
        self._futures = 1, debugger.run  # a number, and which run it is of
        debugger.wishes.filters = DEFAULT

    def take_over(self, other: "Session") -> None:
        """Wish what another session wished."""
        self.debugger.wishes = other.debugger.wishes
        self.lines, self._next_id = other.lines, other._next_id
        self._futures = other._futures
        self.console.goals.marks = other.console.goals.marks

    def new_id(self) -> int:
        """Return a number for a breakpoint."""
        self._next_id += 1
        return self._next_id - 1

    @property
    def sources(self) -> tuple[SourceFile, ...]:
        """The texts of the programs, as the present future has them."""
        return sources_of(self.debugger)

    @property
    def future(self) -> int:
        """A number that is another one whenever the run is another one."""
        number, before = self._futures
        run = self.debugger.run
        if before is not run:
            self._futures = number + 1, run
        return self._futures[0]

    # --- where it is --------------------------------------------------------------------------

    def frames(self, *, process: bool) -> tuple[Frame, ...]:
        """Return what a thread executes, the innermost program first."""
        return frames(self.debugger.run, self.debugger.at, process=process)

    def frame(self, a: Fields) -> Frame | None:
        """Return the frame that a request is about; None for a program that is over.

        Without a frame it is about the innermost program of the robot.
        """
        thread, place = divmod(a.whole("frameId", ROBOT * FRAMES), FRAMES)
        inside = self.frames(process=thread == PROCESS)
        if place == OF_CAUSE:  # it sees what its program sees now
            cause = self.debugger.stop.cause
            names = [frame.cause.program for frame in inside]
            place = names.index(cause.program) if cause and cause.program in names else 0
        return inside[place] if place < len(inside) else None

    def stack(self, *, process: bool) -> list[Cause]:
        """Return where the programs of a thread are, the innermost first.

        A thread that is over stands at its last step.
        """
        found = [frame.cause for frame in self.frames(process=process)]
        passages = self.debugger.passages(process=process)
        over = passages.count and passages.following(self.debugger.at) == passages.count
        return [passages.cause(passages.count - 1)] if over and not found else found

    def cause(self, *, process: bool) -> Cause | None:
        """Return the step that caused the alarm where it stands, if the program is elsewhere."""
        stop = self.debugger.stop
        cause = stop.cause
        if cause is None or process != stop.process:
            return None
        stack = self.stack(process=process)
        return None if stack and stack[0][:2] == cause[:2] else cause

    # --- what is told -------------------------------------------------------------------------

    def restarted(self) -> list[Event]:
        """Return what tells a client that it stands at the beginning again."""
        self._told = 0
        before = self.debugger.run.module
        stop = self.debugger.restart()
        if self.debugger.run.module is not before:
            self.console.show(self.sources)
        return self.stopped(stop)

    def moved(self) -> list[Event]:
        """Return what tells a client that what it shows is another future now."""
        self._told = min(self._told, len(self.debugger.state.output))
        self.handles.clear()
        gone = gave_up(self.debugger.take_gone())
        said = [("output", {"category": "console", "output": f"{gone}\n"})] if gone else []
        return [*said, ("invalidated", {"areas": ["variables", "stacks"]})]

    def stopped(self, stop: Stop, *, paused: bool = False) -> list[Event]:
        """Return what tells a client where it stands now, and what was written on the way.

        Args:
            stop: Where it stands.
            paused: The client has stopped what was looked for: it stands where it stood.
        """
        self.handles.clear()
        events = [*self._news(), *self._written()]
        self.paused = paused
        if paused:
            return [*events, ("stopped", {**stop_body(stop), "reason": "pause"})]
        if stop.why is Why.END:
            events.append(("output", {"category": "console", "output": self._ended()}))
        body = stop_body(stop)
        cause, stack = self.cause(process=stop.process), self.stack(process=stop.process)
        if cause is not None:
            now = f"; the program is at line {stack[0].span.line}" if stack else ""
            body["text"] = f"{one_line(stop.text)}; caused by line {cause.span.line}{now}"
        return [*events, ("stopped", body)]

    def over(self) -> list[Event]:
        """Go to the end; return what tells a client that was to run without debugging."""
        debugger = self.debugger
        debugger.seek(debugger.run.horizon_s)
        if debugger.asks:
            return self.stopped(debugger.stop._replace(why=Why.END))
        fine = debugger.run.ending in (Ending.COMPLETED, Ending.HALTED)
        return [*self._written(), ("exited", {"exitCode": 0 if fine else 1}), ("terminated", {})]

    def _news(self) -> list[Event]:
        news = self.files.news()
        if not news:
            return []
        return [("output", {"category": "important", "output": f"{one_line(news)}\n"})]

    def _written(self) -> list[Event]:
        debugger = self.debugger
        events: list[Event] = []
        output = debugger.state.output
        if len(output) > self._told:
            text = output[self._told :][-MOST_OUTPUT:].replace("\r\n", "\n")
            events.append(("output", {"category": "stdout", "output": plain_text(text)}))
            self._told = len(output)
        for logged in debugger.log:
            text = f"{logged.instant.time_s:.3f} s: {one_line(logged.text)}\n"
            events.append(("output", {"category": "console", "output": text}))
        debugger.log.clear()
        return events

    def _ended(self) -> str:
        debugger = self.debugger
        if debugger.asks:
            return "the program waits for a line: type it here\n"
        run = debugger.run
        return f"{run.ending.value} at {debugger.at.time_s:.3f} s; stepping back is possible\n"


def stop_body(stop: Stop) -> Json:
    """Return a stop as the protocol has it."""
    body: Json = {
        "reason": _REASONS.get(stop.why, stop.why.value),
        "threadId": PROCESS if stop.process else ROBOT,
        "allThreadsStopped": True,
        "description": f"{_WORDS[stop.why]} at {stop.instant.time_s:.3f} s",
    }
    if stop.text:
        body["text"] = one_line(stop.text)
    if stop.ids:
        body["hitBreakpointIds"] = list(stop.ids)
    return body


def of_process(a: Fields) -> bool:
    """Return whether a request is about the process control program."""
    return a.whole("threadId", ROBOT) == PROCESS


def source_path(a: Fields) -> str:
    """Return the name of the source that a request is about, as sources are named here."""
    try:
        return str(Path(a.part("source").text("path")).resolve())
    except (OSError, RuntimeError) as problem:  # too long, or links in a circle
        raise BadRequest("there is no such file") from problem


def source_body(source: SourceFile) -> Json:
    """Return a source as the protocol has it."""
    return {"name": Path(source.name).name, "path": source.name}
