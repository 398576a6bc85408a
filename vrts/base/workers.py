"""The same question asked of many things at once, in forked workers, on as many cores as there are.

The answers come in the order of the things, so nothing that is told depends on the number of cores.
A worker is a fork: it sees the things without a copy being sent, shares what was in memory, and
holds only what it makes itself. None is left behind, however the one that asks ends.
"""

import copyreg
import ctypes
import gc
import os
import pickle
import select
import signal
import sys
import threading
from collections import deque
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import contextmanager, suppress
from multiprocessing import current_process, get_context
from multiprocessing.connection import Connection
from types import MappingProxyType
from typing import Any, Final, NamedTuple, TypeVar

T = TypeVar("T")
R = TypeVar("R")

AHEAD: Final = 4  # things for each worker that may be answered before the first of them is taken
_END = (signal.SIGINT, signal.SIGTERM)
_PR_SET_PDEATHSIG = 1  # [linux/prctl.h]


def _read_only(items: dict[Any, Any]) -> "MappingProxyType[Any, Any]":
    return MappingProxyType(items)


def _items(table: "MappingProxyType[Any, Any]") -> tuple[Any, tuple[dict[Any, Any]]]:
    return _read_only, (dict(table),)


copyreg.pickle(MappingProxyType, _items)  # read-only tables are among the answers


def _nobody(_: str) -> None:
    """Tell nobody."""


class Workers(NamedTuple):
    """How many things are answered at a time, and who is told when a worker is lost."""

    jobs: int = 1
    lost: Callable[[str], None] = _nobody  # a sentence, without a stop

    def answers(self, ask: Callable[[T], R], things: Sequence[T]) -> Generator[R]:
        """Yield the answer for each thing, in their order.

        Where there can be no forks (another system than Linux, or other threads, of which a fork
        may keep a lock for ever, or a worker itself) all is answered here, each when it is wanted.
        What a worker cannot answer, because it was ended or something was raised, is asked again
        here.

        Args:
            ask: What is asked of each; its answer is sent between processes.
            things: Of which.
        """
        jobs = min(self.jobs, len(things))
        if jobs < 2 or not _may_fork():
            yield from map(ask, things)
            return
        crew: list[_Worker] = []
        try:
            gc.freeze()  # what is in memory is shared: a worker does not look through it
            with _undisturbed():  # what is started is known before anything can end this
                self._start(crew, jobs, ask, things)
            gc.unfreeze()
            yield from self._in_order(ask, things, crew)
        finally:
            with _undisturbed():
                for worker in crew:
                    worker.end()

    def _start(
        self, crew: list["_Worker"], jobs: int, ask: Callable[[T], R], things: Sequence[T]
    ) -> None:
        """Start as many as the system lets."""
        try:
            while len(crew) < jobs:
                crew.append(_Worker(ask, things))
        except OSError as problem:
            self.lost(f"only {len(crew)} worker processes could be started: {problem.strerror}")

    def _in_order(
        self, ask: Callable[[T], R], things: Sequence[T], crew: list["_Worker"]
    ) -> Iterator[R]:
        """Hand things out, and yield what comes back in their order."""
        left, most = deque(range(len(things))), AHEAD * len(crew)
        found: dict[int, tuple[R, ...]] = {}  # nothing: it is asked here
        alive = list(crew)
        for k, thing in enumerate(things):
            while k not in found:
                for worker in alive:
                    if worker.has is None and left and left[0] < k + most:
                        worker.give(left.popleft())
                if not alive:
                    found[k] = ()
                    break
                for worker in _ready(alive):
                    number, answer = worker.has, worker.take()
                    assert number is not None
                    found[number] = answer
                    if worker.is_lost:
                        alive.remove(worker)
                        self.lost(worker.words)
            answer = found.pop(k)
            yield answer[0] if answer else ask(thing)


ALONE: Final = Workers()  # everything is answered here


class _Worker:
    """A process that answers one thing after the other."""

    def __init__(self, ask: Callable[[Any], object], things: Sequence[Any]) -> None:
        context = get_context("fork")
        self._ours, theirs = context.Pipe()
        self._process = context.Process(
            target=_work, args=(ask, things, theirs, self._ours, os.getpid()), daemon=True
        )
        self._process.start()
        theirs.close()
        self.has: int | None = None  # the number of the thing it was given
        self.is_lost = False

    def fileno(self) -> int:
        """Return what becomes readable when it answers or ends."""
        return self._ours.fileno()

    @property
    def words(self) -> str:
        """How it was lost."""
        self._process.join()
        code = self._process.exitcode or 0
        how = f"was ended by {signal.Signals(-code).name}" if code < 0 else f"ended with {code}"
        memory = ", as Linux does where memory runs out" if code == -signal.SIGKILL else ""
        return f"a worker process {how}{memory}; what it was at is done again without it"

    def give(self, number: int) -> None:
        """Let it answer a thing."""
        self.has = number
        with suppress(OSError):  # it has ended: `take` says so
            self._ours.send(number)

    def take(self) -> tuple[Any, ...]:
        """Return its answer; nothing: it has none, or is lost."""
        self.has = None
        try:
            return self._ours.recv()  # what our own fork has sent
        except (EOFError, OSError):
            self.is_lost = True
            return ()

    def end(self) -> None:
        """End it at once, and wait until it has ended."""
        self._process.kill()
        self._process.join()
        self._process.close()
        self._ours.close()


def end_with(parent: int) -> bool:
    """Ask Linux to end this process when its parent ends, however that ends.

    Returns:
        False: it has ended already.
    """
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    return os.getppid() == parent or sys.platform != "linux"


def _work(
    ask: Callable[[Any], object],
    things: Sequence[Any],
    asked: Connection,
    others: Connection,
    parent: int,
) -> None:
    """Answer until nobody asks any more; Ctrl-C is for whoever asks."""
    others.close()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, _END)
    if not end_with(parent):
        return
    while True:
        try:
            number: int = asked.recv()
        except EOFError:
            return
        try:
            answer: tuple[object, ...] = (ask(things[number]),)
        except Exception:  # raised again where it is asked again
            answer = ()
        data = pickle.dumps(answer)
        try:
            asked.send_bytes(data)
        except OSError:  # nobody is there any more
            return


def _ready(crew: Sequence[_Worker]) -> list[_Worker]:
    """Wait until some answer or end; return which."""
    return select.select([worker for worker in crew if worker.has is not None], [], [])[0]


def _may_fork() -> bool:
    alone = threading.active_count() == 1
    return sys.platform == "linux" and alone and not current_process().daemon


@contextmanager
def _undisturbed() -> Generator[None]:
    """Let what asks this process to end wait for a moment."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, _END)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
