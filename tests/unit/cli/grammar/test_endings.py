"""How calls end that are interrupted, or that write to full and closed places: real processes."""

import errno
import fcntl
import os
import signal
import subprocess
import sys
import termios
import time
from collections.abc import Generator
from contextlib import closing, contextmanager
from pathlib import Path

import click
import pytest

from tests.places import ROOT
from tests.support_pty import Child
from vrts.cli.grammar.ending import run

VRTS = str(Path(sys.prefix) / "bin" / "vrts")
EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SOLUTION = str(EXAMPLE / "solution.v2")
HITS = str(EXAMPLE / "submissions" / "hits-base.v2")
thorough = pytest.mark.thorough
PATIENCE = 60.0  # [s] on a busy machine

needs_full = pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
CALLS = [
    (),
    ("--help",),
    ("help", "grade"),
    ("compile", SOLUTION, "--emit", "ir"),
    pytest.param(("schema", "result"), marks=thorough),
    pytest.param(("verify", HITS, "--quiet"), marks=thorough),
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


@pytest.mark.parametrize("words", CALLS[:4], ids=str)
def test_a_closed_place_is_one_sentence(words: tuple[str, ...]) -> None:
    said = shell(words, ">&-")
    assert said.returncode == 2
    assert said.stderr == "error: cannot write to stdout: bad file descriptor\n"


def test_a_reader_that_leaves_gets_no_word_and_no_false_status() -> None:
    reader, writer = os.pipe()
    os.close(reader)
    said = subprocess.run(
        [VRTS, "explain"], stdout=writer, stderr=subprocess.PIPE, text=True, check=False, cwd=ROOT
    )
    os.close(writer)
    assert (said.returncode, said.stderr) == (141, "")


@pytest.mark.thorough
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
    assert page.read_bytes()[:2] == b"PK"
    assert [path.name for path in tmp_path.iterdir()] == ["run.vrun"]


@pytest.mark.parametrize(
    ("problem", "said"),
    [
        (OSError(errno.EACCES, "Permission denied", "a.v2"), "permission denied: `a.v2`"),
        (OSError(errno.ENAMETOOLONG, "File name too long", "a.v2"), "file name too long: `a.v2`"),
        (OSError(errno.EIO, "Input/output error", "a.v2"), "input/output error: `a.v2`"),
        (OSError(errno.ENOENT, "No such file or directory"), "no such file or directory"),
        (OSError(errno.ENOSPC, "No space left"), "cannot write to stdout: no space left"),
    ],
    ids=str,
)
def test_what_the_system_refuses_is_one_sentence(
    problem: OSError, said: str, capfd: pytest.CaptureFixture[str]
) -> None:
    @click.command()
    def failing() -> None:
        raise problem

    kept, words = os.dup(1), sys.argv
    sys.argv = ["failing"]
    try:
        status = run(failing, "failing")
    finally:
        os.dup2(kept, 1)  # where a stream takes no more, it is forgotten
        os.close(kept)
        sys.argv = words
    assert (status, capfd.readouterr().err) == (2, f"error: {said}\n")


def test_a_working_folder_that_is_gone_is_one_sentence(tmp_path: Path) -> None:
    script = 'cd "$1" && rmdir "$1" && exec "$0"'
    said = subprocess.run(
        ["sh", "-c", script, VRTS, str(tmp_path)], capture_output=True, text=True, check=False
    )
    assert (said.returncode, said.stderr) == (2, "error: the working folder is gone\n")


@pytest.mark.parametrize("words", [("compile",), ("verify", SOLUTION, "--html")], ids=str)
def test_a_name_that_is_too_long_is_one_sentence(words: tuple[str, ...]) -> None:
    said = subprocess.run(
        [VRTS, *words, "a" * 300], capture_output=True, text=True, check=False, cwd=ROOT
    )
    assert said.returncode == 2
    assert said.stderr.startswith("error: ")
    assert said.stderr.endswith("file name too long\n")
    assert said.stderr.count("\n") == 1


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


@contextmanager
def opened_once_read(fifo: Path, process: "subprocess.Popen[str]") -> Generator[None]:
    """Open a pipe to write, when a process has opened it to read: it may also end before that."""
    until = time.monotonic() + PATIENCE
    while True:
        try:
            end = os.open(fifo, os.O_WRONLY | os.O_NONBLOCK)
            break
        except OSError as problem:
            if problem.errno != errno.ENXIO:  # nobody reads it yet
                raise
        assert process.poll() is None, "it has ended, and has not read"
        assert time.monotonic() < until, "it does not read"
        time.sleep(0.01)
    try:
        os.write(end, b" ")
        while not waits_for_more(end, process.pid):
            assert process.poll() is None, "it has ended, and has read too little"
            assert time.monotonic() < until, "it does not go on reading"
            time.sleep(0.01)
        yield
    finally:
        os.close(end)


def waits_for_more(end: int, pid: int) -> bool:
    """Return whether a process has read all of a pipe and sleeps: a signal wakes it then.

    One that comes just before it reads would be seen only when the reading is over.
    """
    left = fcntl.ioctl(end, termios.FIONREAD, bytes(4))
    state = Path(f"/proc/{pid}/stat")
    if any(left):
        return False
    return not state.exists() or state.read_text().rpartition(")")[2].split()[0] == "S"


@pytest.mark.thorough
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
        with opened_once_read(fifo, process):
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
        with closing(Child(["serve", "--add-user", "anna", "--folder", "live"], folder)) as child:
            child.expect("password: ")  # the space comes when nothing is echoed any more
            child.until_it_waits()
            child.send(key)
            child.expect(words)
            assert child.status() == status
