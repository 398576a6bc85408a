"""Work that is given up when it takes too much of the processor."""

import signal
import sys
from collections.abc import Generator
from contextlib import contextmanager
from types import FrameType

CAN = sys.platform != "win32"


class TooLong(Exception):  # noqa: N818 -- names the situation
    """The time is over."""


@contextmanager
def within(seconds: float) -> Generator[None]:
    """Give up what is done inside after so much time of the processor [s].

    Raises:
        TooLong: It is not done then. It may be raised between any two steps of the work.
    """
    if not CAN:  # whoever waits for an answer ends the process then
        yield
        return

    def over(_: int, __: FrameType | None) -> None:
        raise TooLong

    before = signal.signal(signal.SIGPROF, over)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)
