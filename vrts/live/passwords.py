"""Passwords of local accounts: argon2id, in threads, a few at once."""

import asyncio
from concurrent.futures import ThreadPoolExecutor
from typing import Final

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerificationError

AT_ONCE: Final = 2  # each takes 64 MiB and a quarter of a second
WAITING: Final = 16  # more than these are told to come back

_threads = ThreadPoolExecutor(AT_ONCE, "argon2")


class Passwords:
    """Hashes and compares without holding up anybody else."""

    def __init__(self) -> None:
        """Begin with nobody waiting."""
        self._under_way = 0

    async def right(self, password: str, kept: str | None) -> bool | None:
        """Return whether a password is the one whose hash was kept; None: too many at once.

        An account that is not there (`kept` is None) takes as long as one that is.
        """
        if self._under_way >= WAITING:
            return None
        self._under_way += 1
        try:
            loop = asyncio.get_running_loop()
            return await loop.run_in_executor(_threads, _right, password, kept)
        finally:
            self._under_way -= 1


def hashed(password: str) -> str:
    """Return what is kept of a password; takes a quarter of a second."""
    return PasswordHasher().hash(password)


def _right(password: str, kept: str | None) -> bool:
    if kept is None:
        PasswordHasher().hash(password)
        return False
    try:
        return PasswordHasher().verify(kept, password)
    except (VerificationError, InvalidHashError):
        return False
