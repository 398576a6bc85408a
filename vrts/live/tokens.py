"""Secrets that are handed out: opaque, random, and kept only as their digest."""

import hashlib
import secrets
from typing import Final

LETTERS: Final = "ABCDEFGHJKMNPQRSTUVWXYZ23456789"  # none that look alike
SHORTEST_LINK: Final = 40  # characters of a link's token at least; a class code has fewer


def new_token() -> str:
    """Return a secret of 256 bits, safe in a URL."""
    return secrets.token_urlsafe(32)


def new_code(length: int) -> str:
    """Return a class code that can be read out; how long it must be, `entrance/guessing` says."""
    return "".join(secrets.choice(LETTERS) for _ in range(length))


def is_code(text: str) -> bool:
    """Return whether something that was typed is read as a class code, not as a link's token."""
    return len(text) < SHORTEST_LINK


def plain_code(typed: str) -> str:
    """Return a code as it was made: codes are typed in any case, with blanks or hyphens."""
    return "".join(typed.upper().split()).replace("-", "")


def grouped(code: str) -> str:
    """Return a code as it is shown: in groups of three or four, which are easy to read out."""
    groups = max(1, len(code) // 3)
    size, longer = divmod(len(code), groups)
    shown: list[str] = []
    at = 0
    for number in range(groups):
        end = at + size + (number >= groups - longer)
        shown.append(code[at:end])
        at = end
    return "-".join(shown)


def new_id() -> str:
    """Return a short name that says nothing."""
    return secrets.token_hex(4)


def digest(token: str) -> bytes:
    """Return what is kept of a secret."""
    return hashlib.sha256((plain_code(token) if is_code(token) else token).encode()).digest()
