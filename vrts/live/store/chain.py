"""The chain of the log: each record's hash covers the one before, and digests for what is personal.

Who did something and what it was stand in other tables, each behind a salt of its own. Deleting
them leaves the chain as it was, and the digests tell nothing without the salts.
"""

import hashlib
from typing import Final, NamedTuple

import msgspec

START: Final = bytes(32)  # what the first record of a room has before it


class Record(NamedTuple):
    """One record, as it is hashed."""

    room: str
    seq: int  # from 1, without gaps
    session: int  # number in pose frames
    at_s: float  # session time when it took effect
    wall: float  # Unix time when it was recorded [s]
    kind: str
    accepted: bool
    person: bytes  # digest of salt and account
    content: bytes  # digest of salt and text
    previous: bytes


def salted(salt: bytes, text: str) -> bytes:
    """Return the digest that stands for a text."""
    return hashlib.sha256(salt + text.encode()).digest()


def record_hash(record: Record) -> bytes:
    """Return the hash of a record."""
    plain = (*record[:7], record.person.hex(), record.content.hex(), record.previous.hex())
    return hashlib.sha256(msgspec.json.encode(plain)).digest()
