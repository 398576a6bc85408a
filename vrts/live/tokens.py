"""Secrets that are handed out: opaque, random, and kept only as their digest."""

import hashlib
import secrets
from typing import Final

LETTERS: Final = "ABCDEFGHJKMNPQRSTUVWXYZ23456789"  # none that look alike
CODE_LENGTH: Final = 6


def new_token() -> str:
    """Return a secret of 256 bits, safe in a URL."""
    return secrets.token_urlsafe(32)


def new_code() -> str:
    """Return a class code that can be read out: 30 bits, so failures to guess it are counted."""
    return "".join(secrets.choice(LETTERS) for _ in range(CODE_LENGTH))


def new_id() -> str:
    """Return a short name that says nothing."""
    return secrets.token_hex(4)


def digest(token: str) -> bytes:
    """Return what is kept of a secret; codes are read in any case, with blanks or hyphens."""
    if len(token) < 2 * CODE_LENGTH:
        token = token.upper().replace(" ", "").replace("-", "")
    return hashlib.sha256(token.encode()).digest()
