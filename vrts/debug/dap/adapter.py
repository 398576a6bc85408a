"""Requests of a debug client, answered from a run. Nothing executes between two of them.

The robot program is thread 1, the process control program thread 2; both always stand at the same
instant. Specification: the Debug Adapter Protocol, version 1.71.
"""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeAlias

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.debug.alarms import Filter
from vrts.debug.breakpoints import Breakpoint, is_hit_rule, lines_with_steps, resolve
from vrts.debug.changes import changes
from vrts.debug.console import Console
from vrts.debug.dap.arguments import BadRequest, Fields
from vrts.debug.dap.capabilities import CAPABILITIES, DEFAULT
from vrts.debug.dap.handles import Handles
from vrts.debug.debugger import Debugger, Stop, Way, Why
from vrts.debug.evaluating import CannotTell, evaluate
from vrts.debug.opening import Asked, opened
from vrts.debug.values import scopes, variable
from vrts.engine.events import Cause
from vrts.ir.commands import GoTo
from vrts.pipeline.files import CannotRead
from vrts.pipeline.settings import Refused
from vrts.report.plain import one_line, plain_text
from vrts.report.text import diagnostic_text

Json: TypeAlias = dict[str, Any]
Send: TypeAlias = Callable[[str, Json], None]
_Answer: TypeAlias = tuple[Json, list[tuple[str, Json]]]

ROBOT, PROCESS = 1, 2  # threads
NAMES = {ROBOT: "robot program", PROCESS: "process control program"}
MOST_OUTPUT = 200_000  # characters sent at once


