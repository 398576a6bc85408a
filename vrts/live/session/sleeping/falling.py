"""When a session may fall asleep: at rest, with everything checked that it has done."""

from typing import Final

from vrts.live.session.channel.messages import Act, Halt, Json, Sleep, Slept, ToSession
from vrts.live.session.live_session import WAITING, Session
from vrts.live.session.marks.checker import Checker
from vrts.live.session.sleeping.state import put_away

PATIENCE_S: Final = 5.0  # [s] of session time for checks; then it sleeps, and checks when it wakes
COMMAND: Final = "a command came"
NOT_KEPT: Final = "its state cannot be kept: {}"


class Falling:
    """Waits for the moment, and answers."""

    def __init__(self, session: Session, checker: Checker, drawn: Json) -> None:
        """Wait for nothing yet; `drawn` is what the viewer draws."""
        self._session = session
        self._checker = checker
        self._drawn = drawn
        self._asked: tuple[int, float] | None = None  # reference, and until when checks may take
        self._answer: Slept | None = None

    @property
    def busy(self) -> bool:
        """Whether the server waits for an answer."""
        return self._asked is not None

    def hear(self, order: ToSession) -> None:
        """Take note of an order: a command keeps awake."""
        if isinstance(order, Sleep):
            self._asked = (order.ref, self._session.growing.time_s + PATIENCE_S)
        elif self._asked is not None and isinstance(order, Act | Halt):
            self._answer = Slept(self._asked[0], text=COMMAND)

    def beat(self) -> Slept | None:
        """Return the answer, if it is time for one."""
        if self._asked is None:
            return None
        (ref, until_s), growing = self._asked, self._session.growing
        answer, self._answer = self._answer, None
        why = self._session.under_way
        if answer is None and why == WAITING and growing.time_s < until_s:
            return None
        if answer is None and why:
            answer = Slept(ref, text=why)
        if answer is None and (self._checker.settled or growing.time_s >= until_s):
            try:
                sha256 = put_away(self._session, self._drawn)
                answer = Slept(ref, growing.time_s, sha256)
            except OSError as problem:
                answer = Slept(ref, text=NOT_KEPT.format(problem.strerror or problem))
        if answer is not None:
            self._asked = None
        return answer
