"""Questions for ways, answered in a child one at a time; the last one of each asker counts.

At most half of a processor goes into answers, and less than that where the machine is busy: they
are nicer than frames. The session itself works out no more than whether the arm gets there.
"""

import time
from collections import OrderedDict
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

import msgspec

from vrts.live.session.channel.messages import AskReach, Reached
from vrts.live.session.live_session import Session
from vrts.live.session.ways.way import Asked, Found, asked_of, find
from vrts.live.session.ways.worker import TooLong, Worker
from vrts.marking.supervise.aside import FORKS

MOST_WAITING: Final = 32  # askers
SHARE: Final = 0.5  # of a processor at most
LONGEST_S: Final = 3.0  # [s] for an answer; then it is given up
IDLE_S: Final = 60.0  # [s] without a question after which the child ends

NOT_CHECKED: Final = "not checked for contacts"
BUSY: Final = f"{NOT_CHECKED}: too many ask at once"
TOO_LONG: Final = f"{NOT_CHECKED}: it took too long"
LOST: Final = f"{NOT_CHECKED}: the check failed"
LATER: Final = f"{NOT_CHECKED}: a later question came"
TOO_MUCH: Final = f"{NOT_CHECKED}: the scene has too many movable objects"


@dataclass(slots=True)
class _Waiting:
    """A question, and what is known already."""

    order: AskReach
    reached: Reached
    asked: Asked
    asked_s: float  # when it came [s]


class Ways:
    """Takes questions and answers them later."""

    def __init__(
        self,
        session: Session,
        send: Callable[[Reached], None],
        clock: Callable[[], float] = time.monotonic,
        *,
        forks: bool = FORKS,
    ) -> None:
        """Answer about a session.

        Args:
            session: Whose arm goes the ways.
            send: Takes the answers.
            clock: Only goes forward [s].
            forks: Whether there is a child; without, the session answers itself.
        """
        self._session = session
        self._send = send
        self._clock = clock
        self._forks = forks
        self._waiting: OrderedDict[str, _Waiting] = OrderedDict()
        self._now: _Waiting | None = None  # what the child is at
        self._begun_s = 0.0
        self._next_s = 0.0  # before this no question is passed on
        self.worker: Worker | None = None

    def close(self) -> None:
        """End with the session."""
        self._end()

    @property
    def heard(self) -> Sequence[Worker]:
        """What becomes readable when an answer comes."""
        return () if self.worker is None or self._now is None else (self.worker,)

    def ask(self, order: AskReach) -> None:
        """Take a question."""
        reached = self._session.reach(order)
        if not reached.reachable:
            self._send(reached)
            return
        if not self._forks:
            found = _find(self._session, asked_of(self._session.growing, order))
            self._send(told(reached, found))
            return
        before = self._waiting.pop(order.asker, None)
        if before is not None:
            self._send(unknown(before.reached, LATER))
        elif len(self._waiting) >= MOST_WAITING:
            self._send(unknown(reached, BUSY))
            return
        asked = asked_of(self._session.growing, order)
        self._waiting[order.asker] = _Waiting(order, reached, asked, self._clock())
        self.beat()

    def beat(self) -> None:
        """Take the answer that has come, and pass the next question on, if it is time."""
        now_s = self._clock()
        self._take(now_s)
        if self._now is None and self._waiting and now_s >= self._next_s:
            _, self._now = self._waiting.popitem(last=False)
            self._begun_s = now_s
            if self.worker is None:
                session = self._session
                self.worker = Worker(lambda asked: _find(session, asked))
            try:
                self.worker.ask(self._now.asked)
            except TooLong:
                self._answer(unknown(self._now.reached, TOO_MUCH))
        elif self.worker is not None and now_s - self._begun_s > IDLE_S:
            self._end()

    def _take(self, now_s: float) -> None:
        if self._now is None or self.worker is None:
            return
        answer = self.worker.answer()
        took_s = now_s - self._begun_s
        if answer:
            found = answer[0]
            assert found is None or isinstance(found, Found)
            self._next_s = now_s + took_s * (1.0 / SHARE - 1.0)
            self._answer(told(self._now.reached, found))
        elif self.worker.lost or took_s > LONGEST_S:
            reached = unknown(self._now.reached, LOST if self.worker.lost else TOO_LONG)
            self._next_s = now_s + took_s * (1.0 / SHARE - 1.0)
            self._end()
            self._answer(reached)

    def _answer(self, reached: Reached) -> None:
        self._now = None
        self._send(reached)

    def _end(self) -> None:
        if self.worker is not None:
            self.worker.end()
            self.worker = None


def told(reached: Reached, found: Found | None) -> Reached:
    """Return an answer with what was found of the way."""
    if found is None:
        return unknown(reached, LOST)
    way = "touches" if found.touches else "free" if found.sure else "unknown"
    return msgspec.structs.replace(
        reached, way=way, touches=found.touches, path_m=found.path_m, method="certified"
    )


def unknown(reached: Reached, why: str) -> Reached:
    """Return an answer that says nothing of the way."""
    return msgspec.structs.replace(reached, way="unknown", why=why)


def _find(session: Session, asked: Asked) -> Found | None:
    return find(session.setting.scene, session.growing.machine.system.planner.stance, asked)
