"""`vrts` as a process of its own, without the time that an interpreter takes to start.

An interpreter that has imported everything waits beside each worker of pytest and forks for each
command, which has its own standard streams, folder, environment and exit status, as if typed.
What belongs to a start is not shown so (what it loads, hash seeds, terminals, signals): tests of
that start Python.
"""

import atexit
import contextlib
import gc
import importlib
import io
import json
import os
import select
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import BinaryIO, TextIO

from tests.places import ROOT

PATIENCE = 300.0  # [s] on a busy machine
EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SOLUTION = str(EXAMPLE / "solution.v2")
FIRST = (  # what is run in an empty folder before anything is asked, so that it is loaded
    ("verify", SOLUTION, "--html", "page.html"),
    ("task", "check", str(EXAMPLE)),
    ("run", SOLUTION, "--scene", "cans-on-bases", "--save", "run.vrun"),
)
LOADED = (
    "vrts.cli.authoring.new_command",
    "vrts.cli.grade.grade_command",
    "vrts.cli.grade.mark_command",
    "vrts.assignments.task_folder",
    "vrts.geometry.proposing.by_coal",
    "vrts.debug.dap.serving",
    "vrts.live.serving",
    "vrts.live.teaching",
)
EDITORS = "vrts.lsp.server.serving"
Said = subprocess.CompletedProcess[str]
Written = subprocess.CompletedProcess[bytes]


def vrts(
    *words: object, cwd: Path = ROOT, stdin: bytes = b"", env: Mapping[str, str] | None = None
) -> Written:
    """Run a command; `env` is the whole environment."""
    with (
        tempfile.TemporaryFile() as given,
        tempfile.TemporaryFile() as out,
        tempfile.TemporaryFile() as err,
    ):
        given.write(stdin)
        given.seek(0)
        status = _waiting().run(words, cwd, os.environ if env is None else env, given, out, err)
        return Written(["vrts", *map(str, words)], status, _content(out), _content(err))


def vrts_text(
    *words: object, cwd: Path = ROOT, stdin: str = "", env: Mapping[str, str] | None = None
) -> Said:
    """Run a command whose streams are text."""
    found = vrts(*words, cwd=cwd, stdin=stdin.encode(), env=env)
    return Said(found.args, found.returncode, found.stdout.decode(), found.stderr.decode())


def vrts_shown(
    *words: object, cwd: Path, env: Mapping[str, str] | None = None, stdin: bytes = b""
) -> str:
    """Run a command; return what a terminal would show: both streams as they come."""
    with tempfile.TemporaryFile() as given, tempfile.TemporaryFile() as out:
        given.write(stdin)
        given.seek(0)
        _waiting().run(words, cwd, os.environ if env is None else env, given, out, out)
        return _content(out).decode()


class Begun:
    """A command that has begun, as subprocess.Popen shows one."""

    def __init__(self, *words: object, talks: bool = False) -> None:
        """Begin a command in the folder of the tests.

        What `talks` has pipes for stdin and stdout, of bytes, and the tests' stderr; all else
        has a pipe for stderr, of text.
        """
        self.stdin: BinaryIO | None = None
        self.stdout: BinaryIO | None = None
        self.stderr: TextIO | None = None
        self.returncode: int | None = None
        nothing = os.open(os.devnull, os.O_RDWR)
        if talks:
            given, theirs_in = os.pipe()
            theirs_out, said = os.pipe()
            self.stdin, self.stdout = os.fdopen(theirs_in, "wb"), os.fdopen(theirs_out, "rb")
            streams = (given, said, 2)
        else:
            told, said = os.pipe()
            self.stderr = os.fdopen(told, encoding="utf-8")
            streams = (nothing, nothing, said)
        self.pid = _waiting().begin(words, Path.cwd(), os.environ, *streams)
        self._ended = os.pidfd_open(self.pid)
        for stream in {nothing, *streams} - {2}:
            os.close(stream)

    def poll(self) -> int | None:
        """Return the exit status, if there is one."""
        if self.returncode is None and select.select([self._ended], [], [], 0.0)[0]:
            self._reap()
        return self.returncode

    def wait(self, timeout: float | None = None) -> int:
        """Wait for the end; return the exit status."""
        if self.returncode is None and not select.select([self._ended], [], [], timeout)[0]:
            raise subprocess.TimeoutExpired("vrts", timeout or 0.0)
        return self._reap()

    def send_signal(self, number: int) -> None:
        """Send a signal, unless it has ended."""
        if self.poll() is None:
            os.kill(self.pid, number)

    def kill(self) -> None:
        """Kill -9."""
        self.send_signal(signal.SIGKILL)

    def _reap(self) -> int:
        if self.returncode is None:
            self.returncode = _waiting().reap(self.pid)
            os.close(self._ended)
        return self.returncode


