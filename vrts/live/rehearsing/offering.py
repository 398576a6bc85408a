"""What a server has for rehearsals: seats, and one process that is warm before it is needed."""

import asyncio
from contextlib import suppress
from pathlib import Path
from typing import Final, NamedTuple

from vrts.live.editing.seats import Seats
from vrts.live.limits import Buckets
from vrts.live.rehearsing.process import RehearsalProcess, begun

MOST: Final = 12  # rehearsals at once; each takes about 100 MB
BEGUN: Final = (
    0.2,
    10.0,
)  # rehearsals of one account, and seats of one in a room: a second, at once
NOWS: Final = (0.5, 6.0)  # states of a session that are asked for: it pays for a fork
QUIET_S: Final = 60.0  # without a question, after which a seat is given to who finds none free
AFTER_S: Final = 2.0  # in which who rehearses has the processor for themselves
SPARE_S: Final = 600.0  # for which a process waits that nobody needs


class Whose(NamedTuple):
    """Who rehearses, and where: they have one rehearsal."""

    account: int
    room: str


class Rehearsals:
    """Gives seats and processes."""

    def __init__(self, place: Path, most: int = MOST) -> None:
        """Begin with none; `place` is a folder that stays empty, made when needed."""
        self.seats: Seats[Whose] = Seats(place, most, begun=BEGUN, quiet_s=QUIET_S)
        self.often = Buckets(*BEGUN)  # how often each account begins
        self.nows = Buckets(*NOWS)  # how often each account begins at now
        self._open: dict[Whose, asyncio.Event] = {}
        self._spare: asyncio.Task[RehearsalProcess] | None = None
        self._over: asyncio.TimerHandle | None = None  # when nobody needed the spare one
        self._ending: set[asyncio.Task[None]] = set()
        self._stopped = False

    def connected(self, whose: Whose) -> asyncio.Event:
        """Note a connection; return what is set when the same person opens another one."""
        if (before := self._open.get(whose)) is not None:
            before.set()
        event = self._open[whose] = asyncio.Event()
        return event

    def left(self, whose: Whose, event: asyncio.Event) -> None:
        """Forget a connection."""
        if self._open.get(whose) is event:
            del self._open[whose]

    async def process(self) -> RehearsalProcess:
        """Return a process, and have another one begin for whoever comes next.

        Raises:
            OSError: The system has none to give.
        """
        spare, self._spare = self._spare, None
        self._expect()
        if spare is not None:
            with suppress(OSError):
                waiting = await self._shielded(spare)
                if waiting.alive:
                    return waiting
                await waiting.end()
        loop = asyncio.get_running_loop()
        return await self._shielded(loop.create_task(begun(self.seats.folder)))

    async def _shielded(self, coming: "asyncio.Task[RehearsalProcess]") -> RehearsalProcess:
        """Return a process once it has begun; where nobody waits any more, end it."""
        try:
            return await asyncio.shield(coming)
        except asyncio.CancelledError:
            self._end_later(coming)
            raise

    async def stop(self) -> None:
        """Take all seats back, and end what waits."""
        self._stopped = True
        self.seats.stop()
        for event in self._open.values():
            event.set()
        self._let_go()
        await asyncio.gather(*self._ending, return_exceptions=True)

    # --- the spare one ------------------------------------------------------------------------

    def _expect(self) -> None:
        if self._over is not None:
            self._over.cancel()
        if self._stopped:
            return
        loop = asyncio.get_running_loop()
        self._over = loop.call_later(AFTER_S, self._prepare)

    def _prepare(self) -> None:
        loop = asyncio.get_running_loop()
        if self._spare is None:
            self._spare = loop.create_task(begun(self.seats.folder, warm=True))
        self._over = loop.call_later(SPARE_S, self._let_go)

    def _let_go(self) -> None:
        if self._over is not None:
            self._over.cancel()
        spare, self._spare = self._spare, None
        if spare is not None:
            self._end_later(spare)

    def _end_later(self, coming: "asyncio.Task[RehearsalProcess]") -> None:
        task = asyncio.get_running_loop().create_task(_end(coming))
        self._ending.add(task)
        task.add_done_callback(self._ending.discard)


async def _end(coming: "asyncio.Task[RehearsalProcess]") -> None:
    with suppress(OSError):
        await (await coming).end()
