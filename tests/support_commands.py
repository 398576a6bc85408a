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
import json
import os
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import BinaryIO

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
    "vrts.geometry.second",
)
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


def vrts_shown(*words: object, cwd: Path, env: Mapping[str, str] | None = None) -> str:
    """Run a command; return what a terminal would show: both streams as they come."""
    with tempfile.TemporaryFile() as given, tempfile.TemporaryFile() as out:
        _waiting().run(words, cwd, os.environ if env is None else env, given, out, out)
        return _content(out).decode()


def _content(file: BinaryIO) -> bytes:
    file.seek(0)
    return file.read()


class _Waiting:
    """The interpreter that waits, seen from the tests."""

    def __init__(self) -> None:
        self._link, theirs = socket.socketpair()
        self._link.settimeout(PATIENCE)
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tests.support_commands", str(theirs.fileno())],
            cwd=ROOT,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
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
        request = json.dumps([[str(word) for word in words], str(cwd), dict(env)]).encode()
        descriptors = [stream.fileno() for stream in streams]
        socket.send_fds(self._link, [len(request).to_bytes(4, "big")], descriptors)
        self._link.sendall(request)
        answer = self._link.recv(4)
        assert len(answer) == 4, "the waiting interpreter is gone"
        return int.from_bytes(answer, "big", signed=True)

    def end(self) -> None:
        """Let it go."""
        self._link.close()
        self._process.wait(PATIENCE)


@cache
def _waiting() -> _Waiting:
    return _Waiting()


# --- on the other side ----------------------------------------------------------------------------


def _serve(link: socket.socket) -> tuple[list[str], str, dict[str, str]] | None:
    """Fork for each request; return it in the child, and None when there are no more."""
    while True:
        size, descriptors, _, _ = socket.recv_fds(link, 4, 3)
        if not size:
            return None
        request = b""
        while len(request) < int.from_bytes(size, "big"):
            request += link.recv(1 << 16)
        child = os.fork()
        if child == 0:
            link.close()
            for number, descriptor in enumerate(descriptors):
                os.dup2(descriptor, number)
                os.close(descriptor)
            return json.loads(request)
        for descriptor in descriptors:
            os.close(descriptor)
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        link.sendall(status.to_bytes(4, "big", signed=True))


def _main() -> None:
    from vrts.cli.main import main

    for name in LOADED:
        importlib.import_module(name)
    link = socket.socket(fileno=int(sys.argv[1]))
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for words in FIRST:
            sys.argv = ["vrts", *words]
            with contextlib.suppress(SystemExit):
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
