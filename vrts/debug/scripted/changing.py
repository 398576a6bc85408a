"""Commands that make another future: values, the step that comes next, answers."""

from vrts.debug.breakpoints import resolve
from vrts.debug.scripted.places import current
from vrts.debug.scripted.session import Deed, Done, Refusal, Session
from vrts.ir.commands import Answer, GoTo


def _set(session: Session, rest: str, done: Done) -> None:
    name, equals, text = rest.partition("=")
    if not equals or not name.strip() or not text.strip():
        raise Refusal("`set` takes a name and a value: `set x = 5`")
    done.said.append(
        f"{name.strip()} = {session.console.give(name.strip(), text, session.frame())}"
    )


def _jump(session: Session, rest: str, done: Done) -> None:
    done.moved = True
    source, line = session.place(rest)
    found = resolve(session.debugger.run.history.code, source, line)
    if found is None:
        raise Refusal(f"no step of a program follows line {line}")
    cause = session.debugger.run.history.code.causes[min(found.instructions)]
    now = current(session.debugger, process=session.process)
    if now is None or now.program != cause.program:
        raise Refusal("only a step of the program that is being executed can come next")
    _changed(session.debugger.change([GoTo(cause.step, session.process)]))


def _answer(session: Session, rest: str, done: Done) -> None:
    if not session.debugger.asks:
        raise Refusal("the program waits for no line here")
    _changed(session.debugger.change([Answer(rest)]))
    done.moved = True


def _changed(refused: list[str]) -> None:
    if refused:
        raise Refusal(" ".join(refused))


DEEDS: dict[str, Deed] = {
    "set": _set,
    "jump": _jump,
    "answer": _answer,
}
