"""A session that has begun: what hears its orders, and what beats with it."""

from contextlib import ExitStack, closing

from vrts.live.session.channel.beats import AFTER_TICK, Beats, shows
from vrts.live.session.channel.messages import (
    AskBlock,
    AskReach,
    AskState,
    Json,
    Pace,
    Sleep,
    ToSession,
)
from vrts.live.session.channel.outbox import Outbox
from vrts.live.session.growing.tidying import Tidying
from vrts.live.session.live_session import Clock, Session
from vrts.live.session.looking.looker import Looker
from vrts.live.session.marks.checker import Checker
from vrts.live.session.marks.turns import Turns
from vrts.live.session.sleeping.falling import Falling
from vrts.live.session.ways.ways import Ways


class Going:
    """A session with all that looks at it; `close` ends what it has started."""

    def __init__(
        self, session: Session, scene: Json, outbox: Outbox, clock: Clock, turns: Turns | None
    ) -> None:
        """Begin to beat.

        Args:
            session: What goes on.
            scene: As browsers draw it.
            outbox: Where messages go.
            clock: Only goes forward [s].
            turns: At checks, with other sessions; None: it checks when it will.
        """
        self._session, self._outbox, self._clock = session, outbox, clock
        self._tidying = Tidying()
        with ExitStack() as begun:
            self._checker = begun.enter_context(closing(Checker(session, turns=turns)))
            self._looker = begun.enter_context(closing(Looker(session, outbox.send)))
            self.ways = begun.enter_context(closing(Ways(session, outbox.send, clock)))
            self._beats = Beats(clock())
            self._falling = Falling(session, self._checker, scene)
            self._begun = begun.pop_all()

    def close(self) -> None:
        """End what looks at the session."""
        self._begun.close()

    @property
    def pause_s(self) -> float:
        """How long nothing is to be done [s]."""
        return max(self._beats.due_s - self._clock(), 0.0)

    def hear(self, order: ToSession) -> None:
        """Do what an order says, or have it done."""
        session, beats = self._session, self._beats
        if isinstance(order, Pace):
            beats.period_s, beats.seldom = 1.0 / order.rate, order.seldom
        if isinstance(order, AskBlock | AskState):
            self._looker.ask(order)
            beats.bring_forward(self._clock())
        if isinstance(order, Sleep):
            beats.bring_forward(self._clock())
        self._falling.hear(order)
        if isinstance(order, AskReach):
            self.ways.ask(order)
        else:
            session.take(order)
        if shows(order):
            beats.bring_forward(session.epoch_s + session.growing.next_tick_s + AFTER_TICK)

    def beat(self) -> None:
        """Let time go on, if a beat is due; answer what is asked of ways in any case."""
        if self._clock() >= self._beats.due_s:
            self._beat()
        self.ways.beat()
        self._outbox.flush()

    def _beat(self) -> None:
        session, outbox, checker = self._session, self._outbox, self._checker
        session.beat()
        outbox.flush()  # who watches does not wait for what follows
        checker.beat()
        self._looker.beat()
        self._tidying.beat(session.growing.time_s)
        if (slept := self._falling.beat()) is not None:
            outbox.send(slept)
        busy = session.under_way or self._looker.busy or self._falling.busy or checker.aside.busy
        self._beats.kept(self._clock(), at_rest=not busy)
