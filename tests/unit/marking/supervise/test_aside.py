"""Work beside a process: taken once, ended when it takes too long or nobody wants it any more."""

import os
import signal
import time
from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import replace

import psutil
import pytest

from vrts.marking.supervise.aside import FORKS, Aside, Done
from vrts.marking.supervise.forked import wait
from vrts.marking.supervise.limits import GROUP, Limits

PATIENCE = 60.0  # [s] on a busy machine
LIMITS = Limits(cpu_s=5, memory=100_000_000, niceness=3, among_all=2, answer=1000)

pytestmark = pytest.mark.skipif(not FORKS, reason="nothing is forked here")


@pytest.fixture
def aside() -> Iterator[Aside]:
    with closing(Aside(LIMITS)) as aside:
        yield aside


def done(aside: Aside, work: Callable[[], bytes]) -> Done:
    """Return what became of a piece of work."""
    aside.begin(work)
    assert aside.child is not None
    end = time.monotonic() + PATIENCE
    while (found := aside.take()) is None:
        assert time.monotonic() < end
        wait([aside.child], 1.0)
    return found


def hang() -> bytes:
    signal.pause()
    return b""


def test_one_piece_after_the_other_is_taken_once(aside: Aside) -> None:
    for k in range(3):
        assert done(aside, lambda k=k: bytes([k])).answer == bytes([k])
        assert aside.take() is None
        assert not aside.busy


def test_who_works_is_as_nice_as_was_asked(aside: Aside) -> None:
    assert done(aside, lambda: str(os.nice(0)).encode()).answer == str(os.nice(0) + 3).encode()


@pytest.mark.parametrize("work", [lambda: bytes(1001), lambda: bytes(1 // 0), os.abort])
def test_what_fails_has_no_answer(aside: Aside, work: Callable[[], bytes]) -> None:
    assert done(aside, work).answer is None
    assert done(aside, lambda: b"next").answer == b"next"


def test_what_takes_too_long_is_ended() -> None:
    with closing(Aside(replace(LIMITS, wall_s=0.0))) as aside:
        assert done(aside, hang).answer is None


@pytest.mark.parametrize("end", [Aside.drop, Aside.close])
def test_nobody_waits_for_what_nobody_wants(aside: Aside, end: Callable[[Aside], None]) -> None:
    aside.begin(hang)
    assert aside.child is not None
    pid = aside.child.pid
    end(aside)
    assert not psutil.pid_exists(pid)
    assert not aside.busy
    assert aside.take() is None


@pytest.mark.skipif(not GROUP.exists(), reason="processes are not grouped here")
def test_what_may_be_late_lets_others_go_first_where_processes_are_grouped_too(
    aside: Aside,
) -> None:
    told = b""
    for _ in range(20):  # who is not root may set it ten times a second, all processes together
        told = done(aside, GROUP.read_bytes).answer or b""
        if told.endswith(b" nice 2\n"):
            return
    raise AssertionError(told)


def test_without_forks_it_is_done_at_once() -> None:
    here: list[int] = []
    with closing(Aside(LIMITS, forks=False)) as aside:
        aside.begin(lambda: here.append(os.getpid()) or b"here")
        assert here == [os.getpid()]
        assert aside.busy
        assert aside.child is None
        found = aside.take()
        assert found is not None
        assert found.answer == b"here"
        assert not aside.busy
