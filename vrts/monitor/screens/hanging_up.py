"""What is done when the terminal goes away while a screen is shown."""

import asyncio
import signal
from collections.abc import Callable, Generator
from contextlib import contextmanager


@contextmanager
def hang_up(end: Callable[[], None]) -> Generator[None]:
    """Call something when the terminal hangs up, instead of ending at once.

    Only inside a running event loop; where the system knows no hang-up, nothing is done.
    """
    number = getattr(signal, "SIGHUP", None)
    if number is None:
        yield
        return
    loop = asyncio.get_running_loop()
    loop.add_signal_handler(number, end)
    try:
        yield
    finally:
        loop.remove_signal_handler(number)
