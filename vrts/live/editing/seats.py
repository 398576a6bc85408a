"""Who has a language server: each person one, all together so many."""

import asyncio
from collections.abc import Hashable
from pathlib import Path
from typing import Final, Generic, TypeVar

from vrts.live.lasting.clock import steady
from vrts.live.limits import Bucket

MOST: Final = 40  # at once; each takes about 55 MB
BEGUN: Final = (0.1, 6.0)  # by one person, a second and at once: each costs 0.6 s of processor
REMEMBERED: Final = 2000  # persons whose beginnings are counted
QUIET_S: Final = 30.0  # without a message, after which a seat is given to who finds none free


Whose = TypeVar("Whose", bound=Hashable)


class Seat(Generic[Whose]):
    """The right to one language server, or another process."""

    def __init__(self, whose: Whose) -> None:
        """Give it to somebody."""
        self.whose = whose
        self.taken = asyncio.Event()  # somebody else has it now, or the server ends
        self.wanted = False  # it was taken for another person
        self.heard_s = steady()  # when its browser said something last


class Seats(Generic[Whose]):
    """Gives seats, and takes back that of a person who opens the editor once more."""

    def __init__(
        self,
        place: Path,
        most: int = MOST,
        *,
        begun: tuple[float, float] = BEGUN,
        quiet_s: float = QUIET_S,
    ) -> None:
        """Begin with none given.

        Args:
            place: Where processes begin, made when needed.
            most: Seats.
            begun: How many one person may take a second, and at once.
            quiet_s: After so long without a message a seat is given to who finds none free [s].
        """
        self._most = most
        self._often = begun
        self._quiet_s = quiet_s
        self._of: dict[Whose, Seat[Whose]] = {}
        self._begun: dict[Whose, Bucket] = {}
        self._place = place

    @property
    def folder(self) -> Path:
        """A folder that stays empty."""
        self._place.mkdir(mode=0o700, parents=True, exist_ok=True)
        return self._place

    def take(self, whose: Whose) -> Seat[Whose] | None:
        """Return a seat; None where all are given to others, or somebody begins too often.

        Where all are given, the one goes in which nothing was written for longest.
        """
        bucket = self._begun.setdefault(whose, Bucket(*self._often))
        if not bucket.take(steady()):
            return None
        while len(self._begun) > REMEMBERED:
            del self._begun[next(iter(self._begun))]
        before = self._of.get(whose)
        if before is not None:
            before.taken.set()
        elif len(self._of) >= self._most and not self._free():
            return None
        seat = self._of[whose] = Seat(whose)
        return seat

    def _free(self) -> bool:
        """Take back the seat that is quiet for longest; return whether there is one."""
        seat = min(self._of.values(), key=lambda one: one.heard_s)
        if steady() - seat.heard_s < self._quiet_s:
            return False
        del self._of[seat.whose]
        seat.wanted = True
        seat.taken.set()
        return True

    def give_back(self, seat: Seat[Whose]) -> None:
        """Take a seat back from who has no use for it."""
        if self._of.get(seat.whose) is seat:
            del self._of[seat.whose]

    def stop(self) -> None:
        """Take all seats back."""
        for seat in self._of.values():
            seat.taken.set()
