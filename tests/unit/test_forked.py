"""Tests divided among forked workers: all are told of, whatever becomes of a worker."""

import os
import re
import subprocess
import sys
from pathlib import Path

from tests.forked.groups import is_late
from tests.places import ROOT

TESTS = """
import os
import signal
import pytest

@pytest.fixture(scope="session")
def made():
    yield os.getpid()
    raise ValueError("at the end of all")

def test_in_a_worker(made):
    assert os.environ["BEGAN"] == str(os.getppid())

def test_that_fails():
    print("what it said")
    assert False

def test_that_ends_its_worker():
    os.kill(os.getpid(), signal.SIGKILL)

@pytest.mark.parametrize("number", range(3))
def test_that_comes_after_it(made, number):
    assert os.environ["BEGAN"] == str(os.getppid())

def test_without_its_fixture(unknown):
    pass

def test_that_is_skipped():
    pytest.skip("reason")
"""
BEGAN = """
import os
os.environ["BEGAN"] = str(os.getpid())
"""
LATE = """
import rerun
import os

READ_BY = os.getpid()

def test_read_by_the_worker_that_runs_it():
    assert os.getpid() == READ_BY
    assert str(READ_BY) != os.environ["BEGAN"]
"""


def forked(home: Path, *words: str) -> "subprocess.CompletedProcess[str]":
    command = [sys.executable, "-m", "pytest", "-c", str(ROOT / "pyproject.toml")]
    options = ["--rootdir", str(home), "-p", "tests.conftest", "-p", "no:xdist", "--forked=2"]
    return subprocess.run(
        [*command, *options, *words],
        cwd=home,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
    )


def test_all_are_told_of(tmp_path: Path) -> None:
    (tmp_path / "conftest.py").write_text(BEGAN)
    (tmp_path / "test_some.py").write_text(TESTS)
    (tmp_path / "test_late.py").write_text(LATE)
    said = forked(tmp_path, ".")
    assert said.returncode == 1
    last = said.stdout.splitlines()[-1]
    assert re.match(r"2 failed, 5 passed, 1 skipped, 2 errors in", last), said.stdout + said.stderr
    failed = set(
        re.findall(r"^(?:FAILED|ERROR) (?:.*::)?(.+?)(?: - .*)?$", said.stdout, re.MULTILINE)
    )
    assert failed == {
        "test_that_fails",
        "test_that_ends_its_worker",
        "test_without_its_fixture",
        "the end of a worker",
    }
    assert "what it said" in said.stdout
    assert "a worker ended in the middle of it: exit status -9" in said.stdout
    assert "ValueError: at the end of all" in said.stdout


def test_what_starts_threads_is_read_late(tmp_path: Path) -> None:
    late = tmp_path / "test_late.py"
    for text, expected in (("import rerun as rr\n", True), ("# import rerun\n", False)):
        late.write_text(text)
        assert is_late(late) is expected
    late.write_text("def test_it(): import rerun\n")
    assert not is_late(late)
    hidden = tmp_path / "test_hidden.py"
    hidden.write_text("__import__('rerun')\ndef test_it(): ...\n")
    said = forked(tmp_path, "test_hidden.py")
    assert said.returncode == 4
    assert "loads rerun and is not read late" in said.stderr
