"""Forked workers: answers in order, faults of a worker, and none left behind."""

import os
import select
import signal
import subprocess
import sys
from pathlib import Path
from types import MappingProxyType

import pytest

from tests.places import ROOT
from tests.support_processes import in_a_process
from vrts.base.workers import ALONE, Workers

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="workers are forks")
HERE = os.getpid()

BUSY = """
import os, signal, sys
sys.path.insert(0, ".")
from vrts.base.workers import Workers

def ask(number):
    os.write(1, f"{{os.getpid()}}\\n".encode())
    signal.alarm(60)  # whatever happens, it does not stay
    signal.pause()

try:
    {}
except KeyboardInterrupt:
    sys.exit(130)
"""
ANSWERS = "list(Workers(2).answers(ask, range(4)))"
BESIDE = """\
one, two = Workers(2).beside(ask, 1), Workers(2).beside(ask, 1)
    one.begin() and two.begin()
    one.answer()\
"""


def squared(number: int) -> int:
    return number * number


def who(_: int) -> int:
    return os.getpid()


def ended_at_three(number: int) -> int:
    if number == 3 and os.getpid() != HERE:
        os.kill(os.getpid(), signal.SIGKILL)
    return squared(number)


@pytest.mark.parametrize("jobs", [1, 2, 5])
def test_answers_come_in_the_order_of_the_things(jobs: int) -> None:
    assert list(Workers(jobs).answers(squared, range(40))) == [k * k for k in range(40)]


@in_a_process
def test_others_answer_unless_there_is_nothing_to_share() -> None:
    assert HERE not in set(Workers(2).answers(who, range(6)))
    assert set(ALONE.answers(who, range(6))) == {HERE}
    assert set(Workers(2).answers(who, range(1))) == {HERE}


@in_a_process
def test_a_worker_forks_no_others() -> None:
    def inner(_: int) -> set[int]:
        return {os.getpid()} ^ set(Workers(2).answers(who, range(4)))

    assert list(Workers(2).answers(inner, range(2))) == [set(), set()]


def test_what_is_not_taken_is_not_waited_for(tmp_path: Path) -> None:
    def seldom(number: int) -> int:
        (tmp_path / str(number)).touch()
        return number

    answers = Workers(2).answers(seldom, range(1000))
    assert next(answers) == 0
    answers.close()
    assert len(list(tmp_path.iterdir())) <= 10


@in_a_process
def test_a_worker_that_is_killed_is_told_and_its_part_done_again() -> None:
    lost: list[str] = []
    found = list(Workers(2, lost.append).answers(ended_at_three, range(12)))
    assert found == [k * k for k in range(12)]
    assert len(lost) == 1
    assert "ended by SIGKILL, as Linux does where memory runs out" in lost[0]


@in_a_process
def test_all_are_killed_and_all_is_done_here() -> None:
    def fatal(number: int) -> int:
        if os.getpid() != HERE:
            os.kill(os.getpid(), signal.SIGKILL)
        return number

    lost: list[str] = []
    assert list(Workers(3, lost.append).answers(fatal, range(9))) == list(range(9))
    assert len(lost) == 3


def test_what_is_raised_is_raised_where_its_answer_is_taken() -> None:
    answers = Workers(2).answers(lambda k: 6 // (k - 2), range(5))
    assert [next(answers), next(answers)] == [-3, -6]
    with pytest.raises(ZeroDivisionError):
        next(answers)


@in_a_process
def test_one_question_is_answered_beside_what_goes_on() -> None:
    asked = Workers(2).beside(who, 0)
    assert asked.begin()
    assert asked.answer() != HERE
    with pytest.raises(ChildProcessError):  # nobody is left
        os.waitpid(-1, os.WNOHANG)


@in_a_process
def test_a_question_that_nobody_answers_beside_is_answered_here() -> None:
    alone, inner = ALONE.beside(who, 0), Workers(2).beside(lambda _: begins(), 0)
    assert not alone.begin()
    assert alone.answer() == HERE
    assert inner.begin()
    assert inner.answer() is False  # a worker forks no others


def begins() -> bool:
    return Workers(2).beside(who, 0).begin()


@in_a_process
def test_who_answers_beside_may_be_killed_or_fail() -> None:
    lost: list[str] = []
    killed, fails = (Workers(2, lost.append).beside(ask, 3) for ask in (ended_at_three, failing))
    assert killed.begin()
    assert killed.answer() == squared(3)
    assert len(lost) == 1
    assert "ended by SIGKILL" in lost[0]
    assert fails.begin()
    with pytest.raises(ZeroDivisionError):
        fails.answer()
    fails.end()
    with pytest.raises(ChildProcessError):
        os.waitpid(-1, os.WNOHANG)


def failing(number: int) -> float:
    return number / 0


@in_a_process
def test_an_answer_beside_may_be_long_and_may_be_left() -> None:
    asked = Workers(2).beside(lambda k: "x" * k, 1_000_000)
    assert asked.begin()
    assert asked.answer() == "x" * 1_000_000
    left = Workers(2).beside(lambda k: "x" * k, 1_000_000)
    assert left.begin()
    left.end()
    left.end()
    with pytest.raises(ChildProcessError):
        os.waitpid(-1, os.WNOHANG)


def test_tables_that_are_read_only_come_back_as_such() -> None:
    found = list(Workers(2).answers(lambda k: MappingProxyType({"a": k}), range(2)))
    assert found == [MappingProxyType({"a": 0}), MappingProxyType({"a": 1})]
    assert all(isinstance(one, MappingProxyType) for one in found)


@pytest.mark.parametrize(("how", "status"), [(signal.SIGINT, 130), (signal.SIGKILL, -9)])
@pytest.mark.parametrize("asks", [ANSWERS, BESIDE])
def test_no_worker_is_left_behind(how: signal.Signals, status: int, asks: str) -> None:
    """Ctrl-C reaches the whole group, as from a terminal; a kill only the one that asks."""
    with subprocess.Popen(
        [sys.executable, "-c", BUSY.format(asks)],
        stdout=subprocess.PIPE,
        cwd=ROOT,
        start_new_session=True,
    ) as process:
        assert process.stdout is not None
        crew = [int(process.stdout.readline()) for _ in range(2)]  # both are at work
        watched = [os.pidfd_open(pid) for pid in crew]
        if how is signal.SIGINT:
            os.killpg(process.pid, how)
        else:
            process.kill()
        assert process.wait(30.0) == status
        ended = [bool(select.select([one], [], [], 30.0)[0]) for one in watched]
    for one in watched:
        os.close(one)
    assert ended == [True, True]
