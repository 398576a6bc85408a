"""Whose connection ends when all are taken and somebody else comes: of the server, or of a room.

Nobody's flood keeps others out, from wherever it comes. A connection ends of the first of these
that there is: of the address that has more than half of all; of who has more than one; of the
address that has most, if it has more than that of who comes. There it goes one of the account or
browser that has most; of those the one that has been silent for longest. Who leads, operates or
is next to operate keeps theirs.
"""

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import NamedTuple


class Connected(NamedTuple):
    """A connection."""

    place: str  # in a room
    account: int
    address: str
    heard: float  # when it last said something, of a clock that only goes on [s]
    keeps: bool  # leads, operates, or is next to operate
    browsers: frozenset[bytes] = frozenset()  # what its browser is known by


def gives_way(connections: Sequence[Connected], address: str = "") -> str | None:
    """Return the place of the connection that ends; None: nobody takes more than a share.

    Args:
        connections: All that there are.
        address: From where somebody comes.
    """
    accounts = Counter(one.account for one in connections)
    browsers = Counter(digest for one in connections for digest in one.browsers)

    def together(one: Connected) -> int:
        """Return how many the account or browser of a connection has."""
        return max(accounts[one.account], *(browsers[digest] for digest in one.browsers), 0)

    several = [one for one in connections if together(one) > 1]
    for crowd in _crowds(connections, several, address):
        those = [one for one in crowd if not one.keeps]
        if those:
            return min(those, key=lambda one: (-together(one), one.heard)).place
    return None


def _crowds(
    connections: Sequence[Connected], several: list[Connected], address: str
) -> Iterator[list[Connected]]:
    """Return those of whom one has to give way, the first first."""
    addresses = Counter(one.address for one in connections)
    most, count = max(addresses.items(), key=lambda item: item[1], default=("", 0))
    there = [one for one in connections if one.address == most]
    if 2 * count > len(connections):
        yield there
    yield several
    if count > addresses[address] + 1:  # it has as many as that of who comes, also afterwards
        yield there
