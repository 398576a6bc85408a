"""The past of a room's session over HTTP: blocks that a browser plays by itself."""

import gzip

from starlette.requests import Request
from starlette.responses import Response

from vrts.live.front.guard import refused
from vrts.live.lasting.clock import steady
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import Hub
from vrts.live.store.accounts import Who


class PastPages:
    """The handlers."""

    def __init__(self, hub: Hub, who: Who) -> None:
        """Serve a hub; `who` tells whose cookies those are."""
        self._hub = hub
        self._who = who

    async def block(self, request: Request) -> Response:
        """Return a block of a session's past, to those who are in its room."""
        account = await self._who(request.cookies)
        if account is None:
            return refused(401, "login", "nobody is logged in", "open the join link again")
        session, number = request.path_params["session"], request.path_params["number"]
        room = self._hub.rooms.get(request.path_params["room"])
        if room is None or room.session != session or number > 200_000:
            return refused(404, "past", "there is no such past any more")
        members = [m for m in room.members.values() if m.account.id == account.id]
        if not members:
            return refused(403, "room", "only people in a room may look at its past")
        if not members[0].looks.take(steady()):
            return refused(429, "rate", "too many questions at once", "wait a moment")
        process = room.process
        if process is None or not process.ready or process.behind:
            return refused(503, "session", "the session is not ready yet", "wait a moment")
        try:
            data = await room.blocks.get(number, process.ask_block)
        except NotObeyed as why:
            return refused(409 if why.code == "past" else 503, why.code, str(why), why.help)
        headers = {"cache-control": "private, no-store", "vary": "accept-encoding"}
        if "gzip" in request.headers.get("accept-encoding", ""):
            headers["content-encoding"] = "gzip"
        else:
            data = gzip.decompress(data)
        return Response(data, headers=headers, media_type="application/json")
