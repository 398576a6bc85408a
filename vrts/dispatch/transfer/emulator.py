"""An emulated controller: vrts' own monitor behind a serial line, character by character.

`Machine` echoes and edits the line that is typed, and hands it to a `Dialogue`; `Paced` lets bytes
through as fast as a line of some speed does; `serve` runs both behind a pseudo-terminal.
"""

import os
import select
import tty
from collections import deque
from collections.abc import Callable
from typing import Protocol

from vrts.monitor.dialogue import Dialogue

LONGEST = 255  # characters of a line; more only ring the bell
BITS = 10  # of a character on the line: start, eight, stop
_BELL = b"\a"
_RUB = b"\b \b"
_SLOWEST_S = 0.05  # between two looks at the line while nothing is due


class Machine:
    """What is behind the line: takes characters, gives characters."""

    def __init__(self, dialogue: Dialogue) -> None:
        """Go on with a dialogue; nothing is typed yet."""
        self.dialogue = dialogue
        self._line = bytearray()

    def greeting(self) -> bytes:
        """Return what stands on the screen at first."""
        return self._bytes(f"\n{self.dialogue.prompt}")

    def receive(self, character: int) -> bytes:
        """Take a character; return what is shown then."""
        match character:
            case 0x0D:  # RETURN
                line = self._line.decode("ascii")
                self._line.clear()
                return self._bytes(f"\n{self.dialogue.enter(line)}{self.dialogue.prompt}")
            case 0x03:  # Ctrl-C
                self._line.clear()
                return self._bytes(f"\n{self.dialogue.interrupt()}{self.dialogue.prompt}")
            case 0x15 | 0x18:  # Ctrl-U, Ctrl-X
                rubbed = _RUB * len(self._line)
                self._line.clear()
                return rubbed
            case 0x08 | 0x7F:
                rubbed = _RUB if self._line else b""
                del self._line[-1:]
                return rubbed
            case _ if not 0x20 <= character < 0x7F:
                return b""
            case _ if len(self._line) >= LONGEST:
                return _BELL
            case _:
                self._line.append(character)
                return bytes((character,))

    def pass_time(self, seconds: float) -> bytes:
        """Let time pass while a program executes; return what it shows."""
        if not self.dialogue.busy:
            return b""
        news = self.dialogue.advance(self.dialogue.time_s + seconds)
        if not self.dialogue.busy:
            news = f"{news}{self.dialogue.prompt}"
        return self._bytes(news)

    def _bytes(self, text: str) -> bytes:
        return text.replace("\n", "\r\n").encode("ascii", "replace")


class Paced:
    """Characters under way on a line of some speed."""

    def __init__(self, baud: float) -> None:
        """Begin with none."""
        self._each_s = BITS / baud
        self._free_at = 0.0  # when the line has let the last one through
        self._waiting: deque[tuple[float, int]] = deque()

    def add(self, data: bytes, now: float) -> None:
        """Put characters on the line behind those that are on it."""
        for character in data:
            self._free_at = max(self._free_at, now) + self._each_s
            self._waiting.append((self._free_at, character))

    def due(self, now: float) -> list[tuple[float, int]]:
        """Take the characters that have come through, each with its time."""
        found: list[tuple[float, int]] = []
        while self._waiting and self._waiting[0][0] <= now:
            found.append(self._waiting.popleft())
        return found

    @property
    def next_at(self) -> float | None:
        """When the next one comes through; None: there is none."""
        return self._waiting[0][0] if self._waiting else None


class Line(Protocol):
    """What becomes of characters between the two ends; tests put their faults here."""

    def heard(self, character: int) -> bytes:
        """Return what reaches the controller of a character that was sent to it."""
        ...

    def told(self, character: int) -> bytes:
        """Return what leaves of a character of the controller."""
        ...


class GoodLine:
    """Every character arrives."""

    def heard(self, character: int) -> bytes:
        """Return the character."""
        return bytes((character,))

    def told(self, character: int) -> bytes:
        """Return the character."""
        return bytes((character,))


class Emulator:
    """An emulated controller at a pseudo-terminal."""

    def __init__(self, machine: Machine, baud: float, clock: Callable[[], float]) -> None:
        """Open the pseudo-terminal; `port` is what takes the place of a serial port."""
        self._machine = machine
        self._clock = clock
        self._in, self._out = Paced(baud), Paced(baud)
        self._master, self._slave = os.openpty()
        tty.setraw(self._slave)
        os.set_blocking(self._master, False)
        self.port = os.ttyname(self._slave)
        self._at = clock()

    def serve(self, go_on: Callable[[], bool], line: Line | None = None) -> None:
        """Answer until told otherwise."""
        between = GoodLine() if line is None else line
        self._out.add(self._machine.greeting(), self._clock())
        while go_on():
            self._wait()
            now = self._clock()
            for at, sent in self._in.due(now):
                for character in between.heard(sent):
                    self._out.add(self._machine.receive(character), at)
            self._out.add(self._machine.pass_time(now - self._at), now)
            self._at = now
            leaving = b"".join(between.told(character) for _, character in self._out.due(now))
            if leaving:
                self._write(leaving)

    def close(self) -> None:
        """Take the pseudo-terminal away, as when a plug is pulled."""
        for end in (self._master, self._slave):
            if end >= 0:
                os.close(end)
        self._master = self._slave = -1

    def _wait(self) -> None:
        """Wait until something comes, or something that is under way is due."""
        due = [at for at in (self._in.next_at, self._out.next_at) if at is not None]
        wait_s = min((max(at - self._clock(), 0.0) for at in due), default=_SLOWEST_S)
        if select.select([self._master], [], [], min(wait_s, _SLOWEST_S))[0]:
            self._in.add(os.read(self._master, 4096), self._clock())

    def _write(self, data: bytes) -> None:
        """Write; what nobody reads is lost, as on a line where nobody listens."""
        try:
            os.write(self._master, data)
        except BlockingIOError:
            return
