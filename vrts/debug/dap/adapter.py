"""Requests of a debug client, answered from a run. Nothing executes between two of them.

This is the beginning and the end of a session; what comes between is in `stopping`, `going` and
`seeing`. Specification: the Debug Adapter Protocol, version 1.71.
"""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TypeAlias

from vrts.base.diagnostic import Diagnostic
from vrts.debug.conditions.hearing import Hear, Interrupted, nobody
from vrts.debug.dap.arguments import BadRequest, Fields
from vrts.debug.dap.asking import ASKING
from vrts.debug.dap.capabilities import CAPABILITIES
from vrts.debug.dap.editing import EDITING
from vrts.debug.dap.going import GOING
from vrts.debug.dap.inline import INLINE
from vrts.debug.dap.seeing import SEEING
from vrts.debug.dap.session import Answer, Event, Json, Session
from vrts.debug.dap.showing import SHOWING
from vrts.debug.dap.stopping import STOPPING
from vrts.debug.evaluating import CannotTell
from vrts.debug.opening import Asked, opened, why_not
from vrts.pipeline.files import CannotRead, names_file
from vrts.pipeline.refused import Refused
from vrts.pipeline.where import Where
from vrts.report.screen.text import diagnostic_text

Send: TypeAlias = Callable[[str, Json], None]

_DURING = {**STOPPING, **GOING, **SEEING, **ASKING, **EDITING, **SHOWING, **INLINE}


class Adapter:
    """One client and its session."""

    def __init__(self, send_event: Send, hear: Hear = nobody) -> None:
        """Take what sends an event, its name and its body, and who is heard meanwhile."""
        self._event, self._hear = send_event, hear
        self._session: Session | None = None
        self._launched = Fields(None)
        self.over = False  # the client is gone, or was told to go
        self._handlers: dict[str, Callable[[Fields], Answer]] = {
            "initialize": self._on_initialize,
            "launch": self._on_launch,
            "configurationDone": self._on_configuration_done,
            "restart": self._on_restart,
            "terminate": self._on_terminate,
            "disconnect": self._on_disconnect,
            "cancel": self._on_cancel,
        }

    def answer(self, command: str, arguments: Fields) -> Answer:
        """Carry a request out; return what to answer.

        Raises:
            BadRequest: It cannot be carried out; the text says why.
        """
        handler, during = self._handlers.get(command), _DURING.get(command)
        try:
            if handler is not None:
                return handler(arguments)
            if during is not None:
                return during(self._known, arguments)
        except (CannotTell, CannotRead) as problem:
            raise BadRequest(str(problem)) from problem
        except KeyError as problem:
            raise BadRequest(str(problem.args[0]) if problem.args else "unknown") from problem
        raise BadRequest(f"`{command}` is not supported")

    def gone(self, answer: Answer) -> Sequence[Event]:
        """Go where an answer says that it goes, after it was sent; return what to tell then."""
        if answer.go is None or self._session is None:
            return ()
        session = self._session
        try:
            return session.stopped(answer.go())
        except Interrupted:
            return session.stopped(session.debugger.stop, paused=True)
        except CannotTell as problem:  # it stands where it stood, and the client has to know
            said = ("output", {"category": "important", "output": f"{problem}\n"})
            return [said, *session.stopped(session.debugger.stop, paused=True)]

    @property
    def _known(self) -> Session:
        if self._session is None:
            raise BadRequest("nothing is being debugged: `launch` comes first")
        return self._session

    def _on_initialize(self, a: Fields) -> Answer:
        from_one = a.truth("linesStartAt1", otherwise=True)
        if not from_one or not a.truth("columnsStartAt1", otherwise=True):
            raise BadRequest("lines and columns are counted from 1")
        if (a.optional("pathFormat") or "path") != "path":
            raise BadRequest("files are named by their paths")
        return Answer(CAPABILITIES)

    def _on_launch(self, a: Fields) -> Answer:
        if self._session is not None:
            raise BadRequest("a program is being debugged already")
        self._session, self._launched = self._opened(a), a
        return Answer({}, [("initialized", {})])

    def _on_configuration_done(self, _: Fields) -> Answer:
        session = self._known
        if self._launched.truth("noDebug", otherwise=False):
            return Answer({}, session.over())
        stops_first = self._launched.truth("stopOnEntry", otherwise=True)
        if stops_first:
            return Answer({}, session.stopped(session.debugger.stop))
        return Answer({}, go=session.debugger.go_on)

    def _on_restart(self, a: Fields) -> Answer:
        """Begin again, with the files as they are now."""
        session = self._known
        asked = a.part("arguments")
        if not asked.optional("program"):
            asked = self._launched
        if session.files.stale or _asked(asked) != _asked(self._launched):
            again = self._opened(asked)
            again.take_over(session)
            session = self._session = again
            self._launched = asked
        return Answer({}, session.restarted())

    def _on_terminate(self, _: Fields) -> Answer:
        return Answer({}, [("terminated", {})])

    def _on_disconnect(self, _: Fields) -> Answer:
        self.over = True
        return Answer({})

    def _on_cancel(self, _: Fields) -> Answer:
        """Answer; what was to be cancelled has heard of it by itself."""
        return Answer({})

    def _opened(self, a: Fields) -> Session:
        near = a.number("nearMiss", -1.0)
        try:
            found = opened(_asked(a), near / 1000.0 if near >= 0.0 else None)
        except Refused as refused:
            self._say(_told(refused.diagnostics))
            raise BadRequest(why_not(refused.diagnostics)) from refused
        self._say(_told(found.diagnostics))
        if found.debugger is None or found.console is None:
            raise BadRequest(why_not(found.diagnostics))
        found.debugger.hear = self._hear
        return Session(found.debugger, found.console, found.files)

    def _say(self, text: str) -> None:
        if text:
            self._event("output", {"category": "stderr", "output": text})


def _asked(a: Fields) -> Asked:
    scene = a.optional("scene")
    return Asked(
        program=Path(a.text("program")),
        where=Where(
            scene and _named(scene),
            _path(a.optional("task")),
            _path(a.optional("scenario")),
            _path(a.optional("lab")),
            a.optional("controller"),
        ),
        entry=a.optional("entry"),
        others=tuple(Path(_named(name)) for name in a.texts("with")),
        dialect=a.optional("dialect"),
    )


def _path(text: str | None) -> Path | None:
    return None if text is None else Path(_named(text))


def _named(text: str) -> str:
    """Return the name of a file; `-` is none, since stdin carries the requests."""
    if not names_file(text):
        raise BadRequest(f"`{text}` is no name of a file")
    return text


def _told(diagnostics: Sequence[Diagnostic]) -> str:
    return "".join(f"{diagnostic_text(found, color=False)}\n\n" for found in diagnostics)
