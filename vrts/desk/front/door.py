"""Who comes in: whoever has the address with the token, which becomes a cookie at once.

The cookie is not sent by other sites, and no script can read it. What the address says is taken out
of it by a page that goes on to the desk: so that it is neither shown nor kept in the history.
"""

import hmac
from html import escape
from typing import Final

from starlette.datastructures import QueryParams
from starlette.requests import Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.types import ASGIApp, Receive, Scope, Send

from vrts.live.tokens import new_token

TOKEN: Final = "token"  # noqa: S105 -- the name of it, in the address
LONGEST: Final = 128  # characters of what is compared
ON: Final = '<!doctype html><meta charset="utf-8"><title>{0}</title>{1}<p>{2}</p>'


class Door:
    """Wraps the application; nothing reaches it without the cookie."""

    def __init__(self, app: ASGIApp, token: str, port: int) -> None:
        """Guard an application.

        Args:
            app: What is behind the door.
            token: That the address has.
            port: Cookies do not tell ports apart: its name does.
        """
        self._app = app
        self._token = token
        self._name = f"vrts_desk_{port}"
        self._cookie = new_token()  # another one, which is in no history

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Let in, or refuse."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
            return
        if scope["type"] != "http":
            return  # the connection ends
        request = Request(scope)
        if scope["path"] == "/" and TOKEN in QueryParams(scope["query_string"]):
            await self._entered(request)(scope, receive, send)
        elif _same(request.cookies.get(self._name, ""), self._cookie):
            await self._app(scope, receive, send)
        else:
            await _refusal(scope["path"])(scope, receive, send)

    def _entered(self, request: Request) -> Response:
        if request.method != "GET" or not _same(request.query_params[TOKEN], self._token):
            return _refusal("/")
        on = '<meta http-equiv="refresh" content="0;url=/">'
        answer = HTMLResponse(ON.format("The desk", on, '<a href="/">The desk</a>'))
        answer.set_cookie(
            self._name, self._cookie, path="/", httponly=True, samesite="strict", secure=False
        )
        return answer


def _same(given: str, right: str) -> bool:
    """Return whether a secret is the right one, in a time that tells nothing."""
    return len(given) <= LONGEST and hmac.compare_digest(given.encode(), right.encode())


def _refusal(path: str) -> Response:
    text = "open the address that `vrts grade desk` printed: it lets this browser in"
    if path == "/":
        return HTMLResponse(ON.format("Not let in", "", escape(text)), 401)
    return JSONResponse({"error": text}, 401)
