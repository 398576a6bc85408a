"""The serial line: the door to pyserial."""

import os
import time
from collections.abc import Callable
from typing import Protocol, TypeVar

from vrts.dispatch.profile_parts import Serial
from vrts.dispatch.transfer.problems import LINE_LOST, NO_PORT, stop
from vrts.pipeline.files import CannotRead

Value = TypeVar("Value")

_LOOK_S = 0.002  # between two looks whether all has left
_PARITIES = {"none": "N", "even": "E", "odd": "O"}


class Wire(Protocol):
    """What a conversation needs of a line."""

    def write(self, data: bytes) -> None:
        """Send bytes; return when they have left."""
        ...

    def read(self, wait_s: float) -> bytes:
        """Return what has come, at the latest after some silence, in which case it is empty."""
        ...

    def close(self) -> None:
        """Let go of the line."""
        ...


class Port:
    """An open serial port."""

    def __init__(self, name: str, settings: Serial, hold_s: float) -> None:
        """Open it, for nobody else.

        Args:
            name: As the system calls it.
            settings: Of the line.
            hold_s: For how long the other side may hold the line.

        Raises:
            CannotRead: pyserial is not installed.
            Refused: There is no such port, or it cannot be used.
        """
        try:
            import serial  # pyserial is optional
        except ModuleNotFoundError as missing:
            hints = ("python -m pip install 'vrts[dispatch]'",)
            raise CannotRead("serial ports need the package pyserial", hints) from missing
        self.name = name
        self._hold_s = hold_s
        self._broken: tuple[type[Exception], ...] = (serial.SerialException, OSError)
        self._held = serial.SerialTimeoutException
        try:
            self._serial = serial.Serial(
                name,
                settings.baud,
                bytesize=settings.data_bits,
                parity=_PARITIES[settings.parity],
                stopbits=settings.stop_bits,
                xonxoff=settings.flow == "xonxoff",
                rtscts=settings.flow == "rtscts",
                timeout=0.0,
                write_timeout=hold_s,
                exclusive=True if os.name == "posix" else None,
            )
        except (*self._broken, ValueError) as problem:
            raise stop(
                NO_PORT,
                f"the port `{name}` cannot be opened",
                f"the system says: {_reason(problem)}",
                remedy="`python -m serial.tools.list_ports -v` lists the ports there are",
            ) from problem

    def write(self, data: bytes) -> None:
        """Send bytes; return when they have left."""

        def give() -> None:
            self._serial.write(data)
            until = time.monotonic() + self._hold_s
            while self._serial.out_waiting:  # `flush` would wait for ever
                if time.monotonic() > until:
                    raise self._held
                time.sleep(_LOOK_S)

        self._obeyed(give)

    def read(self, wait_s: float) -> bytes:
        """Return what has come, at the latest after some silence, in which case it is empty."""

        def take() -> bytes:
            waiting = self._serial.in_waiting
            if waiting:
                return self._serial.read(waiting)
            if self._serial.timeout != wait_s:
                self._serial.timeout = wait_s
            first = self._serial.read(1)
            return first + self._serial.read(self._serial.in_waiting) if first else b""

        return self._obeyed(take)

    def close(self) -> None:
        """Let go of the line."""
        self._serial.close()

    def _obeyed(self, act: Callable[[], Value]) -> Value:
        try:
            return act()
        except self._held as problem:
            raise stop(
                LINE_LOST,
                f"nothing could be sent on `{self.name}` for {self._hold_s:g} s",
                "the other side holds the line (Ctrl-S, or its handshake lines)",
                remedy="press Ctrl-Q at the controller's terminal; check cable and flow control",
            ) from problem
        except self._broken as problem:
            raise stop(
                LINE_LOST,
                f"the line at `{self.name}` is broken",
                f"the system says: {_reason(problem)}",
                remedy="check plug and adapter; then go on with `--resume`",
            ) from problem


def _reason(problem: Exception) -> str:
    if isinstance(problem, OSError) and problem.errno is not None:
        return os.strerror(problem.errno).lower()
    return str(problem)[:200]
