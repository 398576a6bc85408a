"""What a browser remembers on its way to the provider and back, in a cookie that it cannot change.

Nothing of it is kept here, so no crowd of browsers that never come back fills any table. It is
signed with a key of this process: after a restart one begins to log in once more.
"""

import base64
import hashlib
import hmac
import secrets
from typing import Final

import msgspec

LASTS_S: Final = 600.0  # how long one may take at the provider
LONGEST: Final = 2048  # characters of the cookie


class Trip(msgspec.Struct, frozen=True):
    """A way to the provider and back."""

    state: str
    nonce: str
    verifier: str  # for PKCE
    begun: float  # Unix time [s]


class Memory:
    """Signs trips, and reads them again."""

    def __init__(self) -> None:
        """Take a new key."""
        self._key = secrets.token_bytes(32)

    def sealed(self, trip: Trip) -> str:
        """Return a trip as a cookie holds it."""
        data = base64.urlsafe_b64encode(msgspec.json.encode(trip))
        return f"{data.decode()}.{self._sign(data)}"

    def opened(self, cookie: str, now: float) -> Trip | None:
        """Return the trip that a cookie holds; None: it is not of here, or too long ago."""
        data, _, sign = cookie[:LONGEST].partition(".")
        if not hmac.compare_digest(self._sign(data.encode()).encode(), sign.encode()):
            return None
        trip = msgspec.json.decode(base64.urlsafe_b64decode(data), type=Trip)
        return trip if trip.begun <= now < trip.begun + LASTS_S else None

    def _sign(self, data: bytes) -> str:
        return hmac.new(self._key, data, hashlib.sha256).hexdigest()


def new_trip(now: float) -> Trip:
    """Return a trip that begins now."""
    token = secrets.token_urlsafe
    return Trip(token(32), token(32), token(48), now)
