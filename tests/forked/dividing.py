"""The side of the process that forks: what is left to do, who does it, what became of it."""

import contextlib
import os
import pickle
import selectors
import signal
import sys
import warnings
from collections.abc import Callable, Sequence
from typing import Any, BinaryIO, NamedTuple

import pytest

from tests.forked.groups import Group
from tests.forked.worker import NUMBER, Message, work

PATIENCE_S = 20.0  # for a worker that was told to end


class Child(NamedTuple):
    """A worker."""

    process: int
    said: BinaryIO
    ended: int  # a descriptor that says so


class At:
    """Where a worker is."""

    def __init__(self) -> None:
        """Be nowhere."""
        self.group = -1
        self.test = -1  # of the group
        self.nodeid = ""
        self.location: tuple[str, int | None, str] = ("", None, "")
        self.is_over = False


class Dividing:
    """Workers and what they have to do."""

    def __init__(
        self, session: pytest.Session, todo: Sequence[Group], begin: Callable[[], None]
    ) -> None:
        """Put the numbers of all groups where every worker takes them."""
        self.session, self.todo, self.begin = session, todo, begin
        self.config = session.config
        self.numbers, numbers = os.pipe()
        os.write(numbers, b"".join(i.to_bytes(NUMBER, "big") for i in range(len(todo))))
        os.close(numbers)
        self.children: dict[Child, At] = {}
        self.begun = 0
        self.selector = selectors.DefaultSelector()

    def run(self, count: int) -> None:
        """Run all groups in so many workers."""
        factory: Any = getattr(self.config, "_tmp_path_factory")  # noqa: B009
        factory.getbasetemp()  # the folder of all of them
        try:
            for _ in range(min(count, len(self.todo))):
                self._fork(None)
            while self.children and not self.session.shouldfail:
                self._listen()
        finally:
            self._end()
            self.selector.close()
            os.close(self.numbers)

    def _fork(self, again: tuple[int, int] | None) -> None:
        """Fork a worker, which may go on with a group where another one ended."""
        sys.stdout.flush()
        sys.stderr.flush()
        here, there = os.pipe()
        process = os.fork()
        if process == 0:
            os.close(here)
            self.selector.close()
            for child in self.children:
                child.said.close()
                os.close(child.ended)
            self.begin()
            work(self.session, self.todo, self.numbers, os.fdopen(there, "wb"), self.begun, again)
        os.close(there)
        self.begun += 1
        child = Child(process, os.fdopen(here, "rb", buffering=0), os.pidfd_open(process))
        self.children[child] = At()
        for descriptor in (child.said.fileno(), child.ended):
            self.selector.register(descriptor, selectors.EVENT_READ, child)

    def _listen(self) -> None:
        """Take what workers say next; where all is taken, and it has ended, let one go."""
        ready: dict[Child, set[int]] = {}
        for key, _ in self.selector.select():
            ready.setdefault(key.data, set()).add(key.fd)
        for child, descriptors in ready.items():
            message = heard(child.said) if descriptors != {child.ended} else None
            if message is not None:
                self._take(child, *message)
            else:
                self._bury(child)

    def _take(self, child: Child, what: str, told: Any) -> None:
        """Take what a worker says."""
        at, hook = self.children[child], self.config.hook
        if what == "group":
            at.group, at.test = told
        elif what == "test":
            at.nodeid, at.location = told
            at.test += 1
        elif what == "reports":
            self._tell(at, told)
            at.nodeid = ""
        elif what == "read":  # late
            self.session.testscollected += told
        elif what == "unread":
            hook.pytest_collectreport(
                report=hook.pytest_report_from_serializable(config=self.config, data=told)
            )
        elif what == "warning":
            text, when, nodeid, location = told
            message = warnings.WarningMessage(UserWarning(text), UserWarning, *location)
            hook.pytest_warning_recorded.call_historic(
                kwargs={
                    "warning_message": message,
                    "when": when,
                    "nodeid": nodeid,
                    "location": None,
                }
            )
        elif what == "broken":
            raise RuntimeError(f"a worker broke:\n{told}")
        elif what == "over":
            at.is_over = True

    def _tell(self, at: At, told: Sequence[object]) -> None:
        """Tell what became of a test."""
        hook = self.config.hook
        hook.pytest_runtest_logstart(nodeid=at.nodeid, location=at.location)
        for data in told:
            report = hook.pytest_report_from_serializable(config=self.config, data=data)
            hook.pytest_runtest_logreport(report=report)
        hook.pytest_runtest_logfinish(nodeid=at.nodeid, location=at.location)

    def _bury(self, child: Child) -> None:
        """Let a worker that has ended go; another one does what is left of its group."""
        at = self.children.pop(child)
        for descriptor in (child.said.fileno(), child.ended):
            self.selector.unregister(descriptor)
        child.said.close()
        os.close(child.ended)
        status = os.waitstatus_to_exitcode(os.waitpid(child.process, 0)[1])
        if at.is_over:
            return
        if at.nodeid:
            said = f"a worker ended in the middle of it: exit status {status}"
            report = pytest.TestReport(at.nodeid, at.location, {}, "failed", said, "call")
            data = self.config.hook.pytest_report_to_serializable(config=self.config, report=report)
            self._tell(at, [data])
        self._fork((at.group, at.test + 1) if at.group >= 0 else None)

    def _end(self) -> None:
        """End the workers that are left, and wait for them."""
        for child in self.children:
            with contextlib.suppress(ProcessLookupError):
                os.kill(child.process, signal.SIGINT)
        for child in self.children:
            with selectors.DefaultSelector() as waiting:
                waiting.register(child.ended, selectors.EVENT_READ)
                if not waiting.select(PATIENCE_S):
                    os.kill(child.process, signal.SIGKILL)
            os.waitpid(child.process, 0)
            child.said.close()
            os.close(child.ended)
        self.children.clear()


def heard(said: BinaryIO) -> Message | None:
    """Return what a worker says next; None: it has ended."""
    size = exactly(said, NUMBER)
    content = exactly(said, int.from_bytes(size, "big"))
    return pickle.loads(content) if content else None


def exactly(said: BinaryIO, count: int) -> bytes:
    """Return so many bytes, or none where there is an end before."""
    found = b""
    while len(found) < count:
        more = said.read(count - len(found))
        if not more:
            return b""
        found += more
    return found
