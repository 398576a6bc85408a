"""What stands before everything else: `Host`, `Origin`, and headers that bind browsers."""

from email.utils import formatdate
from typing import Final

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from vrts.live.front.hop import Hop
from vrts.live.front.origin import Names
from vrts.live.lasting.clock import wall

POLICY: Final = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:;"
    " font-src 'self'; manifest-src 'self'; base-uri 'none'; form-action 'none';"
    " frame-ancestors 'none'; connect-src 'self'"
)
HEADERS: Final = {
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "permissions-policy": "camera=(), microphone=(), geolocation=(), payment=(), usb=()",
    "referrer-policy": "no-referrer",
    "x-content-type-options": "nosniff",
    "x-frame-options": "DENY",
}
SECURE: Final = "max-age=31536000"  # Strict-Transport-Security


class Guard:
    """Wraps the application; nothing reaches it under a foreign name or from a foreign page."""

    def __init__(self, app: ASGIApp, names: Names, *, secure: bool, hop: Hop | None = None) -> None:
        """Guard an application; `hop`: a proxy on this machine passes requests on."""
        self._app = app
        self._hop = hop
        self._names = names
        self._secure = secure

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Refuse, or pass on."""
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        host = headers.get("host", "")
        if self._hop is not None:
            scope["client"] = (self._hop.client(scope, headers), 0)

        async def guarded(message: Message) -> None:
            if message["type"] in ("http.response.start", "websocket.http.response.start"):
                self._bind(MutableHeaders(raw=message.setdefault("headers", [])), host)
            await send(message)

        refusal = self._refusal(scope, headers, host)
        if refusal is None:
            await self._app(scope, receive, guarded)
        elif scope["type"] == "http":
            await refusal(scope, receive, guarded)
        else:
            await receive()  # the request to connect
            await refusal(_as_denial(scope), receive, guarded)

    def _refusal(self, scope: Scope, headers: Headers, host: str) -> JSONResponse | None:
        if not self._names.known(host) or len(headers.getlist("host")) != 1:
            return refused(
                421, "host", "the server does not answer to this name", "start it with `--name`"
            )
        reads = scope["type"] == "http" and scope["method"] in ("GET", "HEAD")
        origins = headers.getlist("origin")
        if reads and not origins:
            return None
        if len(origins) != 1 or not self._names.own_page(origins[0], host):
            return refused(403, "origin", "a page of another site asked this")
        return None

    def _bind(self, headers: MutableHeaders, host: str) -> None:
        for name, value in HEADERS.items():
            headers[name] = value
        headers["date"] = formatdate(wall(), usegmt=True)  # by which pages show what ends when
        sockets = f" ws://{host} wss://{host}"  # older browsers do not count them as 'self'
        if "content-security-policy" not in headers:  # a page in a sandbox has its own
            headers["content-security-policy"] = POLICY + sockets
        if "cache-control" not in headers:
            headers["cache-control"] = "no-store"
        if self._secure:
            headers["strict-transport-security"] = SECURE


def refused(status: int, code: str, text: str, help_: str = "") -> JSONResponse:
    """Return a refusal."""
    return JSONResponse({"code": code, "text": text, "help": help_}, status)


def _as_denial(scope: Scope) -> Scope:
    """Return the scope with which a response denies a WebSocket."""
    return {**scope, "type": "websocket"}
