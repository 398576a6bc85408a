"""Whose connection ends when all are taken and somebody else comes.

One who has many connections, or many accounts, takes them from themselves: it goes one of the
address that has most, if that has more than half of all; there one of the account that has most;
of those the one that has been silent for longest. Who leads, operates or waits for control keeps
theirs.
"""

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple


class Connected(NamedTuple):
    """A connection."""

    place: str  # in a room
    account: int
    address: str
    heard: float  # when it last said something, of a clock that only goes on [s]
    keeps: bool  # leads, operates, or waits for control


def gives_way(connections: Sequence[Connected]) -> str | None:
    """Return the place of the connection that ends; None: nobody takes more than a share."""
    addresses = Counter(one.address for one in connections)
    address, most = max(addresses.items(), key=lambda item: item[1], default=("", 0))
    if 2 * most <= len(connections):
        return None
    accounts = Counter(one.account for one in connections)
    there = [one for one in connections if one.address == address and not one.keeps]
    found = min(there, key=lambda one: (-accounts[one.account], one.heard), default=None)
    return None if found is None else found.place
