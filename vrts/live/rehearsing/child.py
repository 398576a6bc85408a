"""`python -m vrts.live.rehearsing.child`: one rehearsal at a time, questions in, answers out.

A question is a line of JSON on standard input, an answer one on standard output. It has no folder,
no environment worth mentioning, and limits of its own; what it runs is data of the engine.
"""

import os
import signal
import sys
from contextlib import suppress
from pathlib import Path
from typing import Final

import msgspec

from vrts.base.workers import end_with
from vrts.live.rehearsing.asked import AskBlock, At, Begin, Breakpoints, Go, PassedOn, passed_on
from vrts.live.rehearsing.begun import begun
from vrts.live.rehearsing.rehearsal import Rehearsal
from vrts.live.rehearsing.told import NO_MEMORY, Placed, Refused, Told
from vrts.live.session.marks.checker import warm_up
from vrts.live.session.setting import scene_sha256
from vrts.marking.supervise.limits import Limits, for_the_next, impose
from vrts.pipeline.alone import robot_alone

LIMITS: Final = Limits(cpu_s=1800, memory=600_000_000, file=1_000_000, files=64)
ONCE_S: Final = 40  # of processor for one question [s]
YIELDS: Final = 5  # niceness: sessions and the server go first
WARM: Final = "warm"  # argument of one that has time
NONE: Final = "nothing is rehearsed"

_encode = msgspec.json.Encoder().encode


class Child:
    """Answers questions."""

    def __init__(self) -> None:
        """Begin without a rehearsal."""
        self.rehearsal: Rehearsal | None = None
        self._of = 0

    def answer(self, order: PassedOn) -> Told:
        """Return the answer to a question."""
        if isinstance(order, Begin):
            self._of, self.rehearsal = order.order.id, None
            self.rehearsal, told = begun(order)
            return told
        rehearsal = self.rehearsal
        if rehearsal is None or order.id != self._of:
            return Refused(order.id, NONE)
        match order:
            case Breakpoints(lines=lines):
                return Placed(order.id, rehearsal.stop_at(lines))
            case Go(what=what):
                return rehearsal.go(order.id, what)
            case At(time_s=time_s):
                return rehearsal.at(order.id, time_s)
            case AskBlock(number=number):
                return rehearsal.block(order.id, number)


def serve() -> int:
    """Answer until nobody asks any more; return the exit status."""
    child, out = Child(), sys.stdout.buffer
    try:
        for line in sys.stdin.buffer:
            for_the_next(ONCE_S)
            out.write(_encode(child.answer(passed_on(line))) + b"\n")
            out.flush()
    except MemoryError:
        return NO_MEMORY
    except BrokenPipeError:
        return 0
    return 0


def _yield() -> None:
    """Let sessions and the server go first, where every process has a group of its own, too."""
    if hasattr(os, "nice"):
        os.nice(YIELDS)
    group = Path("/proc/self/autogroup")
    if group.exists():
        with suppress(OSError):  # it may not be changed twice in a short time
            group.write_text(str(YIELDS))


if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the server's
    if not end_with(os.getppid()):
        sys.exit(0)
    _yield()
    impose(LIMITS)
    if sys.argv[1:] == [WARM]:  # what is loaded only when it is needed is loaded now
        alone = robot_alone()
        warm_up(alone)
        scene_sha256(alone)
    sys.exit(serve())
