"""The side of a worker: takes the next group, runs its tests, sends what became of each."""

import atexit
import contextlib
import gc
import os
import pickle
import sys
import tempfile
import traceback
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import Any, BinaryIO, Never, cast

import pytest
from _pytest.unraisableexception import collect_unraisable

from tests.forked.groups import Group

NUMBER = 4  # bytes of a number in a pipe
Message = tuple[str, Any]  # what it is about, and what is said
STATE = "XDG_STATE_HOME"


class Between:
    """Stands for the test that comes next: what was made for the whole session stays."""

    def __init__(self, session: pytest.Session) -> None:
        """Know the session."""
        self.session = session

    def listchain(self) -> list[pytest.Session]:
        """Return what does not end."""
        return [self.session]


class Sending:
    """A plugin of pytest that sends what would be shown."""

    def __init__(self, config: pytest.Config, said: BinaryIO) -> None:
        """Know where to."""
        self.config, self.said = config, said
        self.reports: list[object] = []

    def say(self, what: str, told: object) -> None:
        """Send a message."""
        message = pickle.dumps((what, told))
        self.said.write(len(message).to_bytes(NUMBER, "big") + message)
        self.said.flush()

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Keep what became of a part of a test."""
        self.reports.append(
            self.config.hook.pytest_report_to_serializable(config=self.config, report=report)
        )

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        """Send what could not be read."""
        if report.failed:
            config = self.config
            self.say(
                "unread", config.hook.pytest_report_to_serializable(config=config, report=report)
            )

    def pytest_warning_recorded(
        self, warning_message: warnings.WarningMessage, when: str, nodeid: str
    ) -> None:
        """Send a warning."""
        place = (str(warning_message.filename), warning_message.lineno)
        self.say("warning", (str(warning_message.message), when, nodeid, place))


def work(
    session: pytest.Session,
    todo: Sequence[Group],
    numbers: int,
    said: BinaryIO,
    number: int,
    again: tuple[int, int] | None,
) -> Never:
    """Run groups until there are no more, and end this process.

    Args:
        session: The session, in which all is read.
        todo: All groups.
        numbers: The pipe from which the number of the next one is taken.
        said: The pipe that takes what became of tests.
        number: Of the worker.
        again: A group to begin with, and how many of its tests are done.
    """
    sending = Sending(session.config, said)
    status = 1
    try:
        _be_alone(session.config, sending, number)
        _run_groups(session, todo, numbers, sending, again)
        status = 0
    except KeyboardInterrupt:
        with contextlib.suppress(Exception):  # what can be taken down is
            _take_down(session)
    except BaseException:
        sending.say("broken", traceback.format_exc())
    finally:
        with contextlib.suppress(BaseException):
            atexit._run_exitfuncs()  # pyright: ignore[reportPrivateUsage]
        if status == 0:
            sending.say("over", None)
        os._exit(status)


def _be_alone(config: pytest.Config, sending: Sending, number: int) -> None:
    """Have folders, captured output and a terminal of one's own: none."""
    atexit._clear()  # pyright: ignore[reportPrivateUsage]
    if "multiprocessing.util" in sys.modules:
        atexit.register(sys.modules["multiprocessing.util"]._exit_function)
    main = sys.modules["__main__"]  # which processes that are spawned would load again
    main.__spec__ = None
    vars(main).pop("__file__", None)
    plugins = config.pluginmanager
    plugins.unregister(plugins.get_plugin("terminalreporter"))
    plugins.register(sending, "vrts-sending")
    capturing: Any = plugins.get_plugin("capturemanager")
    capturing.stop_global_capturing()
    capturing.start_global_capturing()
    capturing.suspend_global_capture()
    factory: Any = getattr(config, "_tmp_path_factory")  # noqa: B009
    own: Path = factory.getbasetemp() / f"worker-{number}"
    own.mkdir()
    factory._basetemp = own
    os.environ[STATE] = tempfile.mkdtemp(dir=os.environ[STATE])


def _run_groups(
    session: pytest.Session,
    todo: Sequence[Group],
    numbers: int,
    sending: Sending,
    again: tuple[int, int] | None,
) -> None:
    """Run groups until there are no more."""
    between = cast("pytest.Item", Between(session))
    index, done = again or (_next(numbers), 0)
    while index is not None and not session.shouldfail and not session.shouldstop:
        group = todo[index]
        sending.say("group", (index, done - 1))
        items = group.items
        if group.late:
            items = tuple(session.perform_collect(list(group.late)))
            if not done:
                sending.say("read", len(items))
        for i in range(done, len(items)):
            _run(items[i], items[i + 1] if i + 1 < len(items) else between, sending)
            if session.shouldfail or session.shouldstop:
                break
        index, done = _next(numbers), 0
    _run_last(session, sending)


def _next(numbers: int) -> int | None:
    """Take the number of the next group."""
    taken = os.read(numbers, NUMBER)
    return int.from_bytes(taken, "big") if taken else None


def _run(item: pytest.Item, following: pytest.Item, sending: Sending) -> None:
    """Run a test and send what became of it."""
    sending.say("test", (item.nodeid, item.location))
    item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
    sending.say("reports", sending.reports)
    sending.reports = []


def _run_last(session: pytest.Session, sending: Sending) -> None:
    """End what was made for the whole session; what that says is told as of a test."""

    def last() -> None:
        _take_down(session)
        gc.collect()
        collect_unraisable(session.config)

    try:
        last()
    except Exception:
        place = ("", None, "")
        said = traceback.format_exc()
        told = pytest.TestReport("the end of a worker", place, {}, "failed", said, "teardown")
        sending.say("test", (told.nodeid, told.location))
        sending.pytest_runtest_logreport(told)
        sending.say("reports", sending.reports)


def _take_down(session: pytest.Session) -> None:
    """End what was made for the whole session."""
    state: Any = getattr(session, "_setupstate")  # noqa: B009
    state.teardown_exact(None)
