"""Ctrl-C at any moment around a deed: it ends the deed or comes too late, and breaks nothing."""

import os
import signal
import sys
import termios
from collections.abc import Iterator
from types import FrameType, TracebackType
from typing import Any

import pytest

from vrts.debug.terminal.interrupting import interruptible

DONE = object()


@pytest.fixture
def terminal(monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
    """Return a terminal that hands over single keys, as standard input."""
    master, slave = os.openpty()
    keys = termios.tcgetattr(slave)
    keys[3] &= ~termios.ISIG
    termios.tcsetattr(slave, termios.TCSANOW, keys)
    with os.fdopen(slave) as stdin, monkeypatch.context() as patch:
        patch.setattr(sys, "stdin", stdin)
        yield slave
    os.close(master)


class CtrlC:
    """Ctrl-C before the line of `interruptible`, or of what it does, with a number."""

    def __init__(self, slave: int, number: int) -> None:
        self._slave = slave
        self._left = number
        self.came = False

    def __enter__(self) -> "CtrlC":
        sys.settrace(self._called)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        sys.settrace(None)

    def _called(self, frame: FrameType, _event: str, _value: object) -> Any:
        ours = frame.f_code.co_filename in {interruptible.__code__.co_filename, __file__}
        return self._line if ours else None

    def _line(self, _frame: FrameType, event: str, _value: object) -> Any:
        if event == "line" and termios.tcgetattr(self._slave)[3] & termios.ISIG:
            self._left -= 1
            if self._left == 0:
                self.came = True
                signal.raise_signal(signal.SIGINT)
        return self._line


def deed() -> object:
    found = DONE
    return found  # noqa: RET504 - a line more at which it is interrupted


def test_ctrl_c_ends_a_deed_or_is_too_late_and_the_terminal_is_as_before(terminal: int) -> None:
    keys, before = termios.tcgetattr(terminal), signal.getsignal(signal.SIGINT)
    ended = number = 0
    while True:
        number += 1
        found: object = None
        with CtrlC(terminal, number) as typed:
            try:
                found = interruptible(deed)
            except KeyboardInterrupt:
                ended += 1
        assert termios.tcgetattr(terminal) == keys
        assert signal.getsignal(signal.SIGINT) is before
        if not typed.came:
            assert found is DONE
            break
    assert ended >= 3  # before the deed and at both of its lines
    assert number > ended + 1  # and afterwards too late
