"""Requests that go somewhere else: forward, backward, or to another step."""

from collections.abc import Callable, Mapping

from vrts.debug.breakpoints import resolve
from vrts.debug.dap.arguments import BadRequest, Fields
from vrts.debug.dap.session import (
    ROBOT,
    Answer,
    Event,
    Session,
    of_process,
    source_path,
    stop_body,
)
from vrts.debug.debugger import Stop, Way, Why
from vrts.ir.commands import GoTo


def _continue(session: Session, _: Fields) -> Answer:
    return Answer({"allThreadsContinued": True}, go=session.debugger.go_on)


def _reverse_continue(session: Session, _: Fields) -> Answer:
    return Answer({}, go=session.debugger.reverse)


def _next(session: Session, a: Fields) -> Answer:
    return _stepped(session, a, Way.OVER)


def _step_in(session: Session, a: Fields) -> Answer:
    return _stepped(session, a, Way.INTO)


def _step_out(session: Session, a: Fields) -> Answer:
    return _stepped(session, a, Way.OUT)


def _step_back(session: Session, a: Fields) -> Answer:
    if _by_tick(a):
        return _at(session, session.debugger.tick(-1))
    return _at(session, session.debugger.step_back(process=of_process(a)))


def _pause(session: Session, _: Fields) -> Answer:
    if session.paused:
        session.paused = False
        return Answer({})
    body = {**stop_body(session.debugger.stop), "reason": "pause"}
    return Answer({}, [("stopped", body)])


def _goto_targets(session: Session, a: Fields) -> Answer:
    code = session.debugger.run.history.code
    resolved = resolve(code, source_path(a), a.whole("line"))
    if resolved is None:
        return Answer({"targets": []})
    number = min(resolved.instructions)
    label = code.causes[number].span.text
    return Answer({"targets": [{"id": number, "label": label, "line": resolved.line}]})


def _goto(session: Session, a: Fields) -> Answer:
    debugger = session.debugger
    causes = debugger.run.history.code.causes
    number = a.whole("targetId")
    if not 0 <= number < len(causes):
        raise BadRequest("there is no such target")
    process = of_process(a)
    stack = session.stack(process=process)
    if not stack or stack[0].program != causes[number].program:
        raise BadRequest("only a step of the program that is being executed can come next")
    refused = debugger.change([GoTo(causes[number].step, process)])
    if refused:
        raise BadRequest(refused[0])
    session.moved()
    return _at(session, debugger.stop._replace(why=Why.GOTO, process=process))


def _tick(session: Session, a: Fields) -> Answer:
    """Go set points of the arm, as a client's own button asks: it has to be told that it goes."""
    going: Event = ("continued", {"threadId": ROBOT, "allThreadsContinued": True})
    stop = session.debugger.tick(1 if a.whole("count", 1) >= 0 else -1)
    return Answer({}, [going, *session.stopped(stop)])


def _stepped(session: Session, a: Fields, way: Way) -> Answer:
    if _by_tick(a):
        return _at(session, session.debugger.tick(1))
    return _at(session, session.debugger.step(way, process=of_process(a)))


def _by_tick(a: Fields) -> bool:
    """Return whether the steps are those of the arm: one set point."""
    return a.optional("granularity") == "instruction"


def _at(session: Session, stop: Stop) -> Answer:
    return Answer({}, session.stopped(stop))


GOING: Mapping[str, Callable[[Session, Fields], Answer]] = {
    "continue": _continue,
    "reverseContinue": _reverse_continue,
    "next": _next,
    "stepIn": _step_in,
    "stepOut": _step_out,
    "stepBack": _step_back,
    "pause": _pause,
    "vrts.tick": _tick,
    "gotoTargets": _goto_targets,
    "goto": _goto,
}
