"""Blocks of a session's past: each is asked of the session once, however many people look."""

import asyncio
import base64
import time
from collections import OrderedDict
from collections.abc import Callable
from typing import Final, NamedTuple

import msgspec

from vrts.live.refusal import NotObeyed

FRESH_S: Final = 1.0  # how long a block that still grows is given out without asking again
MOST_BYTES: Final = 16_000_000  # of a room
PATIENCE_S: Final = 60.0  # how long an answer may take
JUMPED: Final = "session time has jumped, or the session ended"


class Answer(msgspec.Struct, frozen=True):
    """What the server reads of the session's `Looked`."""

    data: str = ""
    whole: bool = False
    why: str = ""


class _Kept(NamedTuple):
    data: bytes  # JSON, gzipped
    until: float  # monotonic time until which it may be given out [s]; inf: it is whole


_answers = msgspec.json.Decoder(Answer)


class Blocks:
    """What is known of the past of one room's session."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        """Begin with nothing; `clock` only goes forward [s]."""
        self._clock = clock
        self._kept: OrderedDict[int, _Kept] = OrderedDict()
        self._asked: dict[int, asyncio.Future[bytes]] = {}  # by number of the block
        self._numbers: dict[int, int] = {}  # by reference of the question
        self.asks = 0  # questions that a session was asked

    async def get(self, number: int, ask: Callable[[int], int]) -> bytes:
        """Return a block as gzipped JSON.

        Args:
            number: Of the block.
            ask: Asks the session for a block; returns the reference of its answer.

        Raises:
            NotObeyed: The session cannot tell it, or not in time.
        """
        kept = self._kept.get(number)
        if kept is not None and self._clock() < kept.until:
            self._kept.move_to_end(number)
            return kept.data
        coming = self._asked.get(number)
        if coming is None:
            coming = asyncio.get_running_loop().create_future()
            self._asked[number] = coming
            self._numbers[ask(number)] = number
            self.asks += 1
        try:
            return await asyncio.wait_for(asyncio.shield(coming), PATIENCE_S)
        except TimeoutError:
            if self._asked.get(number) is coming:
                self.forget()
            raise NotObeyed("busy", "the session did not answer in time", "try again") from None

    def answered(self, ref: int, message: bytes) -> None:
        """Take an answer of the session."""
        number = self._numbers.pop(ref, None)
        if number is None:
            return  # asked before session time jumped
        coming = self._asked.pop(number)
        answer = _answers.decode(message)
        if answer.why:
            _refuse(coming, NotObeyed("past", answer.why))
            return
        data = base64.b64decode(answer.data)
        until = float("inf") if answer.whole else self._clock() + FRESH_S
        self._kept[number] = _Kept(data, until)
        self._kept.move_to_end(number)
        while sum(len(kept.data) for kept in self._kept.values()) > MOST_BYTES:
            self._kept.popitem(last=False)
        if not coming.done():
            coming.set_result(data)

    def forget(self) -> None:
        """Session time has jumped, or there is no session: nothing that is known counts."""
        asked, self._asked = self._asked, {}
        self._numbers.clear()
        self._kept.clear()
        for coming in asked.values():
            _refuse(coming, NotObeyed("jumped", JUMPED, "try again"))


def _refuse(coming: "asyncio.Future[bytes]", why: NotObeyed) -> None:
    if not coming.done():
        coming.set_exception(why)
        coming.exception()  # if nobody waits any more, nobody needs to hear it
