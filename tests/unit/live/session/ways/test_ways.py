"""Questions for ways, answered by a child beside the session."""

import math
import os
import select
import signal
import time
from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass, field
from pathlib import Path

import psutil
import pytest

from tests.unit.live.session.support import Driven
from vrts.live.session.channel.messages import AskReach, Reached
from vrts.live.session.ways import ways as of_ways
from vrts.live.session.ways.ways import BUSY, IDLE_S, LATER, LONGEST_S, LOST, TOO_LONG, Ways

DOWN = (0.0, math.pi / 2, 0.0)
ABOVE = (0.85, 0.1, 0.0)
INSIDE = (0.95, -0.13, -0.2)
PATIENCE = 120.0  # [s]; the machine may be busy


@dataclass
class Asking:
    """Ways of a session, and what they have answered."""

    driven: Driven
    now_s: float = 0.0
    told: list[Reached] = field(default_factory=list[Reached])

    def __post_init__(self) -> None:
        self.ways = Ways(self.driven.session, self.told.append, lambda: self.now_s)

    def ask(self, ref: int, to: tuple[float, float, float], asker: str = "a") -> None:
        self.ways.ask(AskReach(ref, to, DOWN, asker=asker))

    def wait(self, count: int) -> None:
        """Wait until so many answers have come."""
        end = time.monotonic() + PATIENCE
        while len(self.told) < count and time.monotonic() < end:
            if self.ways.heard:  # else it rests, by the clock of its own
                select.select(self.ways.heard, [], [], 0.1)
            self.now_s += 0.001
            self.ways.beat()
        assert len(self.told) == count


@pytest.fixture
def asking(tmp_path: Path) -> Iterator[Asking]:
    asking = Asking(Driven(tmp_path))
    with closing(asking.ways):
        yield asking


def test_answers_come_later_and_what_is_out_of_reach_at_once(asking: Asking) -> None:
    asking.ask(1, (3.0, 0.0, 0.0))
    assert [(r.ref, r.reachable, r.way) for r in asking.told] == [(1, False, "")]
    asking.ask(2, INSIDE)
    assert len(asking.told) == 1
    asking.wait(2)
    inside = asking.told[1]
    assert (inside.ref, inside.reachable, inside.way) == (2, True, "touches")
    assert inside.touches[0].parts[1] == "base1"
    assert inside.method == "certified"
    assert inside.branch == ("lefty", "above", "noflip")
    asking.ask(3, ABOVE)
    asking.wait(3)
    assert (asking.told[2].way, asking.told[2].touches) == ("free", ())


def test_of_each_asker_the_last_question_counts_and_all_get_their_turn(asking: Asking) -> None:
    asking.ask(1, ABOVE, "a")  # the child is at it
    for ref in range(2, 6):
        asking.ask(ref, ABOVE, "a")
    asking.ask(6, ABOVE, "b")
    given_up = [(r.ref, r.why) for r in asking.told]
    assert given_up == [(2, LATER), (3, LATER), (4, LATER)]
    asking.wait(6)
    assert [(r.ref, r.way) for r in asking.told[3:]] == [(1, "free"), (5, "free"), (6, "free")]


def test_too_many_askers_are_told_so(asking: Asking, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(of_ways, "MOST_WAITING", 2)
    for ref in range(4):
        asking.ask(ref, ABOVE, f"p{ref}")
    assert [(r.ref, r.way, r.why) for r in asking.told] == [(3, "unknown", BUSY)]


def test_answers_leave_half_of_the_processor(asking: Asking) -> None:
    asking.ask(1, ABOVE)
    asking.ask(2, ABOVE)
    assert asking.ways.worker is not None
    select.select([asking.ways.worker], [], [], PATIENCE)
    asking.now_s = 0.4  # so long the first one took
    asking.ways.beat()
    assert len(asking.told) == 1
    assert asking.ways.heard == (), "the second one waits"
    asking.now_s = 0.79
    asking.ways.beat()
    assert asking.ways.heard == ()
    asking.now_s = 0.81
    asking.ways.beat()
    assert asking.ways.heard != ()


def test_a_child_that_dies_or_hangs_costs_one_answer(asking: Asking) -> None:
    asking.ask(1, ABOVE)
    worker = asking.ways.worker
    assert worker is not None
    os.kill(worker.pid, signal.SIGSTOP)
    asking.now_s += LONGEST_S + 0.01
    asking.ways.beat()
    assert [(r.reachable, r.way, r.why) for r in asking.told] == [(True, "unknown", TOO_LONG)]
    assert not psutil.pid_exists(worker.pid)
    asking.now_s += 10.0
    asking.ask(2, ABOVE)
    worker = asking.ways.worker
    assert worker is not None
    os.kill(worker.pid, signal.SIGKILL)
    asking.wait(2)
    assert asking.told[1].why in ("", LOST)  # it may have answered before
    asking.now_s += 10.0
    asking.ask(3, ABOVE)
    asking.wait(3)
    assert asking.told[2].way == "free"


def test_the_child_ends_when_nobody_asks_for_long(asking: Asking) -> None:
    asking.ask(1, ABOVE)
    asking.wait(1)
    worker = asking.ways.worker
    assert worker is not None
    asking.now_s += IDLE_S + 1.0
    asking.ways.beat()
    assert asking.ways.worker is None
    assert not psutil.pid_exists(worker.pid)


def test_without_a_child_the_session_answers(tmp_path: Path) -> None:
    told: list[Reached] = []
    with closing(Ways(Driven(tmp_path).session, told.append, forks=False)) as ways:
        ways.ask(AskReach(1, INSIDE, DOWN))
    assert [(r.ref, r.way) for r in told] == [(1, "touches")]
