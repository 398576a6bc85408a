"""Answers are sent in pieces, each when there is room for it: none waits in memory twice.

An answer that goes to the network in one piece counts as given at once, however slow the network
is; so who takes it could not be told from who says nothing (see `patient`).
"""

from typing import Final

from starlette.types import ASGIApp, Message, Receive, Scope, Send

PIECE: Final = 64 * 1024  # bytes


class InPieces:
    """An application whose answers are sent so."""

    def __init__(self, app: ASGIApp) -> None:
        """Serve an application."""
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request."""

        async def in_pieces(message: Message) -> None:
            body = message.get("body", b"")
            if message["type"] != "http.response.body" or len(body) <= PIECE:
                await send(message)
                return
            for at in range(0, len(body), PIECE):
                more = at + PIECE < len(body) or message.get("more_body", False)
                await send({**message, "body": body[at : at + PIECE], "more_body": more})

        await self._app(scope, receive, in_pieces if scope["type"] == "http" else send)
