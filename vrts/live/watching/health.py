"""Whether a server is well: a few numbers for a monitoring program, about nobody."""

import asyncio
import time
from typing import Final

import msgspec
from starlette.requests import Request
from starlette.responses import Response

from vrts.live.rooms.hub import Hub
from vrts.live.store.database import Connection, Failed

FRESH_S: Final = 5.0  # an answer is given again for so long: asking often costs nothing
WRITE_S: Final = 3.0  # how long a write may take
UNWRITTEN: Final = "the database cannot be written"
DYING: Final = "sessions keep dying"


class Health(msgspec.Struct, frozen=True):
    """What is told."""

    status: str  # "ok" or "failing"
    problems: tuple[str, ...]
    up_s: float  # since it was started
    rooms: int
    sessions: int  # that run
    waiting: int  # rooms whose session has died too often, or whose scene is not offered
    people: int  # connected


class HealthPage:
    """The address `/health`: 200 when all is well, 503 when it is not. Nobody logs in for it."""

    def __init__(self, hub: Hub) -> None:
        """Watch a hub."""
        self._hub = hub
        self._began = self._asked = time.monotonic()
        self._writes = True
        self._looked = False
        self._looking = asyncio.Lock()

    async def answer(self, _: Request) -> Response:
        """Return the answer."""
        await self.look()
        health = self.now()
        status = 200 if health.status == "ok" else 503
        data = msgspec.json.encode(health)
        return Response(data, status, media_type="application/json")

    async def look(self) -> None:
        """Try whether the database can be written, if that was not done a moment ago."""
        async with self._looking:  # one look, however many ask
            if not self._looked or time.monotonic() - self._asked > FRESH_S:
                self._writes, self._looked = await self._written(), True
                self._asked = time.monotonic()

    def now(self) -> Health:
        """Return what is known now; whether the database can be written was tried lately."""
        rooms = self._hub.rooms.values()
        shared = [room for room in rooms if room.shared]  # a private one is its owner's
        dying = any(room.waits is not None and room.offered for room in shared)
        problems = ((UNWRITTEN,) if not self._writes else ()) + ((DYING,) if dying else ())
        return Health(
            status="failing" if problems else "ok",
            problems=problems,
            up_s=round(time.monotonic() - self._began, 1),
            rooms=len(rooms),
            sessions=sum(room.process is not None and room.process.ready for room in rooms),
            waiting=sum(room.waits is not None and not room.asleep for room in rooms),
            people=sum(member.door is not None for member in self._hub.everybody()),
        )

    async def _written(self) -> bool:
        """Return whether something can be written and committed within a while."""
        job = self._hub.database.do(_write)
        try:
            await asyncio.wait_for(job, WRITE_S)
        except (Failed, TimeoutError):
            return False
        return True


def _write(connection: Connection) -> None:
    connection.execute(
        "INSERT INTO counter VALUES ('health', 1) ON CONFLICT (name) DO UPDATE SET value=value+1"
    )