class Adapter:
    """One client and its session."""

    def __init__(self, send_event: Send) -> None:
        """Take what sends an event: its name and its body."""
        self._event = send_event
        self._debugger: Debugger | None = None
        self._console: Console | None = None
        self._sources: tuple[SourceFile, ...] = ()
        self._handles = Handles()
        self._filters = DEFAULT
        self._lines: dict[str, list[Breakpoint]] = {}
        self._next_id = 1
        self._told = 0  # characters of the terminal that the client has seen
        self._stops_first = True
        self.over = False  # the client is gone, or was told to go
        self._handlers: dict[str, Callable[[Fields], _Answer]] = {
            "initialize": self._on_initialize,
            "launch": self._on_launch,
            "configurationDone": self._on_configuration_done,
            "restart": self._on_restart,
            "terminate": self._on_terminate,
            "disconnect": self._on_disconnect,
            "setBreakpoints": self._on_set_breakpoints,
            "setExceptionBreakpoints": self._on_set_exception_breakpoints,
            "dataBreakpointInfo": self._on_data_breakpoint_info,
            "setDataBreakpoints": self._on_set_data_breakpoints,
            "breakpointLocations": self._on_breakpoint_locations,
            "continue": self._on_continue,
            "reverseContinue": self._on_reverse_continue,
            "next": self._on_next,
            "stepIn": self._on_step_in,
            "stepOut": self._on_step_out,
            "stepBack": self._on_step_back,
            "pause": self._on_pause,
            "gotoTargets": self._on_goto_targets,
            "goto": self._on_goto,
            "threads": self._on_threads,
            "stackTrace": self._on_stack_trace,
            "scopes": self._on_scopes,
            "variables": self._on_variables,
            "evaluate": self._on_evaluate,
            "setVariable": self._on_set_variable,
            "setExpression": self._on_set_expression,
            "exceptionInfo": self._on_exception_info,
            "loadedSources": self._on_loaded_sources,
        }

    def answer(self, command: str, arguments: Fields) -> tuple[Json, list[tuple[str, Json]]]:
        """Carry a request out; return the body of the response, and events to send after it.

        Raises:
            BadRequest: It cannot be carried out; the text says why.
        """
        handler = self._handlers.get(command)
        if handler is None:
            raise BadRequest(f"`{command}` is not supported")
        try:
            return handler(arguments)
        except (CannotTell, CannotRead) as problem:
            raise BadRequest(str(problem)) from problem
        except KeyError as problem:
            raise BadRequest(str(problem.args[0])) from problem

    # --- beginning and end --------------------------------------------------------------------

    def _on_initialize(self, _: Fields) -> _Answer:
        return CAPABILITIES, []

    def _on_launch(self, a: Fields) -> _Answer:
        if self._debugger is not None:
            raise BadRequest("a program is being debugged already")
        asked = Asked(
            program=Path(a.text("program")),
            scene=a.optional("scene"),
            task=_path(a.optional("task")),
            scenario=_path(a.optional("scenario")),
            lab=_path(a.optional("lab")),
            entry=a.optional("entry"),
            others=tuple(Path(name) for name in a.texts("with")),
            dialect=a.optional("dialect"),
        )
        self._stops_first = a.truth("stopOnEntry", otherwise=True)
        near = a.number("nearMiss", -1.0)
        try:
            found = opened(asked, near / 1000.0 if near >= 0.0 else None)
        except Refused as refused:
            self._say(_told(refused.diagnostics), "stderr")
            raise BadRequest(_first(refused.diagnostics)) from refused
        self._say(_told(found.diagnostics), "stderr")
        if found.debugger is None:
            raise BadRequest(_first(found.diagnostics))
        self._debugger, self._console = found.debugger, found.console
        self._sources = found.sources
        return {}, [("initialized", {})]

    def _on_configuration_done(self, _: Fields) -> _Answer:
        debugger = self._known
        debugger.wishes.filters = self._filters
        stop = debugger.stop if self._stops_first else debugger.go_on()
        return {}, self._stopped(stop)

    def _on_restart(self, _: Fields) -> _Answer:
        self._told = 0
        return {}, self._stopped(self._known.restart())

    def _on_terminate(self, _: Fields) -> _Answer:
        return {}, [("terminated", {})]

    def _on_disconnect(self, _: Fields) -> _Answer:
        self.over = True
        return {}, []

    # --- where to stop ------------------------------------------------------------------------

    def _on_set_breakpoints(self, a: Fields) -> _Answer:
        path = str(Path(a.part("source").text("path")).resolve())
        debugger = self._known
        kept: list[Breakpoint] = []
        answers: list[Json] = []
        for wish in a.parts("breakpoints"):
            point = Breakpoint(
                self._next_id,
                path,
                wish.whole("line"),
                wish.optional("condition") or "",
                wish.optional("hitCondition") or "",
                wish.optional("logMessage") or "",
            )
            self._next_id += 1
            resolved = resolve(debugger.run.history.code, path, point.line)
            problem = None if resolved is not None else "no step of a program follows here"
            if not is_hit_rule(point.hits):
                problem = "how often: a number, or `>= 3`, `% 5` and the like"
            answer: Json = {"id": point.id, "verified": problem is None}
            if problem is None:
                kept.append(point)
                assert resolved is not None
                answer["line"] = resolved.line
            else:
                answer["message"] = problem
            answers.append(answer)
        self._lines[path] = kept
        debugger.wishes.lines = [point for points in self._lines.values() for point in points]
        return {"breakpoints": answers}, []

    def _on_set_exception_breakpoints(self, a: Fields) -> _Answer:
        names = a.texts("filters")
        self._filters = frozenset(kind for kind in Filter if kind.value in names)
        if self._debugger is not None:
            self._debugger.wishes.filters = self._filters
        known = {kind.value for kind in Filter}
        return {"breakpoints": [{"verified": name in known} for name in names]}, []

    def _on_data_breakpoint_info(self, a: Fields) -> _Answer:
        name = a.text("name")
        reference = a.whole("variablesReference", 0)
        if reference:
            name = self._handles.named(reference, name).variable or name
        found = changes(self._known.run, name)
        if not found and name not in self._known.state.variables:
            return {"dataId": None, "description": f"`{name}` never changes"}, []
        return {
            "dataId": name,
            "description": name,
            "accessTypes": ["write"],
            "canPersist": True,
        }, []

    def _on_set_data_breakpoints(self, a: Fields) -> _Answer:
        names = [wish.text("dataId") for wish in a.parts("breakpoints")]
        self._known.wishes.names = names
        return {"breakpoints": [{"verified": True} for _ in names]}, []

    def _on_breakpoint_locations(self, a: Fields) -> _Answer:
        path = str(Path(a.part("source").text("path")).resolve())
        first = a.whole("line")
        last = a.whole("endLine", first)
        lines = lines_with_steps(self._known.run.history.code, path)
        return {"breakpoints": [{"line": n} for n in lines if first <= n <= last]}, []

    # --- going --------------------------------------------------------------------------------

    def _on_continue(self, _: Fields) -> _Answer:
        return {"allThreadsContinued": True}, self._stopped(self._known.go_on())

    def _on_reverse_continue(self, _: Fields) -> _Answer:
        return {}, self._stopped(self._known.reverse())

    def _on_next(self, a: Fields) -> _Answer:
        return {}, self._stepped(a, Way.OVER)

    def _on_step_in(self, a: Fields) -> _Answer:
        return {}, self._stepped(a, Way.INTO)

    def _on_step_out(self, a: Fields) -> _Answer:
        return {}, self._stepped(a, Way.OUT)

    def _on_step_back(self, a: Fields) -> _Answer:
        if a.optional("granularity") == "instruction":
            return {}, self._stopped(self._known.tick(-1))
        return {}, self._stopped(self._known.step_back(process=_of_process(a)))

    def _on_pause(self, _: Fields) -> _Answer:
        return {}, [("stopped", {**self._stop(self._known.stop), "reason": "pause"})]

    def _on_goto_targets(self, a: Fields) -> _Answer:
        path = str(Path(a.part("source").text("path")).resolve())
        resolved = resolve(self._known.run.history.code, path, a.whole("line"))
        if resolved is None:
            return {"targets": []}, []
        number = min(resolved.instructions)
        label = self._known.run.history.code.causes[number].span.text
        return {"targets": [{"id": number, "label": label, "line": resolved.line}]}, []

    def _on_goto(self, a: Fields) -> _Answer:
        debugger = self._known
        causes = debugger.run.history.code.causes
        number = a.whole("targetId")
        if not 0 <= number < len(causes):
            raise BadRequest("there is no such target")
        process = _of_process(a)
        stack = self._stack(process)
        if not stack or stack[-1].program != causes[number].program:
            raise BadRequest("only a step of the program that is being executed can come next")
        refused = debugger.change([GoTo(causes[number].step, process)])
        if refused:
            raise BadRequest(refused[0])
        self._told = min(self._told, len(debugger.state.output))
        return {}, self._stopped(debugger.stop._replace(why=Why.GOTO))

    # --- what is seen -------------------------------------------------------------------------

    def _on_threads(self, _: Fields) -> _Answer:
        found = [{"id": ROBOT, "name": NAMES[ROBOT]}]
        if self._debugger is not None and self._debugger.passages(process=True).count:
            found.append({"id": PROCESS, "name": NAMES[PROCESS]})
        return {"threads": found}, []

    def _on_stack_trace(self, a: Fields) -> _Answer:
        thread = a.whole("threadId", ROBOT)
        stack = self._stack(thread == PROCESS)
        frames = [
            self._frame(thread * 100_000 + k, cause) for k, cause in enumerate(reversed(stack))
        ]
        start = a.whole("startFrame", 0)
        count = a.whole("levels", 0) or len(frames)
        return {"stackFrames": frames[start : start + count], "totalFrames": len(frames)}, []

    def _on_scopes(self, _: Fields) -> _Answer:
        return {"scopes": [self._handles.scope(scope) for scope in scopes(self._known)]}, []

    def _on_variables(self, a: Fields) -> _Answer:
        reference, start = a.whole("variablesReference"), a.whole("start", 0)
        return {"variables": self._handles.variables(reference, start, a.whole("count", 0))}, []

    def _on_evaluate(self, a: Fields) -> _Answer:
        debugger, text = self._known, a.text("expression")
        if a.optional("context") == "repl":
            assert self._console is not None
            before = debugger.run
            shown = plain_text(self._console.enter(text)).rstrip("\n")
            if debugger.run is before:
                return {"result": shown, "variablesReference": 0}, []
            self._told = min(self._told, len(debugger.state.output))
            return {"result": shown, "variablesReference": 0}, self._moved()
        value = evaluate(debugger.run, debugger.at, text, debugger.dialect)
        shown_value = variable(text, value)
        return {
            "result": shown_value.value,
            "variablesReference": self._handles.of(shown_value.parts),
        }, []

    def _on_set_variable(self, a: Fields) -> _Answer:
        known = self._handles.named(a.whole("variablesReference"), a.text("name"))
        if not known.variable:
            raise BadRequest(f"`{known.name}` cannot be given another value")
        return self._given(known.variable, a.text("value"))

    def _on_set_expression(self, a: Fields) -> _Answer:
        return self._given(a.text("expression"), a.text("value"))

    def _on_exception_info(self, _: Fields) -> _Answer:
        stop = self._known.stop
        if stop.alarm is None:
            raise BadRequest("it did not stop for an alarm")
        body: Json = {
            "exceptionId": stop.alarm.filter.value,
            "description": one_line(stop.text),
            "breakMode": "always",
        }
        found = stop.alarm.diagnostic
        if found is not None:
            more = [found.headline, *found.notes, *(f"help: {line}" for line in found.help)]
            body["details"] = {"message": one_line(found.headline), "stackTrace": "\n".join(more)}
        return body, []

    def _on_loaded_sources(self, _: Fields) -> _Answer:
        return {"sources": [_source(source) for source in self._sources]}, []

    # --- parts --------------------------------------------------------------------------------

    @property
    def _known(self) -> Debugger:
        if self._debugger is None:
            raise BadRequest("nothing is being debugged: `launch` comes first")
        return self._debugger

    def _stepped(self, a: Fields, way: Way) -> list[tuple[str, Json]]:
        if a.optional("granularity") == "instruction":
            return self._stopped(self._known.tick(1))
        return self._stopped(self._known.step(way, process=_of_process(a)))

    def _given(self, name: str, text: str) -> _Answer:
        assert self._console is not None
        shown = self._console.give(name, text)
        self._told = min(self._told, len(self._known.state.output))
        return {"value": shown.strip(), "variablesReference": 0}, self._moved()

    def _moved(self) -> list[tuple[str, Json]]:
        """Return what tells a client that what it shows is another future now."""
        self._handles.clear()
        return [("invalidated", {"areas": ["variables", "stacks"]})]

    def _stopped(self, stop: Stop) -> list[tuple[str, Json]]:
        self._handles.clear()
        debugger = self._known
        events: list[tuple[str, Json]] = []
        output = debugger.state.output
        if len(output) > self._told:
            text = output[self._told :][-MOST_OUTPUT:].replace("\r\n", "\n")
            events.append(("output", {"category": "stdout", "output": plain_text(text)}))
            self._told = len(output)
        for logged in debugger.log:
            text = f"{logged.instant.time_s:.3f} s: {one_line(logged.text)}\n"
            events.append(("output", {"category": "console", "output": text}))
        debugger.log.clear()
        if stop.why is Why.END:
            events.append(("output", {"category": "console", "output": self._ended()}))
        return [*events, ("stopped", self._stop(stop))]

    def _ended(self) -> str:
        debugger = self._known
        if debugger.asks:
            return "the program waits for a line: type it here\n"
        run = debugger.run
        return f"{run.ending.value} at {debugger.at.time_s:.3f} s; stepping back is possible\n"

    def _stop(self, stop: Stop) -> Json:
        body: Json = {
            "reason": _REASONS.get(stop.why, stop.why.value),
            "threadId": PROCESS if stop.process else ROBOT,
            "allThreadsStopped": True,
            "description": f"{_WORDS[stop.why]} at {stop.instant.time_s:.3f} s",
        }
        if stop.text:
            body["text"] = one_line(stop.text)
        if stop.ids and stop.why is Why.BREAKPOINT:
            body["hitBreakpointIds"] = list(stop.ids)
        return body

    def _stack(self, process: bool) -> tuple[Cause, ...]:
        debugger = self._known
        state = debugger.state
        stack = state.process_stack if process else state.call_stack
        passages = debugger.passages(process=process)
        if not stack and passages.count and passages.following(debugger.at) == passages.count:
            return (passages.cause(passages.count - 1),)
        return stack

    def _frame(self, number: int, cause: Cause) -> Json:
        span = cause.span
        return {
            "id": number,
            "name": f"{cause.program}, step {cause.step}",
            "source": _source(span.source),
            "line": span.line,
            "column": span.column,
            "endLine": span.line,
            "endColumn": span.column + len(span.text),
        }

    def _say(self, text: str, category: str) -> None:
        if text:
            self._event("output", {"category": category, "output": text})


_REASONS = {Why.BEGIN: "entry", Why.END: "pause"}
_WORDS = {
    Why.ENTRY: "At the beginning,",
    Why.STEP: "Step,",
    Why.BREAKPOINT: "Breakpoint,",
    Why.CHANGE: "Change,",
    Why.ALARM: "Alarm,",
    Why.GOTO: "Another step,",
    Why.BEGIN: "At the beginning,",
    Why.END: "At the end,",
}


def _of_process(a: Fields) -> bool:
    return a.whole("threadId", ROBOT) == PROCESS


def _source(source: SourceFile) -> Json:
    path = Path(source.name)
    return {"name": path.name, "path": source.name}


def _path(text: str | None) -> Path | None:
    return None if text is None else Path(text)


def _told(diagnostics: Sequence[Diagnostic]) -> str:
    return "".join(f"{diagnostic_text(found, color=False)}\n\n" for found in diagnostics)


def _first(diagnostics: Sequence[Diagnostic]) -> str:
    errors = [found for found in diagnostics if found.is_error]
    found = errors[0] if errors else None
    if found is None:
        return "there is no program to execute"
    where = f"line {found.primary.span.line}: " if found.primary is not None else ""
    return f"{where}{found.headline} ({found.rule.code})"
