"""Who may talk to the server: requests under its own names, from pages of its own.

A page of a foreign site can open a WebSocket to 127.0.0.1, and its own name can be made to point
there (DNS rebinding): so both the `Host` asked for and the `Origin` that asks are looked at before
anything is accepted. An address in figures cannot be rebound; other names must be known.
"""

import ipaddress
from collections.abc import Iterable
from urllib.parse import urlsplit


class Names:
    """The names that the server answers to."""

    def __init__(self, names: Iterable[str]) -> None:
        """Take names without ports; `localhost` and addresses in figures are always among them."""
        self._names = frozenset({"localhost", *(name.lower().rstrip(".") for name in names)})

    def known(self, host: str) -> bool:
        """Return whether a `Host` header is one of ours."""
        name = _split(host)
        if name is None:
            return False
        return name[0] in self._names or _is_address(name[0])

    def own_page(self, origin: str, host: str) -> bool:
        """Return whether an `Origin` header is a page that came from the `Host` asked."""
        try:
            parts = urlsplit(origin)
        except ValueError:
            return False
        if parts.scheme not in ("http", "https") or parts.path or parts.query or parts.fragment:
            return False
        theirs, ours = _split(parts.netloc), _split(host)
        if theirs is None or ours is None or not self.known(host):
            return False
        usual = 443 if parts.scheme == "https" else 80
        return (theirs[0], theirs[1] or usual) == (ours[0], ours[1] or usual)


def _split(netloc: str) -> tuple[str, int | None] | None:
    """Return name and port, None when it is neither."""
    if "@" in netloc or "/" in netloc:
        return None
    try:
        parts = urlsplit(f"//{netloc}")
        name, port = parts.hostname, parts.port
    except ValueError:
        return None
    return None if not name else (name.lower().rstrip("."), port)


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
