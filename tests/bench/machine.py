"""How late the machine itself is, and how much of it others use: the control of a benchmark."""

import multiprocessing
import os
import time
from multiprocessing.connection import Connection
from pathlib import Path
from typing import NamedTuple

import psutil

from tests.support_live import session_processes

PERIOD = 0.020  # [s] between wake-ups
TICKS = os.sysconf("SC_CLK_TCK")


class Lateness(NamedTuple):
    """By how much somebody who sleeps 20 ms at a time wakes too late [ms]."""

    p50: float
    p95: float
    p99: float


class Metronome:
    """A process that does nothing but sleep and look how late it wakes."""

    def __init__(self) -> None:
        context = multiprocessing.get_context("spawn")
        self._ours, theirs = context.Pipe()
        self._process = context.Process(target=_beat, args=(theirs,))
        self._process.start()
        self._ours.recv()

    def __enter__(self) -> "Metronome":
        return self

    def __exit__(self, *_: object) -> None:
        self._ours.send("end")
        self._process.join()

    def so_far(self) -> Lateness:
        """Return how late it was since it was asked last."""
        self._ours.send("tell")
        return Lateness(*self._ours.recv())


def _beat(pipe: Connection) -> None:
    pipe.send("begun")
    late: list[float] = [0.0]
    due = time.monotonic()
    while True:
        due = max(due + PERIOD, time.monotonic())
        if pipe.poll(max(due - time.monotonic(), 0.0)):
            if pipe.recv() == "end":
                return
            late.sort()
            pipe.send([1e3 * late[int(share * len(late))] for share in (0.5, 0.95, 0.99)])
            late = [0.0]
        else:
            late.append(time.monotonic() - due)


class Used(NamedTuple):
    """Processor time so far [s]."""

    at_s: float
    server: float
    sessions: float  # and their checks of contacts
    all: float  # the whole machine

    def since(self, before: "Used") -> "Used":
        """Return shares of one core since then."""
        passed = self.at_s - before.at_s
        shares = (b - a for a, b in zip(before[1:], self[1:], strict=True))
        return Used(passed, *(share / passed for share in shares))


def used(server: psutil.Process) -> Used:
    """Return what was used so far."""
    own = server.cpu_times()
    sessions = 0.0
    for child in session_processes(server.pid):
        times = child.cpu_times()
        sessions += times.user + times.system + times.children_user + times.children_system
    words = Path("/proc/stat").read_text().splitlines()[0].split()[1:]
    user, nice, system, _, _, irq, softirq, steal = map(int, words[:8])
    busy = (user + nice + system + irq + softirq + steal) / TICKS
    return Used(time.monotonic(), own.user + own.system, sessions, busy)