def _content(file: BinaryIO) -> bytes:
    file.seek(0)
    return file.read()


class Waiting:
    """The interpreter that waits, seen from the tests."""

    def __init__(self, *modules: str) -> None:
        """Start it; with modules it loads these alone, and runs no command first."""
        self._asking = threading.Lock()
        self._link, theirs = socket.socketpair()
        self._link.settimeout(PATIENCE)
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tests.support_commands", str(theirs.fileno()), *modules],
            cwd=ROOT,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            pass_fds=[theirs.fileno()],
        )
        theirs.close()
        atexit.register(self.end)

    def run(
        self,
        words: tuple[object, ...],
        cwd: Path,
        env: Mapping[str, str],
        *streams: BinaryIO,
    ) -> int:
        """Run a command; return its exit status."""
        return self._ask("reap", self.begin(words, cwd, env, *(s.fileno() for s in streams)))

    def begin(
        self, words: tuple[object, ...], cwd: Path, env: Mapping[str, str], *streams: int
    ) -> int:
        """Begin a command; return its process."""
        told = [[str(word) for word in words], str(cwd), dict(env)]
        return self._ask("begin", *told, streams=streams)

    def reap(self, process: int) -> int:
        """Wait for the end of a process; return its exit status."""
        return self._ask("reap", process)

    def _ask(self, *words: object, streams: tuple[int, ...] = ()) -> int:
        request = json.dumps(words).encode()
        with self._asking:  # whoever drives servers in threads asks from there
            socket.send_fds(self._link, [len(request).to_bytes(4, "big")], streams)
            self._link.sendall(request)
            answer = self._link.recv(4)
        assert len(answer) == 4, "the waiting interpreter is gone"
        return int.from_bytes(answer, "big", signed=True)

    def end(self) -> None:
        """Let it go."""
        self._link.close()
        self._process.wait(PATIENCE)


@cache
def _waiting() -> Waiting:
    return Waiting()


@cache
def waiting_for_editors() -> Waiting:
    """Return an interpreter that has loaded the language server, and nothing that is heavy."""
    return Waiting(EDITORS)


# --- on the other side ----------------------------------------------------------------------------


def _serve(link: socket.socket) -> tuple[list[str], str, dict[str, str]] | None:
    """Fork for each command; return it in the child, and None when there are no more."""
    while True:
        size, descriptors, _, _ = socket.recv_fds(link, 4, 3)
        if not size:
            return None
        request = b""
        while len(request) < int.from_bytes(size, "big"):
            request += link.recv(1 << 16)
        what, *told = json.loads(request)
        if what == "reap":
            answer = os.waitstatus_to_exitcode(os.waitpid(told[0], 0)[1])
        elif (answer := os.fork()) == 0:
            link.close()
            for number, descriptor in enumerate(descriptors):
                os.dup2(descriptor, number)
                os.close(descriptor)
            words, folder, environment = told
            return words, folder, environment
        for descriptor in descriptors:
            os.close(descriptor)
        link.sendall(answer.to_bytes(4, "big", signed=True))


def _main() -> None:
    from vrts.cli.main import main

    link, chosen = socket.socket(fileno=int(sys.argv[1])), sys.argv[2:]
    for name in chosen or LOADED:
        importlib.import_module(name)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for words in () if chosen else FIRST:
            sys.argv = ["vrts", *words]
            with contextlib.suppress(SystemExit), contextlib.redirect_stderr(io.StringIO()):
                main()
        os.chdir(ROOT)
    gc.collect()
    gc.freeze()  # collections in the children write to no page that they share
    request = _serve(link)
    if request is not None:
        words, folder, environment = request
        os.environ.clear()
        os.environ.update(environment)
        time.tzset()
        os.chdir(folder)
        sys.argv = ["vrts", *words]
        sys.path[0] = folder
        main()


if __name__ == "__main__":
    _main()
