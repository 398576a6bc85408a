"""What is done when the terminal goes away while a screen is shown."""

import asyncio
import signal
from collections.abc import Callable, Generator
from contextlib import contextmanager


@contextmanager
def hang_up(end: Callable[[], None]) -> Generator[None]:
    """Call something when the terminal hangs up, instead of ending at once.

    Only inside a running event loop. Where the system knows no hang-up, or whoever started this
    wants it to go on after one (`nohup`), nothing is done. What was there before is put back.
    """
    number = getattr(signal, "SIGHUP", None)
    before = None if number is None else signal.getsignal(number)
    if number is None or before is signal.SIG_IGN:
        yield
        return
    loop = asyncio.get_running_loop()
    loop.add_signal_handler(number, end)
    try:
        yield
    finally:
        loop.remove_signal_handler(number)
        if before is not None:  # None: it was not set by Python, and cannot be put back
            signal.signal(number, before)
