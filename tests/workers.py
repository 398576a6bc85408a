"""Tests in several processes that fork from one, which has read all tests: `pytest --workers 4`.

To read the tests, and to compile and load what they are about, takes longer than most files of
tests. So it is done once. A worker takes the next group of tests when it has done its last, and
says what became of each; a group is never divided. Who dies is told as a failed test, and another
goes on behind that test.
"""

import atexit
import contextlib
import os
import signal
import sys
import traceback
import warnings
import weakref
from collections.abc import Callable
from contextlib import AbstractContextManager
from multiprocessing import Pipe
from multiprocessing.connection import Connection, wait
from typing import NamedTuple, cast

import pytest
from _pytest.capture import CaptureManager

GROUP = 4  # bytes of the number of a group
MOST = 10_000  # groups: their numbers fit in a pipe that nobody reads yet


class Between:
    """What is said to come next where a group ends: its fixtures go, those of the session stay."""

    def __init__(self, session: pytest.Session) -> None:
        """Remember the session."""
        self.session = session

    def listchain(self) -> list[pytest.Session]:
        """Return what stays."""
        return [self.session]


class Worker(NamedTuple):
    """A process that runs tests."""

    pid: int
    ended: int  # a descriptor that can be read when it has ended
    said: Connection

    def forget(self) -> None:
        """Let the process go that has ended, or is about to."""
        os.waitpid(self.pid, 0)
        os.close(self.ended)
        self.said.close()


class At(NamedTuple):
    """A place among the tests: a group, and the number of a test in it."""

    group: int
    number: int


class Workers:
    """The plugin of pytest that runs tests in workers."""

    def __init__(
        self,
        number: int,
        group: Callable[[str], str],
        alone: Callable[[], AbstractContextManager[None]],
    ) -> None:
        """Take how many there are.

        Args:
            number: How many.
            group: To which group a test belongs, by its name.
            alone: What each worker has for itself.
        """
        self._number = number
        self._group = group
        self._alone = alone
        self._groups: list[list[pytest.Item]] = []
        self._waiting = -1  # the pipe from which workers take numbers of groups
        self._at: dict[int, At] = {}  # by process: the test that it runs
        self._broken = ""  # what a worker said of its end

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool | None:
        """Run the tests."""
        if session.testsfailed or session.config.option.collectonly:
            return None  # as pytest has it
        groups: dict[str, list[pytest.Item]] = {}
        for item in session.items:
            groups.setdefault(self._group(item.nodeid), []).append(item)
        self._groups = list(groups.values())
        assert len(self._groups) <= MOST
        self._waiting, giving = os.pipe()
        for number in range(len(self._groups)):
            os.write(giving, number.to_bytes(GROUP, "big"))
        os.close(giving)
        running: list[Worker] = []
        try:
            running += [self._begin(session) for _ in range(min(self._number, len(groups)))]
            while running:
                self._listen(session, running)
        except BaseException:
            for worker in running:
                os.kill(worker.pid, signal.SIGINT)
            raise
        finally:
            for worker in running:
                worker.forget()
            os.close(self._waiting)
        return True

    def _listen(self, session: pytest.Session, running: list[Worker]) -> None:
        """Hear what workers say next, and whether they have ended."""
        ready = set(wait([*(w.said for w in running), *(w.ended for w in running)]))
        for worker in list(running):
            if not {worker.said, worker.ended} & ready:
                continue
            with contextlib.suppress(EOFError):
                while worker.said.poll():
                    self._hear(session, worker)
            if worker.ended in ready:
                running.remove(worker)
                worker.forget()
                if worker.pid in self._at:  # in the midst of a test
                    at = self._at.pop(worker.pid)
                    self._tell_of_death(session, at)
                    running.append(self._begin(session, At(at.group, at.number + 1)))
            if session.shouldfail:
                raise session.Failed(session.shouldfail)
            if session.shouldstop:
                raise session.Interrupted(session.shouldstop)

    def _hear(self, session: pytest.Session, worker: Worker) -> None:
        """Take one message."""
        what, *told = cast("tuple[str, object]", worker.said.recv())
        if what == "at":
            self._at[worker.pid] = At(*cast("tuple[int, int]", told[0]))
        elif what == "over":
            self._at.pop(worker.pid, None)
        elif what == "broken":
            self._broken = cast("str", told[0])
        else:
            _tell(session, what, told)

    def _tell_of_death(self, session: pytest.Session, at: At) -> None:
        item = self._groups[at.group][at.number]
        text = self._broken or "its process died"
        self._broken = ""
        report = pytest.TestReport(item.nodeid, item.location, {}, "failed", text, "call")
        session.config.hook.pytest_runtest_logreport(report=report)

    def _begin(self, session: pytest.Session, at: At | None = None) -> Worker:
        """Fork a worker, which goes on at a test if one is named."""
        captured = session.config.pluginmanager.getplugin("capturemanager")
        assert isinstance(captured, CaptureManager)
        captured.read_global_capture()  # what nobody wants is not said by each of them
        sys.stdout.flush()
        sys.stderr.flush()
        here, there = cast("tuple[Connection, Connection]", Pipe(duplex=False))
        pid = os.fork()
        if pid:
            there.close()
            return Worker(pid, os.pidfd_open(pid), here)
        status = 1
        try:
            here.close()
            for kept in list(vars(weakref.finalize)["_registry"]):
                kept.atexit = False  # what was made before belongs to the process before
            captured.stop_global_capturing()
            captured.start_global_capturing()
            with self._alone():
                self._work(session, there, at)
            status = 0
        except BaseException:
            there.send(("broken", traceback.format_exc()))
            raise
        finally:
            atexit._run_exitfuncs()  # pyright: ignore[reportPrivateUsage]
            os._exit(status)

    def _work(self, session: pytest.Session, link: Connection, at: At | None) -> None:
        """Run groups of tests as a worker, until there are no more."""
        plugins = session.config.pluginmanager
        plugins.unregister(self)
        plugins.unregister(name="terminalreporter")
        saying = Saying(session.config)
        plugins.register(saying)  # which tells it of warnings of before
        saying.link = link
        try:
            while True:
                if at is None:
                    taken = os.read(self._waiting, GROUP)
                    if not taken:
                        break
                    at = At(int.from_bytes(taken, "big"), 0)
                items = [*self._groups[at.group], Between(session)]
                for number in range(at.number, len(items) - 1):
                    link.send(("at", (at.group, number)))
                    session.config.hook.pytest_runtest_protocol(
                        item=items[number], nextitem=items[number + 1]
                    )
                at = None
        finally:
            session._setupstate.teardown_exact(None)  # pyright: ignore[reportPrivateUsage]
        link.send(("over",))


