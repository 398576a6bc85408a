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
import traceback
from collections import deque
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import contextmanager, suppress
from types import MappingProxyType
from typing import Any, Final, Generic, NamedTuple, NoReturn, TypeVar

T = TypeVar("T")
R = TypeVar("R")

AHEAD: Final = 4  # things for each worker that may be answered before the first of them is taken
NUMBER: Final = 8  # bytes of a number between processes
FAILED: Final = 70  # exit status
_worker: list[int] = []  # in a worker: whose it is
END: Final = (signal.SIGINT, signal.SIGTERM)  # what asks a process to end
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
            with undisturbed():  # what is started is known before anything can end this
                self._start(crew, jobs, ask, things)
            gc.unfreeze()
            yield from self._in_order(ask, things, crew)
        finally:
            with undisturbed():
                for worker in crew:
                    worker.end()

    def beside(self, ask: Callable[[T], R], thing: T) -> "Beside[T, R]":
        """Return a question that one worker answers while this process does something else.

        Args:
            ask: What is asked; its answer is sent between processes.
            thing: Of which; it stays as it is until the answer is taken.
        """
        return Beside(self, ask, thing)

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


class Beside(Generic[T, R]):
    """A question that is answered beside what goes on here. Whoever begins it ends it, too."""

    def __init__(self, workers: Workers, ask: Callable[[T], R], thing: T) -> None:
        """Do nothing yet."""
        self._workers, self._ask, self._thing = workers, ask, thing
        self._worker: _Worker | None = None

    def begin(self) -> bool:
        """Let a worker answer; return whether there is one. Without, the question waits."""
        if self._workers.jobs < 2 or not _may_fork():
            return False
        gc.freeze()
        with undisturbed():
            try:
                self._worker = _Worker(self._ask, (self._thing,))
                self._worker.give(0)
            except OSError as problem:
                self._workers.lost(f"no worker process could be started: {problem.strerror}")
        gc.unfreeze()
        return self._worker is not None

    def answer(self) -> R:
        """Wait for the answer, or give it here if no worker has done so."""
        worker, found = self._worker, ()
        if worker is not None:
            found = worker.take()
            if worker.is_lost:
                self._workers.lost(worker.words)
        self.end()
        return found[0] if found else self._ask(self._thing)

    def end(self) -> None:
        """Leave nobody behind."""
        with undisturbed():
            if self._worker is not None:
                self._worker.end()
            self._worker = None


class _Worker:
    """A process that answers one thing after the other."""

    def __init__(self, ask: Callable[[Any], object], things: Sequence[Any]) -> None:
        asked, self._ask = os.pipe()
        self._told, tell = os.pipe()
        parent = os.getpid()
        try:
            self._pid = os.fork()
        except OSError:
            for end in (asked, self._ask, self._told, tell):
                os.close(end)
            raise
        if self._pid == 0:
            os.close(self._ask)
            os.close(self._told)
            _be_worker(ask, things, (asked, tell), parent)
        os.close(asked)
        os.close(tell)
        self._code: int | None = None  # how it ended, once that is known
        self.has: int | None = None  # the number of the thing it was given
        self.is_lost = False

    def fileno(self) -> int:
        """Return what becomes readable when it answers or ends."""
        return self._told

    @property
    def words(self) -> str:
        """How it was lost."""
        code = self._wait()
        how = f"was ended by {signal.Signals(-code).name}" if code < 0 else f"ended with {code}"
        memory = ", as Linux does where memory runs out" if code == -signal.SIGKILL else ""
        return f"a worker process {how}{memory}; what it was at is done again without it"

    def give(self, number: int) -> None:
        """Let it answer a thing."""
        self.has = number
        with suppress(OSError):  # it has ended: `take` says so
            os.write(self._ask, number.to_bytes(NUMBER, "big"))

    def take(self) -> tuple[Any, ...]:
        """Return its answer; nothing: it has none, or is lost."""
        self.has = None
        length = int.from_bytes(_read(self._told, NUMBER), "big")
        data = _read(self._told, length)
        if not length or len(data) < length:
            self.is_lost = True
            return ()
        return pickle.loads(data)  # noqa: S301 -- what our own fork has sent

    def end(self) -> None:
        """End it at once, and wait until it has ended."""
        if self._code is None:
            os.kill(self._pid, signal.SIGKILL)
        self._wait()
        os.close(self._ask)
        os.close(self._told)

    def _wait(self) -> int:
        if self._code is None:
            self._code = os.waitstatus_to_exitcode(os.waitpid(self._pid, 0)[1])
        return self._code


def end_with(parent: int) -> bool:
    """Ask Linux to end this process when its parent ends, however that ends.

    Returns:
        False: it has ended already.
    """
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    return os.getppid() == parent or sys.platform != "linux"


def _be_worker(
    ask: Callable[[Any], object], things: Sequence[Any], ends: tuple[int, int], parent: int
) -> NoReturn:
    """Answer until nobody asks any more, and never return; Ctrl-C is for whoever asks."""
    status = FAILED
    try:
        _worker.append(parent)
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, END)
        if end_with(parent):
            _work(ask, things, *ends)
        status = 0
    except BaseException:  # the one that asks is told that this has ended
        traceback.print_exc()
    finally:
        os._exit(status)


def _work(ask: Callable[[Any], object], things: Sequence[Any], asked: int, tell: int) -> None:
    """Answer until nobody asks any more."""
    while number := _read(asked, NUMBER):
        try:
            answer: tuple[object, ...] = (ask(things[int.from_bytes(number, "big")]),)
        except Exception:  # raised again where it is asked again
            answer = ()
        data = pickle.dumps(answer)
        left = memoryview(len(data).to_bytes(NUMBER, "big") + data)
        while left:
            try:
                left = left[os.write(tell, left) :]
            except BrokenPipeError:  # nobody is there any more
                return


def _read(end: int, most: int) -> bytes:
    """Return so many bytes, or fewer where nobody writes any more."""
    parts: list[bytes] = []
    while most and (part := os.read(end, min(most, 1 << 20))):
        parts.append(part)
        most -= len(part)
    return b"".join(parts)


def _ready(crew: Sequence[_Worker]) -> list[_Worker]:
    """Wait until some answer or end; return which."""
    return select.select([worker for worker in crew if worker.has is not None], [], [])[0]


def _may_fork() -> bool:
    alone = threading.active_count() == 1
    return sys.platform == "linux" and alone and not _worker


@contextmanager
def undisturbed() -> Generator[None]:
    """Let what asks this process to end wait for a moment."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, END)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
