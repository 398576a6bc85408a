"""Whose connection ends when all are taken and somebody else comes: of the server, or of a room.

Nobody's flood keeps others out, nor throws out who was there, as long as those behind one address
are no more than a share. A connection ends of the first of these that there is: of the address
that has more than half of all; of who has more than two; of an address that has more than a third
of all, and more than that of who comes, the one with most; of who has two. So a hall behind one
address is safe from guests of any number of other addresses: they find the server full.

There it goes one of the account or browser that has most, the one that has been silent for
longest; where all have a single one, the one that came last. Who leads, operates or is next to
operate keeps theirs.
"""

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

TWO: Final = 2  # a person's second page is no flood
SHARE: Final = 3  # of all connections, one in so many


class Connected(NamedTuple):
    """A connection."""

    place: str  # in a room
    account: int
    address: str
    heard: float  # when it last said something, of a clock that only goes on [s]
    keeps: bool  # leads, operates, or is next to operate
    browsers: frozenset[bytes] = frozenset()  # what its browser is known by
    since: float = 0.0  # when somebody came who has been there since then [s]


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

    def order(one: Connected) -> tuple[float, ...]:
        """Return what is least of the one that goes first."""
        count = together(one)
        return (-count, one.heard) if count > 1 else (-1, -one.since, one.heard)

    two = [one for one in connections if together(one) >= TWO]
    many = [one for one in two if together(one) > TWO]
    for crowd in _crowds(connections, many, two, address):
        those = [one for one in crowd if not one.keeps]
        if those:
            return min(those, key=order).place
    return None


def _crowds(
    connections: Sequence[Connected], many: list[Connected], two: list[Connected], address: str
) -> Iterator[list[Connected]]:
    """Return those of whom one has to give way, the first first."""
    addresses = Counter(one.address for one in connections)
    most, count = max(addresses.items(), key=lambda item: item[1], default=("", 0))
    there = [one for one in connections if one.address == most]
    if 2 * count > len(connections):
        yield there
    yield many
    # that of who comes has no more than it, also afterwards
    if SHARE * count > len(connections) and count > addresses[address] + 1:
        yield there
    yield two