class Saying:
    """The plugin of a worker that says what becomes of its tests."""

    def __init__(self, config: pytest.Config) -> None:
        """Say nothing yet."""
        self._config = config
        self.link: Connection | None = None  # where to

    def _say(self, *what: object) -> None:
        if self.link is not None:
            self.link.send(what)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Say what became of a test, or of its fixtures."""
        data = self._config.hook.pytest_report_to_serializable(config=self._config, report=report)
        self._say("report", data)

    def pytest_runtest_logfinish(self, nodeid: str, location: tuple[str, int | None, str]) -> None:
        """Say that a test is over."""
        self._say("finish", nodeid, location)

    def pytest_warning_recorded(
        self,
        warning_message: warnings.WarningMessage,
        when: str,
        nodeid: str,
        location: tuple[str, int, str] | None,
    ) -> None:
        """Say that somebody was warned."""
        text = f"{warning_message.category.__name__}: {warning_message.message}"
        said = text, warning_message.filename, warning_message.lineno
        self._say("warning", said, when, nodeid, location)


def _tell(session: pytest.Session, what: str, told: list[object]) -> None:
    """Tell pytest what a worker said, as if it had happened here."""
    hook = session.config.hook
    if what == "report":
        report = hook.pytest_report_from_serializable(config=session.config, data=told[0])
        hook.pytest_runtest_logreport(report=report)
    elif what == "finish":
        hook.pytest_runtest_logfinish(nodeid=told[0], location=told[1])
    else:
        text, file, line = cast("tuple[str, str, int]", told[0])
        message = warnings.WarningMessage(UserWarning(text), UserWarning, file, line)
        hook.pytest_warning_recorded.call_historic(
            kwargs={
                "warning_message": message,
                "when": told[1],
                "nodeid": told[2],
                "location": told[3],
            }
        )
