"""What shows that results were not changed on their way home: keyed digests.

A plan has a secret that stays at home. Every shard gets one of its own, made of it: with it a
machine signs the results of this shard, and of no other. So whoever only carries results, or marks
another shard, cannot change them. Whoever has the shard itself can sign what they like: that is for
`recounted`, as far as anything at home can tell.
"""

import hashlib
import hmac
import secrets
from typing import Annotated

from msgspec import Meta

from vrts.marking.result import Digest

Secret = Annotated[str, Meta(pattern=r"^[0-9a-f]{64}$")]


def new_secret() -> Secret:
    """Return the secret of a plan."""
    return secrets.token_hex(32)


def secret_of_shard(secret: Secret, plan: str, number: int) -> Secret:
    """Return the secret of one shard, from which neither the plan's nor another's can be found."""
    return _keyed(secret, f"vrts shard {plan} {number}".encode())


def signature(secret: Secret, contents: bytes) -> Digest:
    """Return what signs the table of contents of results, which has the digests of all the rest."""
    return _keyed(secret, b"vrts results\n" + contents)


def is_signed(secret: Secret, contents: bytes, found: str) -> bool:
    """Return whether a table of contents has the signature of a shard."""
    return hmac.compare_digest(signature(secret, contents).encode(), found.encode())


def _keyed(secret: Secret, data: bytes) -> str:
    return hmac.new(bytes.fromhex(secret), data, hashlib.sha256).hexdigest()
