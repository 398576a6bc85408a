"""Motion that is certified while the search goes on: what is told does not depend on it."""

import os
import signal
from collections.abc import Callable
from typing import Any

import pytest

from tests.support_processes import in_a_process
from tests.unit.prove.explore.proofs import ALONE, FREE, module_of
from vrts.base.workers import Workers
from vrts.check.verdict import Answer
from vrts.prove.asking import Asking, Told
from vrts.prove.certify.looking import Looked, New, looked_at
from vrts.prove.explore import search, touches
from vrts.prove.proof import Proof
from vrts.prove.prove import prove

HERE = os.getpid()
TURNS = """\
READY
FOR i = 1 TO {}
IF SIG(1001) THEN
DRIVE 1, 25, 60
END
IF SIG(1002) THEN
DRIVE 2, 15, 60
END
IF SIG(1003) THEN
DRIVE 3, 10+i, 60
END
END"""
TOUCHES = TURNS.format(6)  # the robot may touch the floor
WITHIN = TURNS.format(2)


class Late:
    """A question that somebody answers as late as may be."""

    begun = ended = 0

    def __init__(self, ask: Callable[[Any], Any], thing: Any) -> None:
        self._ask, self._thing = ask, thing

    def begin(self) -> bool:
        Late.begun += 1
        return True

    def answer(self) -> Any:
        self.end()
        return self._ask(self._thing)

    def end(self) -> None:
        Late.ended += 1


def proven(body: str, asking: Asking) -> Proof:
    return prove(module_of(body), ALONE, FREE, asking, entry="main")


def often(set_: Callable[[object, str, object], None]) -> None:
    """Certify little at a time, and go on for a short while where something seems wrong."""
    set_(search, "CERTIFY_S", 3.0)
    set_(search, "TELL", 50)
    set_(touches, "WORTH", 1)
    set_(search, "SOON", 120)


@pytest.mark.thorough
@pytest.mark.parametrize(("body", "answer"), [(TOUCHES, Answer.VIOLATED), (WITHIN, Answer.HOLDS)])
def test_late_answers_change_nothing(
    body: str, answer: Answer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Neither what is found, nor how long the search goes on once something seems wrong."""
    often(monkeypatch.setattr)
    monkeypatch.setattr(Late, "begun", 0)
    usual = proven(body, Asking(states=3_000))
    assert usual.answer is answer
    assert repr(proven(body, Asking(states=3_000, beside=Late))) == repr(usual)
    assert Late.begun > 5


def test_nobody_is_left_where_a_search_is_broken_off(monkeypatch: pytest.MonkeyPatch) -> None:
    often(monkeypatch.setattr)
    monkeypatch.setattr(Late, "begun", 0)
    monkeypatch.setattr(Late, "ended", 0)

    def told(so_far: Told) -> None:
        if so_far.states > 100:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        proven(WITHIN, Asking(told=told, beside=Late))
    assert 0 < Late.begun <= Late.ended


def killed(new: New) -> Looked:
    if os.getpid() != HERE:
        os.kill(os.getpid(), signal.SIGKILL)
    return looked_at(new)


@pytest.mark.thorough
@in_a_process
def test_other_processes_change_nothing_even_where_they_are_killed() -> None:
    often(setattr)
    usual = repr(proven(TOUCHES, Asking(states=1_000)))
    lost: list[str] = []
    forks: list[int] = []
    os.register_at_fork(after_in_parent=lambda: forks.append(1))
    for ask in (looked_at, killed):
        touches.looked_at = ask
        asking = Asking(states=1_000, beside=Workers(2, lost.append).beside)
        assert repr(proven(TOUCHES, asking)) == usual
        assert len(lost) == (len(forks) if ask is killed else 0)
        assert len(forks) > 5
        forks.clear()
    with pytest.raises(ChildProcessError):
        os.waitpid(-1, os.WNOHANG)
