"""Passwords of local accounts: argon2id, in threads, a few at once."""

import asyncio
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from typing import Final

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerificationError

AT_ONCE: Final = 2  # each takes 64 MiB and a quarter of a second
WAITING: Final = 64  # more than these are told to come back
OF_ONE: Final = 4  # waiting of one source: no address can take all places

_threads = ThreadPoolExecutor(AT_ONCE, "argon2")


class Passwords:
    """Hashes and compares without holding up anybody else."""

    def __init__(self) -> None:
        """Begin with nobody waiting."""
        self._under_way: Counter[str] = Counter()

    async def right(
        self, password: str, kept: str | None, source: str, *, known: bool = False
    ) -> bool | None:
        """Return whether a password is the one whose hash was kept; None: too many at once.

        An account that is not there (`kept` is None) takes as long as one that is.

        Args:
            password: What was typed.
            kept: The hash.
            source: From where it comes: an address, or a browser that is known.
            known: It is such a browser, and no crowd of others stands before it.
        """
        crowded = not known and self._under_way.total() >= WAITING
        if crowded or self._under_way[source] >= OF_ONE:
            return None
        self._under_way[source] += 1
        try:
            loop = asyncio.get_running_loop()
            return await loop.run_in_executor(_threads, _right, password, kept)
        finally:
            self._under_way[source] -= 1
            if not self._under_way[source]:
                del self._under_way[source]


def hashed(password: str) -> str:
    """Return what is kept of a password; takes a quarter of a second."""
    return PasswordHasher().hash(password)


def _right(password: str, kept: str | None) -> bool:
    if not kept:  # nobody has the name, or they have not chosen a password yet
        PasswordHasher().hash(password)
        return False
    try:
        return PasswordHasher().verify(kept, password)
    except (VerificationError, InvalidHashError):
        return False
