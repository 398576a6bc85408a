"""How calls end that are interrupted, or that write to full and closed places: real processes."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_pty import Child

VRTS = str(Path(sys.prefix) / "bin" / "vrts")
EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SOLUTION = str(EXAMPLE / "solution.v2")
HITS = str(EXAMPLE / "submissions" / "hits-base.v2")
thorough = pytest.mark.thorough
PATIENCE = 60.0  # [s] on a busy machine

needs_full = pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
CALLS = [
    ("--help",),
    ("help", "grade"),
    ("compile", SOLUTION, "--emit", "ir"),
    pytest.param(("schema", "result"), marks=thorough),
    pytest.param(("verify", HITS), marks=thorough),
]


def shell(words: tuple[str, ...], ending: str) -> "subprocess.CompletedProcess[str]":
    """Run a command whose streams a shell arranges; `$?` is that of the command."""
    script = f'set -o pipefail; "$0" "$@" {ending}'
    return subprocess.run(
        ["bash", "-c", script, VRTS, *words], capture_output=True, text=True, check=False, cwd=ROOT
    )


@needs_full
@pytest.mark.parametrize("words", CALLS, ids=str)
def test_a_full_place_is_one_sentence(words: tuple[str, ...]) -> None:
    said = shell(words, ">/dev/full")
    assert said.returncode == 2
    assert said.stderr == "error: cannot write to stdout: no space left on device\n"


@pytest.mark.parametrize("words", CALLS[:3], ids=str)
def test_a_closed_place_is_one_sentence(words: tuple[str, ...]) -> None:
    said = shell(words, ">&-")
    assert said.returncode == 2
    assert said.stderr == "error: cannot write to stdout: bad file descriptor\n"


def test_a_reader_that_leaves_gets_no_word_and_no_false_status() -> None:
    said = shell(("explain",), "| true")
    assert (said.returncode, said.stderr) == (141, "")


@needs_full
def test_words_that_cannot_be_said_leave_a_status() -> None:
    assert shell(("compile", HITS), "2>/dev/full").returncode == 2
    assert shell(("verify", "nowhere.v2"), "2>/dev/full").returncode == 2
    closed = shell(("compile", HITS), "2>&-")
    assert (closed.returncode, closed.stdout, closed.stderr) == (0, "", "")


def test_a_file_never_takes_the_place_of_a_closed_stream(tmp_path: Path) -> None:
    page = tmp_path / "run.vrun"
    said = shell(("run", SOLUTION, "--save", str(page)), "<&- >&- 2>&-")
    assert said.returncode in (0, 2)
    assert not page.exists() or page.read_bytes()[:2] == b"PK"


READING = [  # what reads a file; the file is a pipe that nobody writes to
    ("compile", "{fifo}"),
    pytest.param(("fmt", "{fifo}"), marks=thorough),
    pytest.param(("fix", "{fifo}"), marks=thorough),
    pytest.param(("run", "{fifo}"), marks=thorough),
    ("verify", "{fifo}", "--scene", "cans-on-bases"),
    pytest.param(("why", "{fifo}", "--scene", "cans-on-bases"), marks=thorough),
    pytest.param(("prove", "{fifo}", "--scene", "cans-on-bases"), marks=thorough),
    pytest.param(("view", "{fifo}", "--no-open", "-o", "p.html"), marks=thorough),
    ("monitor", "{fifo}"),
    pytest.param(
        ("validate", SOLUTION, "--scene", "cans-on-bases", "--log", "{fifo}"), marks=thorough
    ),
    ("dispatch", "sign", "{fifo}", "--key", "none"),
    pytest.param(("check-proof", "{fifo}", SOLUTION), marks=thorough),
    pytest.param(("new", "environment", "{fifo}"), marks=thorough),
]


@pytest.mark.parametrize("words", READING, ids=lambda words: words[0])
def test_ctrl_c_is_130(words: tuple[str, ...], tmp_path: Path) -> None:
    fifo = tmp_path / "in.v2"
    os.mkfifo(fifo)
    with subprocess.Popen(
        [VRTS, *(word.format(fifo=fifo) for word in words)],
        cwd=tmp_path,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        with fifo.open("wb"):  # waits until the command has opened it to read
            process.send_signal(signal.SIGINT)
            assert process.wait(PATIENCE) == 130
        assert process.stderr is not None
        said = process.stderr.read()
    assert said.endswith("interrupted\n"), said
    assert "Traceback" not in said


def test_ctrl_c_and_ctrl_d_where_something_is_asked(tmp_path: Path) -> None:
    for key, status, words in (("\x03", 130, "interrupted"), ("\x04", 1, "nothing more was typed")):
        folder = tmp_path / str(status)
        folder.mkdir()
        child = Child(["serve", "--add-user", "anna", "--folder", "live"], folder)
        child.expect("password")
        child.send(key)
        child.expect(words)
        assert child.status() == status
        child.close()
