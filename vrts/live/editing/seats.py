"""Who has a language server: each person one, all together so many."""

import asyncio
import time
from pathlib import Path
from typing import Final

from vrts.live.limits import Bucket

MOST: Final = 40  # at once; each takes about 55 MB
BEGUN: Final = (0.1, 6.0)  # by one person, a second and at once: each costs 0.6 s of processor
REMEMBERED: Final = 2000  # persons whose beginnings are counted
QUIET_S: Final = 30.0  # without a message, after which a seat is given to who finds none free


class Seat:
    """The right to one language server."""

    def __init__(self, account: int) -> None:
        """Give it to somebody."""
        self.account = account
        self.taken = asyncio.Event()  # somebody else has it now, or the server ends
        self.wanted = False  # it was taken for another person
        self.heard_s = time.monotonic()  # when its browser said something last


class Seats:
    """Gives seats, and takes back that of a person who opens the editor once more."""

    def __init__(self, place: Path, most: int = MOST) -> None:
        """Begin with none given; `place` is where language servers begin, made when needed."""
        self._most = most
        self._of: dict[int, Seat] = {}
        self._begun: dict[int, Bucket] = {}
        self._place = place

    @property
    def folder(self) -> Path:
        """A folder that stays empty."""
        self._place.mkdir(mode=0o700, parents=True, exist_ok=True)
        return self._place

    def take(self, account: int) -> Seat | None:
        """Return a seat; None where all are given to others, or somebody begins too often.

        Where all are given, the one goes in which nothing was written for longest.
        """
        bucket = self._begun.setdefault(account, Bucket(*BEGUN))
        if not bucket.take(time.monotonic()):
            return None
        while len(self._begun) > REMEMBERED:
            del self._begun[next(iter(self._begun))]
        before = self._of.get(account)
        if before is not None:
            before.taken.set()
        elif len(self._of) >= self._most and not self._free():
            return None
        seat = self._of[account] = Seat(account)
        return seat

    def _free(self) -> bool:
        """Take back the seat that is quiet for longest; return whether there is one."""
        seat = min(self._of.values(), key=lambda one: one.heard_s)
        if time.monotonic() - seat.heard_s < QUIET_S:
            return False
        del self._of[seat.account]
        seat.wanted = True
        seat.taken.set()
        return True

    def give_back(self, seat: Seat) -> None:
        """Take a seat back from who has no use for it."""
        if self._of.get(seat.account) is seat:
            del self._of[seat.account]

    def stop(self) -> None:
        """Take all seats back."""
        for seat in self._of.values():
            seat.taken.set()
