"""Requests about what there is to see where it stands, and those that change it."""

from collections.abc import Callable, Mapping

from vrts.debug.dap.arguments import BadRequest, Fields
from vrts.debug.dap.editing import typed
from vrts.debug.dap.session import (
    FRAMES,
    OF_CAUSE,
    PROCESS,
    ROBOT,
    Answer,
    Event,
    Json,
    Session,
    of_process,
    source_body,
)
from vrts.debug.frames import Frame
from vrts.debug.values import scopes, variable
from vrts.engine.memory.events import Cause
from vrts.report.plain import one_line, plain_text

NAMES = {ROBOT: "robot program", PROCESS: "process control program"}


def _threads(session: Session, _: Fields) -> Answer:
    found = [{"id": ROBOT, "name": NAMES[ROBOT]}]
    if session.debugger.passages(process=True).count:
        found.append({"id": PROCESS, "name": NAMES[PROCESS]})
    return Answer({"threads": found})


def _stack_trace(session: Session, a: Fields) -> Answer:
    thread = a.whole("threadId", ROBOT)
    stack = session.stack(process=of_process(a))
    bodies = [_frame_body(thread * FRAMES + k, cause) for k, cause in enumerate(stack)]
    cause = session.cause(process=of_process(a))
    if cause is not None:  # on top, since its line is what a client shows
        body = _frame_body(thread * FRAMES + OF_CAUSE, cause)
        now = f"; now at step {stack[0].step}" if stack else ""
        bodies.insert(0, {**body, "name": f"{body['name']}, the cause{now}"})
    start = a.whole("startFrame", 0)
    count = a.whole("levels", 0) or len(bodies)
    return Answer({"stackFrames": bodies[start : start + count], "totalFrames": len(bodies)})


def _scopes(session: Session, a: Fields) -> Answer:
    found = scopes(session.debugger, session.frame(a))
    return Answer({"scopes": [session.handles.scope(scope) for scope in found if scope.shown]})


def _variables(session: Session, a: Fields) -> Answer:
    reference, start = a.whole("variablesReference"), a.whole("start", 0)
    return Answer({"variables": session.handles.variables(reference, start, a.whole("count", 0))})


def _evaluate(session: Session, a: Fields) -> Answer:
    text, frame = a.text("expression"), session.frame(a)
    if a.optional("context") != "repl":
        shown = variable(text, session.console.value(text, frame))
        reference = session.handles.of(shown.parts)
        return Answer({"result": shown.value, "variablesReference": reference})
    debugger = session.debugger
    before, stop = debugger.run, debugger.stop
    done = typed(session, text)
    said = plain_text(session.console.enter(text, frame) if done is None else done).rstrip("\n")
    moved: list[Event] = []
    if debugger.run is not before:
        moved = session.moved()
        if done is not None:
            moved += session.stopped(debugger.stop)
    elif debugger.stop is not stop:
        moved = session.stopped(debugger.stop)
    return Answer({"result": said, "variablesReference": 0}, moved)


def _set_variable(session: Session, a: Fields) -> Answer:
    reference = a.whole("variablesReference")
    known = session.handles.named(reference, a.text("name"))
    if not known.variable:
        raise BadRequest(f"`{known.name}` cannot be given another value")
    return _given(session, known.variable, a.text("value"), session.handles.frame(reference))


def _set_expression(session: Session, a: Fields) -> Answer:
    return _given(session, a.text("expression"), a.text("value"), session.frame(a))


def _given(session: Session, name: str, text: str, frame: Frame | None) -> Answer:
    shown = session.console.give(name, text, frame).strip()
    return Answer({"value": shown, "variablesReference": 0}, session.moved())


def _exception_info(session: Session, _: Fields) -> Answer:
    stop = session.debugger.stop
    if stop.alarm is None:
        raise BadRequest("it did not stop for an alarm")
    body: Json = {
        "exceptionId": stop.alarm.filter.value,
        "description": one_line(stop.text) + _under_way(session),
        "breakMode": "always",
    }
    found = stop.alarm.diagnostic
    if found is not None:
        found = session.console.allowed(found)
        more = [found.headline, *found.notes, *(f"help: {line}" for line in found.help)]
        body["details"] = {"message": one_line(found.headline), "stackTrace": "\n".join(more)}
    return Answer(body)


def _under_way(session: Session) -> str:
    """Return which motion the arm carries out: the program may be a step ahead."""
    motion = session.debugger.state.cause
    if motion is None:
        return ""
    return f"; in line {motion.span.line}: {one_line(motion.span.text)}"


def _loaded_sources(session: Session, _: Fields) -> Answer:
    return Answer({"sources": [source_body(source) for source in session.sources]})


def _frame_body(number: int, cause: Cause) -> Json:
    span = cause.span
    return {
        "id": number,
        "name": f"{cause.program}, step {cause.step}",
        "source": source_body(span.source),
        "line": span.line,
        "column": span.column,
        "endLine": span.line,
        "endColumn": span.column + len(span.text),
    }


SEEING: Mapping[str, Callable[[Session, Fields], Answer]] = {
    "threads": _threads,
    "stackTrace": _stack_trace,
    "scopes": _scopes,
    "variables": _variables,
    "evaluate": _evaluate,
    "setVariable": _set_variable,
    "setExpression": _set_expression,
    "exceptionInfo": _exception_info,
    "loadedSources": _loaded_sources,
}
