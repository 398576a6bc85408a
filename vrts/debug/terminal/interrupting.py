"""Ctrl-C while something is worked out: a signal then, a key among others otherwise."""

import signal
import sys
from collections.abc import Callable

try:
    import termios
except ModuleNotFoundError:  # on Windows
    termios = None


def interruptible(deed: Callable[[], object]) -> object:
    """Do a deed; let Ctrl-C end it, though the terminal hands over single keys.

    Only in the main thread, at a terminal; where the system has no termios, it is just done.

    Raises:
        KeyboardInterrupt: Ctrl-C came, during the deed or just before it; never later.

    """
    if termios is None or not sys.stdin.isatty():
        return deed()
    number = sys.stdin.fileno()
    keys = termios.tcgetattr(number)
    signals = termios.tcgetattr(number)
    signals[3] |= termios.ISIG
    came = under_way = False

    def heard(*_: object) -> None:
        nonlocal came, under_way
        came = True
        if under_way:  # elsewhere it would leave the terminal as it must not be
            under_way = False
            raise KeyboardInterrupt

    before = signal.signal(signal.SIGINT, heard)
    try:
        termios.tcsetattr(number, termios.TCSANOW, signals)
        try:
            under_way = True
            if came:
                raise KeyboardInterrupt
            return deed()
        finally:
            under_way = False
    finally:
        termios.tcsetattr(number, termios.TCSANOW, keys)
        signal.signal(signal.SIGINT, before)
