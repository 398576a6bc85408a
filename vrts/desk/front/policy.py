"""What browsers may do with what the desk sends: little with its page, less with reports.

Reports are files that hold what students wrote. They run in a sandbox of their own, without the
desk's name: nothing in them can ask the desk for anything, whatever it is. Pages of what is alike
may run nothing at all. They keep the desk's name, so that their links lead to its other files.
"""

from typing import Final

from starlette.datastructures import MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

PAGE: Final = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:;"
    " font-src 'self'; connect-src 'self'; frame-src 'self'; base-uri 'none';"
    " form-action 'none'; frame-ancestors 'none'"
)
REPORT: Final = (
    "sandbox allow-scripts; default-src 'none'; script-src 'unsafe-inline' data:;"
    " style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none';"
    " frame-ancestors 'self'"
)
ALIKE: Final = (
    "default-src 'none'; style-src 'unsafe-inline'; img-src data:; frame-src 'self';"
    " base-uri 'none'; form-action 'none'; frame-ancestors 'self'"
)
FILES: Final = "/files/"
ALL_ALIKE: Final = "/files/staff/similarity"  # how addresses of what is alike begin


class Policy:
    """Wraps everything, and says so in the headers of every answer."""

    def __init__(self, app: ASGIApp) -> None:
        """Wrap an application."""
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        path: str = scope["path"]
        is_file = path.startswith(FILES)
        policy = ALIKE if path.startswith(ALL_ALIKE) else REPORT if is_file else PAGE

        async def bound(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(raw=message.setdefault("headers", []))
                headers["content-security-policy"] = policy
                headers["x-frame-options"] = "SAMEORIGIN" if is_file else "DENY"
            await send(message)

        await self._app(scope, receive, bound)
