"""Requests of ours about changed texts and futures: `vrts/edit`, `vrts/branches` and the like.

What is typed at the debug console, the terminal and in scripts is the same: `TYPED`.
"""

from collections.abc import Callable, Mapping
from pathlib import Path

from vrts.debug.dap.arguments import BadRequest, Fields
from vrts.debug.dap.session import Answer, Event, Json, Session
from vrts.debug.editing import futures
from vrts.debug.editing.keeping import Kept, kept
from vrts.debug.editing.text import take_up
from vrts.debug.editing.would import would
from vrts.debug.scripted.changing import DEEDS
from vrts.debug.scripted.commander import carry_out
from vrts.debug.scripted.session import Session as Commands

TYPED = frozenset(DEEDS) - {"set", "jump", "answer"}  # which the protocol and the console have


def typed(session: Session, text: str) -> str | None:
    """Carry out a command about futures; None where it is none."""
    if text.split()[:1] == [] or text.split()[0].lower() not in TYPED or "=" in text:
        return None
    done = carry_out(Commands(session.debugger, session.console), text)
    return "\n".join(done.said)


def _edit(session: Session, a: Fields) -> Answer:
    """Go on with another text: that of the arguments, or the files as they are now."""
    text = a.optional("text")
    name = a.optional("path")
    if text is not None and name is None:
        raise BadRequest("`path` says which text it is")
    sent = None if text is None else {str(Path(name or "").resolve()): text}
    said = take_up(session.console, session.debugger, sent)
    return Answer({"said": said, **_where(session)}, _went(session))


def _branches(session: Session, _: Fields) -> Answer:
    tree = session.debugger.tree
    rows: list[Json] = [
        {
            "number": branch.number,
            "parent": branch.parent,
            "name": branch.name,
            "by": branch.by.value,
            "words": branch.words,
            "time": branch.forked.time_s,
            "current": branch.number == tree.number,
        }
        for branch in tree.branches
    ]
    return Answer({"branches": rows})


def _branch(session: Session, a: Fields) -> Answer:
    said = futures.go_to(session.debugger, session.console, a.text("name"))
    return Answer({"said": said, **_where(session)}, _went(session))


def _undo(session: Session, _: Fields) -> Answer:
    said = futures.undo(session.debugger, session.console)
    return Answer({"said": said, **_where(session)}, _went(session))


def _redo(session: Session, _: Fields) -> Answer:
    said = futures.redo(session.debugger, session.console)
    return Answer({"said": said, **_where(session)}, _went(session))


def _name(session: Session, a: Fields) -> Answer:
    return Answer({"said": futures.name(session.debugger, a.text("name"))})


def _compare(session: Session, a: Fields) -> Answer:
    asked = f"{a.text('one')} {a.text('other')}"
    return Answer({"rows": futures.compare(session.debugger, session.console, asked)})


def _keep(session: Session, a: Fields) -> Answer:
    """Return the edits that write a value back to its literal: the client carries them out."""
    found = kept(session.debugger.tree, a.optional("name") or "")
    return Answer({"name": found.name, "diff": found.diff, "edits": _edits(found)})


def _would(session: Session, a: Fields) -> Answer:
    """Return which value of a variable, or of a line, would earn the full mark."""
    line = a.whole("line", 0)
    asked = str(line) if line else a.text("name")
    return Answer({"said": "\n".join(would(session.console, session.debugger, asked))})


def _edits(found: Kept) -> list[Json]:
    """Return edits as an editor takes them: lines and columns from 1."""
    source = found.source
    return [
        {
            "path": source.name,
            "line": edit.span.line,
            "column": edit.span.column,
            "endLine": source.line_of(edit.span.end),
            "endColumn": source.column_of(edit.span.end),
            "text": edit.replacement,
        }
        for edit in found.edits
    ]


def _where(session: Session) -> Json:
    return {"time": session.debugger.at.time_s, "branch": session.debugger.tree.current.label}


def _went(session: Session) -> list[Event]:
    """Return what tells a client that texts, values and places may all be others."""
    wishes = session.debugger.wishes.lines
    session.lines = {name: [p for p in wishes if p.source == name] for name in session.lines}
    going: Event = ("continued", {"threadId": 1, "allThreadsContinued": True})
    return [*session.moved(), going, *session.stopped(session.debugger.stop)]


EDITING: Mapping[str, Callable[[Session, Fields], Answer]] = {
    "vrts/edit": _edit,
    "vrts/branches": _branches,
    "vrts/branch": _branch,
    "vrts/undo": _undo,
    "vrts/redo": _redo,
    "vrts/name": _name,
    "vrts/compare": _compare,
    "vrts/keep": _keep,
    "vrts/would": _would,
}
