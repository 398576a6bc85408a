"""Gives orders to processes, a few at a time, and ends those that take too much.

What a process could not finish it may try once more, alone, when all others are done: then a loss
is its own, and not that of a busy machine.
"""

import shutil
import signal
import sys
import time
from collections import deque
from collections.abc import Generator, Iterable, Iterator
from pathlib import Path
from typing import Generic, NamedTuple, TypeVar

import psutil

from vrts.base.workers import undisturbed
from vrts.marking.supervise import forked, spawned
from vrts.marking.supervise.forked import ForkedProcess
from vrts.marking.supervise.limits import Limits
from vrts.marking.supervise.outcome import Answer, Loss, Lost, Outcome
from vrts.marking.supervise.spawned import SpawnedProcess
from vrts.marking.supervise.worker import Worker

CAN_FORK = sys.platform == "linux"  # elsewhere loaded libraries do not survive it
_WATCH = 0.05  # [s] between looks at memory and time
_KEPT = 4000  # bytes of each end of a log

Order = TypeVar("Order")
Process = ForkedProcess | SpawnedProcess


class Finished(NamedTuple, Generic[Order]):
    """An order, how it went, and the folder with the files it wrote, which may be emptied."""

    order: Order
    outcome: Outcome
    folder: Path
    seconds: float
    peak: int  # bytes of memory in use, as far as it was seen


class _Running(NamedTuple, Generic[Order]):
    order: Order
    process: Process
    folder: Path
    inherited: int  # bytes of memory it has from the parent


class Supervisor(Generic[Order]):
    """Runs a worker's orders."""

    def __init__(
        self,
        worker: Worker[Order],
        staging: Path,
        *,
        jobs: int = 1,
        limits: Limits | None = None,
        fork: bool = CAN_FORK,
    ) -> None:
        """Take the worker, and a folder on the disk the results go to; nothing is started yet."""
        self._worker = worker
        self._staging = staging
        self._jobs = max(1, jobs)
        self._limits = limits or Limits()
        self._fork = fork
        self._number = 0
        self._running: list[_Running[Order]] = []
        self._ended_for: dict[int, Loss] = {}  # by process, why it was ended
        self._peaks: dict[int, int] = {}
        self._own = psutil.Process()
        self._seen: dict[int, psutil.Process] = {}  # under way; to look each up again takes long

    def run(self, orders: Iterable[Order]) -> Generator[Finished[Order], None, None]:
        """Yield every order once, as it is finished; closing it ends the processes under way."""
        again: deque[Order] = deque()
        try:
            if self._fork:
                self._worker.warm_up()
            for done in self._pool(deque(orders), self._jobs):
                if isinstance(done.outcome, Lost):
                    again.append(done.order)
                else:
                    yield done
                shutil.rmtree(done.folder, ignore_errors=True)
            for done in self._pool(again, 1):
                yield done
                shutil.rmtree(done.folder, ignore_errors=True)
        finally:
            self._end_all()
            self._worker.rest()

    def _pool(self, waiting: deque[Order], jobs: int) -> Iterator[Finished[Order]]:
        while waiting or self._running:
            while waiting and len(self._running) < jobs:
                self._start(waiting.popleft())
            self._wait()
            for running in [r for r in self._running if r.process.ended()]:
                self._running.remove(running)
                yield self._finished(running)
            for running in self._running:
                self._watch(running)

    def _start(self, order: Order) -> None:
        self._number += 1
        folder = self._staging / str(self._number)
        folder.mkdir(parents=True)
        if not self._fork:
            command, data = self._worker.command(order, folder)
            process = SpawnedProcess(command, data, folder, self._limits)
            self._running.append(_Running(order, process, folder, 0))
            return
        inherited = _memory(self._own).private
        with undisturbed():  # who is asked to end meanwhile finds it among those under way
            child = ForkedProcess(lambda: self._worker.work(order, folder), folder, self._limits)
            self._running.append(_Running(order, child, folder, inherited))

    def _wait(self) -> None:
        if self._fork:
            forked.wait([r.process for r in self._running], _WATCH)  # type: ignore[misc]
        else:
            spawned.wait([r.process for r in self._running], _WATCH)  # type: ignore[misc]

    def _watch(self, running: _Running[Order]) -> None:
        process = running.process
        if time.monotonic() - process.started > self._limits.wall_s:
            self._end(process, Loss.WALL)
        try:
            if process.pid not in self._seen:
                self._seen[process.pid] = psutil.Process(process.pid)
            seen = self._seen[process.pid]
            memory, private = _memory(seen)
            cpu = sum(seen.cpu_times()[:2])
        except psutil.Error:
            return  # it is gone: the next look at its answer tells
        self._peaks[process.pid] = max(self._peaks.get(process.pid, 0), memory)
        if private > running.inherited + self._limits.memory:
            self._end(process, Loss.MEMORY)
        if cpu > self._limits.cpu_s + 1.0:  # where the system has no limit of its own
            self._end(process, Loss.TIME)

    def _end(self, process: Process, loss: Loss) -> None:
        self._ended_for.setdefault(process.pid, loss)
        process.kill()

    def _finished(self, running: _Running[Order]) -> Finished[Order]:
        process = running.process
        outcome = self._outcome(process)
        seconds = time.monotonic() - process.started
        self._ended_for.pop(process.pid, None)
        self._seen.pop(process.pid, None)
        peak = max(process.peak, self._peaks.pop(process.pid, 0))
        return Finished(running.order, outcome, running.folder, seconds, peak)

    def _outcome(self, process: Process) -> Outcome:
        loss = self._ended_for.get(process.pid)
        if loss is None and process.answer is not None:
            return Answer(process.answer)
        if loss is None and process.answered_too_much:
            loss = Loss.ANSWER
        if loss is None and process.out_of_memory:
            loss = Loss.MEMORY
        if loss is None and process.signal is not None:
            loss = Loss.TIME if process.signal == _cpu_signal() else Loss.CRASH
        return Lost(loss or Loss.ANSWER, _words(process.log))

    def _end_all(self) -> None:
        for running in self._running:
            running.process.kill()
            while not running.process.ended():
                time.sleep(0.001)
            shutil.rmtree(running.folder, ignore_errors=True)
        self._running.clear()


def _cpu_signal() -> int:
    return int(getattr(signal, "SIGXCPU", 0))


class _Memory(NamedTuple):
    """Of a process, in bytes."""

    resident: int
    private: int  # what it has written; where that is not told, all of it


def _memory(process: psutil.Process) -> _Memory:
    found = process.memory_info()
    return _Memory(int(found.rss), int(found.rss - getattr(found, "shared", 0)))


def _words(log: Path) -> str:
    """Return what is written in a log: its beginning and its end."""
    try:
        data = log.read_bytes()
    except OSError:
        return ""
    if len(data) > 2 * _KEPT:
        data = data[:_KEPT] + b"\n...\n" + data[-_KEPT:]
    return data.decode("utf-8", "replace")
