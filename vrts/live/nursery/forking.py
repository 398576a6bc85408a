"""The nursery itself: loads, forks a session on order, and tells how sessions end.

It has no threads, so its forks hold no lock of anybody's. It ends with its server; the sessions do
not end with it, each of them hears its server by a pipe of its own.
"""

import gc
import os
import select
import signal
import socket
import sys
import tempfile
import traceback
from pathlib import Path
from typing import Final, NoReturn

import msgspec

from vrts.live.nursery.kept import KeptScenes
from vrts.live.nursery.line import ANSWER, BEGUN, ENDED, LONGEST, NOT_BEGUN, STREAMS, Order
from vrts.live.nursery.warming import warm
from vrts.live.session.known import Known
from vrts.live.session.marks.turns import FileTurns, at_once
from vrts.live.session.process import serve as serve_session

FAILED: Final = 1  # exit status
_STATUS: Final = Path("/proc/self/status")


def serve(line: socket.socket) -> int:
    """Fork sessions until the server hangs up; return the exit status."""
    with tempfile.TemporaryDirectory() as folder:
        warm(Path(folder))
    gc.collect()
    gc.freeze()  # what is loaded is not copied by the sessions' garbage collections
    if threads() != 1:
        sys.stderr.write("sessions cannot be forked from a process with threads\n")
        return FAILED
    with tempfile.TemporaryFile() as turns:
        _Nursery(line, turns.fileno()).work()
    return 0


def threads() -> int:
    """Return how many threads this process has, those of libraries too."""
    found = [word for word in _STATUS.read_text().splitlines() if word.startswith("Threads:")]
    return int(found[0].split()[1])


class _Nursery:
    """Knows the sessions that it has forked."""

    def __init__(self, line: socket.socket, turns: int) -> None:
        self._line = line
        self._turns = turns  # descriptor of the file at which sessions have turns
        self._ready = select.poll()
        self._ready.register(line, select.POLLIN)
        self._scenes = KeptScenes()
        self._sessions: dict[int, tuple[int, int]] = {}  # by pidfd: number, process id

    def work(self) -> None:
        """Do what is asked for, and tell who has ended, until nobody listens."""
        while True:
            for readable, _ in self._ready.poll():
                if readable != self._line.fileno():
                    self._bury(readable)
                elif not self._obey():
                    return

    def _obey(self) -> bool:
        """Fork a session, or keep a scene; return False when the server has hung up."""
        try:
            data, streams, _, _ = socket.recv_fds(self._line, LONGEST, STREAMS)
        except ConnectionResetError:
            return False
        if not data:
            return False
        try:
            order = msgspec.json.decode(data, type=Order)
            if order.number:
                self._fork(order, streams)
            else:
                self._scenes.keep(order)
        finally:
            for stream in streams:
                os.close(stream)
        return True

    def _fork(self, order: Order, streams: list[int]) -> None:
        number, known = order.number, self._scenes.of(order)
        try:
            pid = os.fork()
        except OSError as problem:
            self._tell(NOT_BEGUN, number, problem.errno or 0)
            return
        if pid == 0:
            _be_session([*streams, self._turns], known)
        ends = os.pidfd_open(pid)
        self._sessions[ends] = (number, pid)
        self._ready.register(ends, select.POLLIN)
        self._tell(BEGUN, number, pid, ends)

    def _bury(self, ends: int) -> None:
        """Tell how a session has ended."""
        number, pid = self._sessions.pop(ends)
        self._ready.unregister(ends)
        os.close(ends)
        _, status = os.waitpid(pid, 0)
        self._tell(ENDED, number, os.waitstatus_to_exitcode(status))

    def _tell(self, what: int, number: int, about: int, *ends: int) -> None:
        try:
            socket.send_fds(self._line, [ANSWER.pack(what, number, about)], ends)
        except (BrokenPipeError, ConnectionResetError):  # the server is gone, as `work` will see
            return


def _be_session(streams: list[int], known: Known | None) -> NoReturn:
    """Be the process of a session, and never return."""
    status = FAILED
    try:
        os.setsid()
        for number, stream in enumerate(streams):
            os.dup2(stream, number)
        os.closerange(len(streams), os.sysconf("SC_OPEN_MAX"))
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        status = serve_session(0, 1, known=known, turns=FileTurns(STREAMS, at_once()))
    except BaseException:  # whatever it is goes to its errors; the nursery goes on
        traceback.print_exc()
    finally:
        try:
            sys.stderr.flush()
        finally:
            os._exit(status)
