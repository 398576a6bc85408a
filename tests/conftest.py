"""Settings of every test: the same examples in every run, no limits by the clock; slowest first.

Tests that are thorough (marker `thorough`) run in `python -m tests --all`, where laws are also
tried with all their examples.
"""

import gc
import os
import shutil
import signal
import tempfile
from pathlib import Path

import pytest
from hypothesis import settings
from xdist.scheduler import LoadScopeScheduling

from tests import constants, marked, until
from tests.laws import examples
from tests.times import seconds

BROWSERS = "tests/browser"
TOGETHER = {  # what uses the same: it is made once
    "tests/unit/check/mark/test_earned.py": "tests/golden/test_examples.py",
}

settings.register_profile(
    "vrts", deadline=None, derandomize=True, database=None, max_examples=examples(100)
)
settings.load_profile("vrts")
constants.fix()

gc.disable()  # while tests are read: what they are made of stays

# shells start what is in the background deaf to Ctrl-C, and every process that a test starts
# inherits that: tests that interrupt one would wait for ever
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


_STATE = pytest.StashKey[str]()


def pytest_configure(config: pytest.Config) -> None:
    """Keep keys of logs, which servers of tests make, away from the user's own."""
    config.stash[_STATE] = os.environ["XDG_STATE_HOME"] = tempfile.mkdtemp(prefix="vrts-tests-")


def pytest_unconfigure(config: pytest.Config) -> None:
    """Forget those keys."""
    shutil.rmtree(config.stash[_STATE])


def pytest_addoption(parser: pytest.Parser) -> None:
    """Take the folder of programs that `tests/bench/test_bench_strangers.py` measures."""
    parser.addoption("--strangers", default=None, help="a folder of programs, one for a language")


def group(nodeid: str) -> str:
    """Return what is not divided among workers: a file, so that what it makes is made once.

    All that needs Chromium goes together, and to one Chromium.
    """
    file = nodeid.split("::")[0]
    return BROWSERS if file.startswith(BROWSERS) else TOGETHER.get(file, file)


class InGroups(LoadScopeScheduling):
    """Gives a worker the next group when it has nearly done its last."""

    def _split_scope(self, nodeid: str) -> str:
        return group(nodeid)


@pytest.hookimpl(optionalhook=True)  # without xdist there is nothing to divide
def pytest_xdist_make_scheduler(config: pytest.Config, log: object) -> InGroups:
    """Take groups in the order in which they were collected."""
    config.option.loadscopereorder = False
    return InGroups(config, log)  # pyright: ignore[reportArgumentType]


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Look into no file that cannot hold what is asked for."""
    if collection_path.suffix != ".py" or config.args_source is pytest.Config.ArgsSource.ARGS:
        return None
    return None if marked.may_hold(config.option.markexpr, collection_path) else True


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Put the slowest group first, by what was measured; laws with all examples are thorough.

    Files that are named keep their order.
    """
    marked.mark_laws(items)
    if config.args_source is pytest.Config.ArgsSource.ARGS:
        return
    if until.limit() is not None:
        order = until.shuffled(dict.fromkeys(group(item.nodeid) for item in items))
        places = {name: place for place, name in enumerate(order)}
        items.sort(key=lambda item: places[group(item.nodeid)])
        return
    known = seconds()
    lasts: dict[str, float] = {}
    for item in items:
        lasts.setdefault(group(item.nodeid), 0.0)
    for file, wall in known.items():
        if group(file) in lasts:
            lasts[group(file)] += wall
    items.sort(key=lambda item: -lasts[group(item.nodeid)])


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup() -> None:
    """Begin no test when its time is over."""
    until.skip_if_over()


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Say how many tests were not begun."""
    number = until.left_out(terminalreporter.stats.get("skipped", []))
    if number:
        terminalreporter.write_line(f"{until.REASON}: {number} tests not tried")


def pytest_sessionstart(session: pytest.Session) -> None:
    """Let the process that divides tests among workers collect garbage: it reads none itself."""
    if session.config.pluginmanager.hasplugin("dsession"):
        gc.enable()


def pytest_collection_finish() -> None:
    """Let the collector of garbage look less often, and not at what stays: tests and modules."""
    gc.enable()
    gc.collect()
    gc.freeze()
    gc.set_threshold(50_000, 20, 50)
