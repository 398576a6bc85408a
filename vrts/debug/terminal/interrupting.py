"""Ctrl-C while something is worked out: a signal then, a key among others otherwise."""

import signal
import sys
from collections.abc import Generator
from contextlib import contextmanager

try:
    import termios
except ModuleNotFoundError:  # on Windows
    termios = None


@contextmanager
def interruptible() -> Generator[None]:
    """Let Ctrl-C raise KeyboardInterrupt inside, though the terminal hands over single keys.

    Only in the main thread, at a terminal; where the system has no termios, nothing is done.
    """
    if termios is None or not sys.stdin.isatty():
        yield
        return
    number = sys.stdin.fileno()
    keys = termios.tcgetattr(number)
    signals = termios.tcgetattr(number)
    signals[3] |= termios.ISIG
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    termios.tcsetattr(number, termios.TCSANOW, signals)
    try:
        yield
    finally:
        termios.tcsetattr(number, termios.TCSANOW, keys)
        signal.signal(signal.SIGINT, before)
