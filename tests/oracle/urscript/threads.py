"""Threads of URScript and the time that they use, one thread after another.

From UR's script manual alone, before any export used them: pages "Threads" (SW 5.20) and "Thread
scheduling" (SW 5.25). Each thread has 0.002 s in a frame; what moves the arm, `sleep` and
`sync` use time, all else uses none. `run` goes on behind itself; `join` waits for a thread that the
caller has begun; after `kill` the handle is no longer valid, and children are killed as well. The
manual does not say what happens to a thread that is over when it is killed: that is refused here.
"""

import math
import threading
from collections.abc import Callable

from tests.oracle.urscript.values import NotTaken

FRAME = 0.002  # [s]


class Killed(Exception):  # noqa: N818 -- names the situation
    """The thread was killed."""


class Thread:
    """A handle: what `run` gives back."""

    def __init__(self, wake: float, turn: int) -> None:
        """Be ready at a time [s]; `turn` tells who comes first at one time."""
        self.wake, self.turn = wake, turn
        self.over = self.killed = False
        self.waits_for: Thread | None = None
        self.children: list[Thread] = []
        self.baton = threading.Semaphore(0)
        self.body: threading.Thread | None = None


class Threads:
    """All threads of a program, of which one runs at a time."""

    def __init__(self) -> None:
        """Have the program itself alone."""
        self.now = 0.0  # [s]
        self.turns = 0
        self.main = self.current = Thread(0.0, 0)
        self.all = [self.main]
        self.failed: BaseException | None = None  # what ended a thread, and so the program

    def begin(self, carry_out: Callable[[], None]) -> Thread:
        """Begin a thread beside the one that runs, which goes on first."""
        thread = Thread(self.now, self._turn())
        self.current.children.append(thread)
        self.all.append(thread)

        def body() -> None:
            thread.baton.acquire()
            try:
                if not thread.killed:
                    carry_out()
            except Killed:
                pass
            except BaseException as why:
                self.failed = why
            thread.over = True
            if not thread.killed:
                self._hand_on(self.main if self.failed is not None else self._following())

        thread.body = threading.Thread(target=body, daemon=True)
        thread.body.start()
        return thread

    def use(self, seconds: float) -> None:
        """Let the thread that runs use time; others run meanwhile."""
        me = self.current
        me.wake, me.turn = self.now + seconds, self._turn()
        self._switch(me)

    def join(self, thread: object) -> None:
        """Wait until a thread is over."""
        me = self.current
        if not isinstance(thread, Thread) or thread.killed or thread not in me.children:
            raise NotTaken("a thread waits for one that it has begun")
        if not thread.over:
            me.waits_for = thread
            self._switch(me)
            me.waits_for = None

    def kill(self, thread: object) -> None:
        """Stop a running thread, and those that it has begun."""
        if not isinstance(thread, Thread) or thread.killed or thread.over:
            raise NotTaken("a running thread is killed, once")
        if thread is self.current:
            raise NotTaken("the manual does not say that a thread kills itself")
        self._stop(thread)

    def end(self) -> None:
        """Stop all threads: the program has ended."""
        for thread in self.all:
            if thread is not self.main and not thread.over and not thread.killed:
                self._stop(thread)

    def _stop(self, thread: Thread) -> None:
        thread.killed = True
        for child in thread.children:
            if not child.over and not child.killed:
                self._stop(child)
        thread.baton.release()
        assert thread.body is not None
        thread.body.join()

    def _turn(self) -> int:
        self.turns += 1
        return self.turns

    def _following(self) -> Thread:
        ready = [
            thread
            for thread in self.all
            if not thread.over
            and not thread.killed
            and (thread.waits_for is None or thread.waits_for.over)
        ]
        if not ready:
            self.failed = NotTaken("every thread waits for another one")
            return self.main
        return min(ready, key=lambda thread: (self._ready_at(thread), thread.turn))

    def _ready_at(self, thread: Thread) -> float:
        """Return when a thread goes on [s]: at the beginning of a frame."""
        return FRAME * math.ceil(max(thread.wake, 0.0) / FRAME - 1e-6)

    def _hand_on(self, thread: Thread) -> None:
        self.current = thread
        self.now = max(self.now, self._ready_at(thread))
        thread.baton.release()

    def _switch(self, me: Thread) -> None:
        following = self._following()
        if following is me:
            self.now = max(self.now, self._ready_at(me))
        else:
            self._hand_on(following)
            me.baton.acquire()
        if me.killed:
            raise Killed
        if self.failed is not None and me is self.main:
            raise self.failed
