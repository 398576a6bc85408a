"""From where a request came that a proxy on this machine passed on.

Only the last entry of `X-Forwarded-For` is believed: the proxy wrote it. What stands before it may
be the client's own words. A proxy that adds its entry never passes a request on without one. So
where one comes without, the proxy adds none, and whatever others hold was written by clients: none
is believed any more. Everybody then counts as one address, which refuses nobody.
"""

import ipaddress
from collections.abc import Callable, Iterable
from typing import Final

from starlette.datastructures import Headers
from starlette.types import Scope

HEADER: Final = "x-forwarded-for"
UNKNOWN: Final = "behind the proxy"
WARNING: Final = (
    "the proxy does not say where requests come from, so all count as one address:"
    " let it set X-Forwarded-For (nginx: `proxy_set_header X-Forwarded-For $remote_addr;`)"
)


class Hop:
    """The proxy's own hop."""

    def __init__(self, names: Iterable[str], say: Callable[[str], None]) -> None:
        """Take the names under which the proxy is reached; `say` writes a line, once."""
        self._names = frozenset(name.lower().rstrip(".") for name in names)
        self._say = say
        self._believed = True

    def client(self, scope: Scope, headers: Headers) -> str:
        """Return from which address a request came."""
        peer = str(scope["client"][0]) if scope.get("client") else ""
        if not _here(peer):
            return peer  # straight to the server, past the proxy
        told = headers.getlist(HEADER)
        if not told and self._passed_on(headers):
            if self._believed:
                self._believed = False
                self._say(WARNING)
            return UNKNOWN
        if not told:
            return peer  # of this machine, such as what watches its health
        return (_address(told[-1].split(",")[-1]) if self._believed else "") or UNKNOWN

    def _passed_on(self, headers: Headers) -> bool:
        """Return whether a request was made to a name of the proxy."""
        host = headers.get("host", "").lower()
        name = host if host.endswith("]") else host.rpartition(":")[0] or host
        return name.rstrip(".") in self._names


def _here(peer: str) -> bool:
    try:
        return ipaddress.ip_address(peer).is_loopback
    except ValueError:
        return False


def _address(told: str) -> str:
    """Return an address of an entry, some proxies add the port; empty: it is none."""
    text = told.strip()
    if text.startswith("["):
        text = text[1:].partition("]")[0]
    elif text.count(":") == 1:
        text = text.partition(":")[0]
    try:
        return str(ipaddress.ip_address(text))
    except ValueError:
        return ""
