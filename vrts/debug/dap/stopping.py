"""Requests that say where to stop: lines, changes and alarms."""

from collections.abc import Callable, Mapping

from vrts.debug.alarms import Filter
from vrts.debug.breakpoints import Breakpoint, Watch, is_hit_rule, lines_with_steps, resolve
from vrts.debug.changes import changes, watchable
from vrts.debug.dap.arguments import Fields
from vrts.debug.dap.session import Answer, Json, Session, source_path
from vrts.debug.evaluating import CannotTell

_HITS = "how often: a number, or `>= 3`, `% 5` and the like"


def _set_breakpoints(session: Session, a: Fields) -> Answer:
    path = source_path(a)
    debugger = session.debugger
    kept: list[Breakpoint] = []
    answers: list[Json] = []
    for wish in a.parts("breakpoints"):
        point = Breakpoint(
            session.new_id(),
            path,
            wish.whole("line"),
            wish.optional("condition") or "",
            wish.optional("hitCondition") or "",
            wish.optional("logMessage") or "",
        )
        resolved = resolve(debugger.run.history.code, path, point.line)
        if resolved is None:
            answers.append(_refused(point.id, "no step of a program follows here"))
        elif not is_hit_rule(point.hits):
            answers.append(_refused(point.id, _HITS))
        else:
            kept.append(point)
            answers.append({"id": point.id, "verified": True, "line": resolved.line})
    session.lines[path] = kept
    debugger.wishes.lines = [point for points in session.lines.values() for point in points]
    return Answer({"breakpoints": answers})


def _breakpoint_locations(session: Session, a: Fields) -> Answer:
    first = a.whole("line")
    last = a.whole("endLine", first)
    lines = lines_with_steps(session.debugger.run.history.code, source_path(a))
    return Answer({"breakpoints": [{"line": n} for n in lines if first <= n <= last]})


def _set_exception_breakpoints(session: Session, a: Fields) -> Answer:
    names = a.texts("filters")
    session.debugger.wishes.filters = frozenset(kind for kind in Filter if kind.value in names)
    known = {kind.value for kind in Filter}
    return Answer({"breakpoints": [{"verified": name in known} for name in names]})


def _data_breakpoint_info(session: Session, a: Fields) -> Answer:
    name = a.text("name")
    reference = a.whole("variablesReference", 0)
    frame = session.frame(a)
    if reference:
        frame = session.handles.frame(reference)
        name = session.handles.named(reference, name).variable or name
    debugger = session.debugger
    try:
        found = watchable(debugger.run, name, frame)
    except CannotTell as problem:
        return Answer({"dataId": None, "description": str(problem)})
    never = "" if changes(debugger.run, found.name) else "; as it goes now it never changes"
    return Answer(
        {
            "dataId": found.name,
            "description": f"{found.words}{never}",
            "accessTypes": ["write"],
            "canPersist": True,
        }
    )


def _set_data_breakpoints(session: Session, a: Fields) -> Answer:
    kept: list[Watch] = []
    answers: list[Json] = []
    for wish in a.parts("breakpoints"):
        watch = Watch(
            session.new_id(),
            wish.text("dataId"),
            wish.optional("condition") or "",
            wish.optional("hitCondition") or "",
        )
        if is_hit_rule(watch.hits):
            kept.append(watch)
            answers.append({"id": watch.id, "verified": True})
        else:
            answers.append(_refused(watch.id, _HITS))
    session.debugger.wishes.watches = kept
    return Answer({"breakpoints": answers})


def _refused(number: int, words: str) -> Json:
    return {"id": number, "verified": False, "message": words}


STOPPING: Mapping[str, Callable[[Session, Fields], Answer]] = {
    "setBreakpoints": _set_breakpoints,
    "breakpointLocations": _breakpoint_locations,
    "setExceptionBreakpoints": _set_exception_breakpoints,
    "dataBreakpointInfo": _data_breakpoint_info,
    "setDataBreakpoints": _set_data_breakpoints,
}
