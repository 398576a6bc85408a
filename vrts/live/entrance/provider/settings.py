"""What a server is told of a provider, without loading anything that could connect to it."""

import ipaddress
from pathlib import Path
from typing import Final, NamedTuple
from urllib.parse import urlsplit

BUTTON: Final = "Log in with your organisation"
LONGEST_SECRET: Final = 1024  # bytes
_FORBIDDEN: Final = 0o077  # nobody but the owner may do anything with the file of a secret


class ProviderSettings(NamedTuple):
    """Of one provider."""

    issuer: str  # address, as the provider calls itself
    client: str  # what the provider calls this server
    secret: Path | None = None  # file with what proves that; None: the provider wants nothing
    claim: str = "email"  # what people are known by when they come for the first time
    button: str = BUTTON


def wrong_with(address: str) -> str:
    """Return why an address of a provider cannot be used; empty: it can."""
    try:
        parts = urlsplit(address)
        port = parts.port
    except ValueError:
        return "it is no address"
    del port
    if parts.scheme not in ("https", "http") or not parts.hostname:
        return "it has to begin with `https://`"
    if parts.username or parts.password or parts.query or parts.fragment:
        return "it may have neither a user nor `?` nor `#`"
    if parts.scheme == "http" and not _loopback(parts.hostname):
        return "only on this machine itself it may do without https"
    return ""


def wrong_with_secret(path: Path, course: Path) -> str:
    """Return why a file cannot hold the secret; empty: it can.

    Args:
        path: Of the file.
        course: Folder that the secret may not be in, since it is handed on.
    """
    if path.resolve().is_relative_to(course.resolve()):
        return "it lies in the folder of the course: put it elsewhere"
    try:
        mode = path.stat().st_mode
    except OSError:
        return "there is no such file"
    if mode & _FORBIDDEN:
        return f"others may read it: `chmod 600 {path}`"
    return ""


def read_secret(path: Path | None) -> str:
    """Return the secret of a provider's settings; empty: there is none.

    Raises:
        OSError: It cannot be read.
        ValueError: It is no text, or too long.
    """
    if path is None:
        return ""
    with path.open("rb") as file:
        data = file.read(LONGEST_SECRET + 1)
    if len(data) > LONGEST_SECRET:
        raise ValueError(f"it has more than {LONGEST_SECRET} bytes")
    return data.decode("utf-8").strip()


def _loopback(host: str) -> bool:
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"
