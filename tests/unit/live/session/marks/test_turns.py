"""Sessions take turns at checks, and checks leave the processors to frames."""

import os
import signal
import sys
import tempfile
from collections.abc import Generator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest

from tests.unit.live.session.marks.answering import answered
from tests.unit.live.session.support import Driven
from tests.unit.live.session.test_live_session import DOWN
from vrts.live import actions as do
from vrts.live.session.marks.checker import Checker
from vrts.live.session.marks.turns import FileTurns

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="nothing is forked there")


@contextmanager
def taken(file: int, count: int = 1) -> Generator[None]:
    """Have another process take the first free turn; it ends without giving it back."""
    told, tell = os.pipe()
    heard, hear = os.pipe()
    pid = os.fork()
    if pid == 0:
        os.close(hear)
        os.write(tell, b"y" if FileTurns(file, count).take() else b"n")
        os.read(heard, 1)  # until the other end is closed
        os._exit(0)
    os.close(heard)
    os.close(tell)  # so that it is heard when the other process ends without a word
    try:
        assert os.read(told, 1) == b"y"
        yield
    finally:
        os.close(hear)
        os.waitpid(pid, 0)
        os.close(told)


def test_a_turn_is_had_until_it_is_given_back_or_who_has_it_ends() -> None:
    with tempfile.TemporaryFile() as file:
        one, two = FileTurns(file.fileno(), 1), FileTurns(file.fileno(), 2)
        with taken(file.fileno()):
            assert not one.take()
            assert two.take(), "the second one is free"
            two.give_back()
        assert one.take(), "who had it has ended"
        one.give_back()
        with taken(file.fileno()):
            pass


def test_who_takes_a_turn_twice_has_one() -> None:
    with tempfile.TemporaryFile() as file:
        two = FileTurns(file.fileno(), 2)
        with taken(file.fileno()):
            assert two.take(), "the second one"
        assert two.take(), "which it still has, though the first one is free now"
        two.give_back()
        with taken(file.fileno(), 2), taken(file.fileno(), 2):
            assert not two.take(), "others have both"


@pytest.mark.thorough
def test_a_session_checks_when_it_is_its_turn_and_gives_it_back(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    with tempfile.TemporaryFile() as file:
        turns = FileTurns(file.fileno(), 1)
        with closing(Checker(driven.session, turns=turns)) as checker:
            driven.act(do.Go((0.75, -0.15, 0.0), DOWN))
            with taken(file.fileno()):
                for _ in range(3):
                    driven.run(1.1)
                    checker.beat()
                    assert not checker.aside.busy, "another one checks"
            driven.run(0.02)
            checker.beat()
            assert checker.aside.busy, "at once, when it may"
            answered(checker)
            checker.beat()
            assert driven.session.showing.checked_s == pytest.approx(3.32)
            with taken(file.fileno()):
                pass


def hang(*_: object) -> None:
    """Check for ever."""
    signal.pause()


def test_others_check_beside_one_that_takes_long(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("vrts.live.session.marks.checker.checked", hang)
    driven = Driven(tmp_path)
    with tempfile.TemporaryFile() as file:
        turns = FileTurns(file.fileno(), 1)
        with closing(Checker(driven.session, turns=turns)) as checker:
            driven.act(do.Go((0.75, -0.15, 0.0), DOWN))
            driven.run(1.1)
            checker.beat()
            driven.run(2.1)
            checker.beat()
            assert checker.aside.busy, "it goes on"
            with taken(file.fileno()):
                pass
