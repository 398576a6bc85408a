"""Commands that make another future, and that go to another one: values, steps, texts, branches."""

from pathlib import Path

from vrts.debug.breakpoints import resolve
from vrts.debug.editing import futures
from vrts.debug.editing.keeping import kept, write_back
from vrts.debug.editing.text import take_up
from vrts.debug.editing.would import would
from vrts.debug.scripted.places import current
from vrts.debug.scripted.session import Deed, Done, Refusal, Session, nothing
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


def _reload(session: Session, rest: str, done: Done) -> None:
    nothing(rest, "reload")
    done.said.append(take_up(session.console, session.debugger))
    done.moved = True


def _branches(session: Session, rest: str, done: Done) -> None:
    nothing(rest, "branches")
    done.said += futures.listed(session.debugger.tree)


def _branch(session: Session, rest: str, done: Done) -> None:
    done.said.append(futures.go_to(session.debugger, session.console, rest))
    done.moved = True


def _undo(session: Session, rest: str, done: Done) -> None:
    nothing(rest, "undo")
    done.said.append(futures.undo(session.debugger, session.console))
    done.moved = True


def _redo(session: Session, rest: str, done: Done) -> None:
    nothing(rest, "redo")
    done.said.append(futures.redo(session.debugger, session.console))
    done.moved = True


def _name(session: Session, rest: str, done: Done) -> None:
    done.said.append(futures.name(session.debugger, rest))


def _compare(session: Session, rest: str, done: Done) -> None:
    done.said += futures.compare(session.debugger, session.console, rest)


def _keep(session: Session, rest: str, done: Done) -> None:
    words = rest.split()
    writes = words[-1:] == ["yes"]
    found = kept(session.debugger.tree, " ".join(words[:-1] if writes else words))
    if not writes:
        done.said += [*found.diff, f"`keep {found.name} yes` writes it"]
        return
    if session.write is None:
        raise Refusal("a script changes no file: `keep` alone shows what would change")
    said = write_back(session.console, session.debugger, found, session.write)
    done.said += [f"written to {Path(found.source.name).name}", said]
    done.moved = True


def _would(session: Session, rest: str, done: Done) -> None:
    done.said += would(session.console, session.debugger, rest)


def _changed(refused: list[str]) -> None:
    if refused:
        raise Refusal(" ".join(refused))


DEEDS: dict[str, Deed] = {
    "set": _set,
    "jump": _jump,
    "answer": _answer,
    "reload": _reload,
    "branches": _branches,
    "branch": _branch,
    "undo": _undo,
    "redo": _redo,
    "name": _name,
    "compare": _compare,
    "keep": _keep,
    "would": _would,
}
