"""Workers fork from one process, do every test once, and what becomes of each is told."""

import subprocess
import sys
from pathlib import Path

from tests.places import ROOT

SETTINGS = """
import contextlib
from tests.workers import Workers

def pytest_configure(config):
    config.pluginmanager.register(
        Workers(2, lambda name: name.split("::")[0], contextlib.nullcontext)
    )
"""
FIRST = """
import os, signal, pytest

def done(name):
    with open("done.txt", "a") as file:
        file.write(f"{name} {os.getpid()}\\n")

@pytest.fixture(scope="session")
def kept():
    yield done("begun")
    done("over")

def test_first(kept):
    done("first")

def test_wrong():
    print("what it printed")
    raise ValueError("wrong")

def test_dies():
    os.kill(os.getpid(), signal.SIGKILL)

@pytest.mark.skip
def test_skipped(): ...

def test_behind(kept):
    done("behind")
"""
SECOND = """
import pytest, warnings

@pytest.fixture(scope="module")
def faulty():
    yield
    raise ValueError("taken away wrongly")

def test_second(faulty):
    warnings.warn("beware")
"""
LAST = """
import pytest

@pytest.fixture(scope="session")
def faulty():
    yield
    raise ValueError("at the very end")

def test_last(faulty): ...
"""


def said(folder: Path, *words: str, **files: str) -> str:
    """Return what pytest says of files of tests in a folder."""
    (folder / "conftest.py").write_text(SETTINGS)
    (folder / "pytest.ini").write_text("[pytest]\naddopts = -q -p no:cacheprovider -p no:asyncio\n")
    for name, text in files.items():
        (folder / f"{name}.py").write_text(text)
    command = [sys.executable, "-c", f"import sys; sys.path.insert(0, {str(ROOT)!r}); {MAIN}"]
    done = subprocess.run(
        [*command, *words], cwd=folder, capture_output=True, text=True, check=False
    )
    return f"{done.stdout}{done.stderr}\nstatus {done.returncode}"


MAIN = "import pytest; sys.exit(pytest.main(sys.argv[1:]))"


def test_every_test_is_done_once_and_told(tmp_path: Path) -> None:
    told = said(tmp_path, test_first=FIRST, test_second=SECOND, test_last=LAST)
    assert "3 failed, 4 passed, 1 skipped, 1 warning, 1 error" in told, told
    assert "FAILED test_first.py::test_wrong - ValueError: wrong" in told
    assert "what it printed" in told
    assert "FAILED test_first.py::test_dies" in told
    assert "its process died" in told
    assert "ERROR test_second.py::test_second - ValueError: taken away wrongly" in told
    assert "ValueError: at the very end" in told
    assert "UserWarning: beware" in told
    assert told.endswith("status 1")
    done = [line.split() for line in (tmp_path / "done.txt").read_text().splitlines()]
    assert [name for name, _ in done] == ["begun", "first", "begun", "behind", "over"]
    assert done[0][1] == done[1][1] != done[2][1], "another worker goes on behind who died"


def test_the_first_failure_ends_all_where_that_is_asked_for(tmp_path: Path) -> None:
    told = said(tmp_path, "-x", test_first=FIRST)
    assert "1 failed, 1 passed" in told, told
    assert "stopping after 1 failures" in told
    done = (tmp_path / "done.txt").read_text().split()[::2]
    assert done == ["begun", "first", "over"], "what it had made is taken away"
