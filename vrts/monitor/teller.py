"""What the terminal shows of the events of a run."""

from collections.abc import Iterable
from typing import NamedTuple

from vrts.engine.memory.events import (
    Answered,
    CommandRefused,
    Event,
    Found,
    Printed,
    ProgramEnded,
    ProgramStarted,
)
from vrts.monitor import words
from vrts.monitor.desk import ALONE

_REASONS = {"paused": "(PAUSED)\n", "halted": "(HALTED)\n", "aborted": "(ABORTED)\n"}


class Standing(NamedTuple):
    """Where a terminal stands."""

    at_start: bool = True  # of a line
    alone: bool = False  # what executes is the instruction of a DO
    answers: tuple[str, ...] = ()  # typed, and not yet read by the program
    echo: str = ""  # of an answer, which the terminal has shown while it was typed


class Teller:
    """Turns events into text; knows where the terminal stands."""

    def __init__(self) -> None:
        """Begin at the start of a line."""
        self._at_start = True
        self._alone = False  # whether what executes is the instruction of a DO
        self._answers: list[str] = []  # typed, and not yet read by the program
        self._echo = ""  # of an answer, which the terminal has shown while it was typed

    @property
    def standing(self) -> Standing:
        """Where the terminal stands, for one that goes on elsewhere."""
        return Standing(self._at_start, self._alone, tuple(self._answers), self._echo)

    def stand(self, standing: Standing) -> None:
        """Go on where another one stood."""
        self._at_start, self._alone, self._echo = standing.at_start, standing.alone, standing.echo
        self._answers = list(standing.answers)

    def typed(self) -> None:
        """Note that RETURN was pressed."""
        self._at_start = True

    def answered(self, text: str) -> None:
        """Note an answer that was typed."""
        self._answers.append(text)

    def words(self, text: str) -> str:
        """Return words of the monitor: they begin on a line of their own."""
        return self._after(text if self._at_start or not text else f"\n{text}")

    def told(self, events: Iterable[Event]) -> str:
        """Return what is shown of events, in their order."""
        return "".join(map(self._told, events))

    def _told(self, event: Event) -> str:
        match event:
            case Printed():
                if self._echo and event.text == self._echo:
                    self._echo = ""
                    return ""
                return self._after(event.text.replace("\r\n", "\n"))
            case Answered():
                if self._answers and self._answers[0][: len(event.text)] == event.text:
                    self._answers.pop(0)
                    self._echo = f"{event.text}\r\n"
                return ""
            case CommandRefused():
                return self.words(words.starred(event.words))
            case Found():
                if event.diagnostic.is_error:
                    return self.words(words.refusal(event.diagnostic))
                return self.words(
                    f"{event.diagnostic.severity.value}: {event.diagnostic.headline}\n"
                )
            case ProgramStarted():
                if not event.process:
                    self._alone = event.program == ALONE
                return ""
            case ProgramEnded():
                return self.words(self._ended(event))
            case _:
                return ""

    def _ended(self, event: ProgramEnded) -> str:
        if self._alone and not event.process:
            self._alone = False
            return ""  # a single instruction comes and goes
        which = "Process control program" if event.process else "Program"
        if event.ending == "completed":
            return f"{which} completed\n"
        where = f" at {event.cause.program}, step {event.cause.step}" if event.cause else ""
        return f"{_REASONS.get(event.ending, '')}{which} stopped{where}\n"

    def _after(self, text: str) -> str:
        if text:
            self._at_start = text.endswith("\n")
        return text
