"""Pytest in a tree of its own, in a child of a process that has loaded the libraries already.

Most patches are noticed by one short test: to start Python and to load pytest and the libraries of
others would cost more than the test. The child loads what is of the tree from the tree.
"""

import gc
import multiprocessing
import os
import sys
from collections.abc import Sequence
from multiprocessing.connection import Connection
from pathlib import Path
from typing import NamedTuple

import pytest

from tests.says_all import SAYS_ALL

PLUGINS = (  # of pytest itself, which it loads when it starts
    *("faulthandler", "helpconfig", "pastebin", "setuponly", "setupplan", "skipping", "stepwise"),
    *("threadexception", "tracemalloc", "unittest", "unraisableexception", "warnings"),
)
LIBRARIES = (
    *("pytest", "hypothesis", "hypothesis.strategies", "_hypothesis_pytestplugin", "xdist"),
    *("numpy", "pinocchio", "coal", "lark", "click", "trimesh"),
    *(
        "anyio.pytest_plugin",
        "asyncio",
        "xdist.plugin",
        "xdist.looponfail",
        "xml.etree.ElementTree",
    ),
    *("pdb", "platformdirs.pytest_plugin", "platformdirs.unix", "readline", "tomllib"),
    *("xdist.newhooks", "xdist.remote", "xdist.scheduler", "xdist.workermanage"),
    *(f"_pytest.{name}" for name in PLUGINS),
)
OURS = ("tests", "vrts")
QUIET = "ignore::pytest.PytestAssertRewriteWarning"  # of plugins that are loaded already


class Outcome:
    """A plugin of pytest that keeps the first test that failed, or could not be begun."""

    def __init__(self) -> None:
        """Know of none."""
        self.first: str | None = None

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Look at what became of a test."""
        if report.failed and self.first is None:
            self.first = report.nodeid

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        """Look at what became of a file."""
        if report.failed and self.first is None:
            self.first = report.nodeid


class Told(NamedTuple):
    """What a child says at its end."""

    status: int | None  # None: it took too long, or died
    first: str | None  # the test that failed first
    cpu_s: float  # of the child, and of the processes that it waited for


def run(tree: Path, words: Sequence[str], seconds: float, said: Path) -> Told:
    """Run pytest in a tree.

    Args:
        tree: The tree.
        words: Its options and tests.
        seconds: How long it may take [s].
        said: The file that takes what is printed.
    """
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(list(LIBRARIES))
    here, there = context.Pipe(duplex=False)
    child = context.Process(target=_pytest, args=(str(tree), list(words), str(said), there))
    child.start()
    there.close()
    try:
        told = Told(*here.recv()) if here.poll(seconds) else Told(None, None, seconds)
    except EOFError:  # it died
        told = Told(None, None, 0.0)
    finally:
        here.close()
        child.join(5.0)
        if child.is_alive():
            child.kill()
            child.join()
    return told


def _pytest(tree: str, words: list[str], said: str, answer: Connection) -> None:
    """Run pytest in this process, which is new, and send what became of it."""
    gc.freeze()  # what is loaded is not gone through, and so not copied
    sys.dont_write_bytecode = False
    os.chdir(tree)
    os.environ["PYTHONPATH"] = tree
    for name in SAYS_ALL:
        os.environ.pop(name, None)
    sys.path.insert(0, tree)
    for name in [name for name in sys.modules if name.split(".")[0] in OURS]:
        del sys.modules[name]
    out = os.open(said, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    os.dup2(out, 1)
    os.dup2(out, 2)
    outcome = Outcome()
    status = pytest.main(["-W", QUIET, *words], plugins=[outcome])
    sys.stdout.flush()
    answer.send((int(status), outcome.first, sum(os.times()[:4])))
    answer.close()
