"""Commands that look: values, places, reasons, events."""

from collections.abc import Iterator

from vrts.debug.evaluating import CannotTell
from vrts.debug.frames import frames
from vrts.debug.scripted.session import Deed, Done, Refusal, Session, nothing
from vrts.debug.scripted.table import help_lines
from vrts.debug.values import Shown, scopes
from vrts.monitor.listings import value_text


def _print(session: Session, rest: str, done: Done) -> None:
    done.value = session.console.value(rest, session.frame())
    done.said.append(value_text(done.value))


def _assert(session: Session, rest: str, done: Done) -> None:
    done.value = session.console.value(rest, session.frame())
    if not isinstance(done.value, float):
        raise Refusal(f"`{rest}` is no number: {value_text(done.value)}")
    if done.value == 0.0:
        raise Refusal(f"`{rest}` does not hold here")
    done.said.append(f"`{rest}` holds")


def _where(session: Session, rest: str, done: Done) -> None:
    done.moved = not rest
    if not rest:
        stack = frames(session.debugger.run, session.debugger.at, process=session.process)
        for frame in stack[1:]:
            span = frame.cause.span
            done.said.append(
                f"called by {frame.cause.program} {frame.cause.step}, line {span.line}"
            )
    session.enter(f"WHERE {rest}".strip(), done)


def _state(session: Session, rest: str, done: Done) -> None:
    nothing(rest, "state")
    for scope in scopes(session.debugger, session.frame()):
        if scope.shown:
            done.said.append(scope.name)
            done.said += [f"  {line}" for line in _rows(scope.shown)]


def _why(session: Session, rest: str, done: Done) -> None:
    try:
        done.tell(session.console.listed("why", rest or None, session.frame()))
    except CannotTell as problem:
        done.said = str(problem).split("\n")
    done.reasons = [line.strip() for line in done.said]


def _who(session: Session, rest: str, done: Done) -> None:
    _asked(session, "who", rest, done)


def _next(session: Session, rest: str, done: Done) -> None:
    if rest.isdecimal():  # the monitor's command: some steps
        session.enter(f"NEXT {rest}", done)
    else:
        _asked(session, "next", rest, done)


def _asked(session: Session, word: str, rest: str, done: Done) -> None:
    done.tell(session.console.listed(word, rest, session.frame()))


def _go(session: Session, rest: str, done: Done) -> None:
    session.console.go(rest)
    done.moved = True


def _events(session: Session, rest: str, done: Done) -> None:
    _table(session, "events", rest, done)


def _calls(session: Session, rest: str, done: Done) -> None:
    _table(session, "calls", rest, done)


def _table(session: Session, name: str, rest: str, done: Done) -> None:
    done.table = session.console.table(name, rest)
    done.said += done.table.says


def _help(session: Session, rest: str, done: Done) -> None:
    found = help_lines(rest.lower())
    if found:
        done.said += found
    else:
        session.enter(f"HELP {rest}", done)


def _rows(shown: tuple[Shown, ...]) -> Iterator[str]:
    for each in shown:
        yield f"{each.name}  {each.value}"
        if each.name.endswith("[]"):
            yield from (f"  {row}" for row in _rows(each.parts))


DEEDS: dict[str, Deed] = {
    "print": _print,
    "assert": _assert,
    "where": _where,
    "state": _state,
    "why": _why,
    "who": _who,
    "next": _next,
    "go": _go,
    "events": _events,
    "calls": _calls,
    "help": _help,
}
