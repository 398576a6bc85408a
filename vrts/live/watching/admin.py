"""The admin page's numbers over HTTP: for supervisors who have an account of their own."""

import time
from typing import Final

import msgspec
from starlette.requests import Request
from starlette.responses import Response

from vrts.live.rooms.hub import Hub
from vrts.live.store.accounts import Who
from vrts.live.watching.health import HealthPage
from vrts.live.watching.log_tail import follow_log
from vrts.live.watching.machine import Machine
from vrts.live.watching.overview import guests, may_administer, overview

FRESH_S: Final = 1.0  # an answer is given again for so long
REFUSED: Final = {
    "code": "role",
    "text": "only a supervisor with an account of their own sees this page",
    "help": "make one with `vrts serve --folder FOLDER --add-user NAME --supervisor`, and log in",
}


class AdminPage:
    """The address `/admin/now`."""

    def __init__(self, hub: Hub, who: Who, health: HealthPage) -> None:
        """Serve a hub; `who` tells whose cookies those are."""
        self._hub = hub
        self._who = who
        self._health = health
        self._machine = Machine(hub.settings.folder)
        self._log = follow_log()
        self._known = b""
        self._at = 0.0

    async def now(self, request: Request) -> Response:
        """Return everything that the page shows."""
        account = await self._who(request.cookies)
        allowed = account is not None and await self._hub.database.do(
            lambda connection: may_administer(connection, account.id)
        )
        if not allowed:
            return _json(msgspec.json.encode(REFUSED), 403)
        if not self._known or time.monotonic() - self._at > FRESH_S:
            self._at = time.monotonic()
            await self._health.look()
            count = await self._hub.database.do(guests)
            log = tuple(reversed(self._log.entries))
            found = overview(self._hub, self._health.now(), self._machine.load(), log, count)
            self._known = msgspec.json.encode(found)
        return _json(self._known, 200)


def _json(data: bytes, status: int) -> Response:
    return Response(data, status, media_type="application/json")
