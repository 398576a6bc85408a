"""Who came in lately, from where, and whose page has not joined a room yet; all in memory.

Addresses are kept for a day and never written. Whoever has the code can come in as often as they
like: guests who never join a room are only so many, and the oldest go first, of the address that
has most. So a flood takes away places of the flood.
"""

import ipaddress
from collections import Counter, OrderedDict
from typing import Final, NamedTuple

HOUR_S: Final = 3600.0
HOURS: Final = 24  # that are remembered
UNUSED: Final = 1000  # guests who have not joined a room
ADDRESSES: Final = 4096  # of an hour; more are counted together
SHOWN: Final = 5  # addresses
ELSEWHERE: Final = "elsewhere"


class From(NamedTuple):
    """Entries from an address."""

    address: str
    hour: int  # how many in the last hour
    day: int


class Lately(NamedTuple):
    """Entries of the last hour and day, and the addresses with most of them."""

    hour: int
    day: int
    most: tuple[From, ...]


class Entries:
    """Counts entries; times are of a clock that only goes on [s]."""

    def __init__(self) -> None:
        """Begin without any."""
        self._quarters: OrderedDict[int, Counter[str]] = OrderedDict()  # of an hour
        self._unused: OrderedDict[int, str] = OrderedDict()  # account: address
        self._by_address: dict[str, OrderedDict[int, None]] = {}

    def entered(self, account: int, address: str, now: float) -> list[int]:
        """Count an entry; return the guests whose places go, who never joined."""
        where = group(address)
        quarter = int(now / (HOUR_S / 4))
        counted = self._quarters.setdefault(quarter, Counter())
        counted[where if where in counted or len(counted) < ADDRESSES else ELSEWHERE] += 1
        self._forget(quarter)
        self._add(account, where)
        return self._too_many()

    def remember(self, accounts: list[int]) -> list[int]:
        """Take the guests who had not joined when the server ended, wherever they came from."""
        for account in accounts:
            self._add(account, ELSEWHERE)
        return self._too_many()

    def joined(self, account: int) -> bool:
        """Take note that somebody is in a room; return whether that is their first time."""
        where = self._unused.pop(account, None)
        if where is None:
            return False
        self._take(where, account)
        return True

    def lately(self, now: float) -> Lately:
        """Return what a supervisor is shown."""
        quarter = int(now / (HOUR_S / 4))
        self._forget(quarter)
        day: Counter[str] = Counter()
        hour: Counter[str] = Counter()
        for at, counted in self._quarters.items():
            day.update(counted)
            if at > quarter - 4:
                hour.update(counted)
        most = sorted(day, key=lambda where: (-hour[where], -day[where], where))[:SHOWN]
        rows = tuple(From(where, hour[where], day[where]) for where in most)
        return Lately(hour.total(), day.total(), rows)

    def _add(self, account: int, where: str) -> None:
        self._unused[account] = where
        self._by_address.setdefault(where, OrderedDict())[account] = None

    def _take(self, where: str, account: int) -> None:
        of_address = self._by_address[where]
        del of_address[account]
        if not of_address:
            del self._by_address[where]

    def _too_many(self) -> list[int]:
        gone: list[int] = []
        while len(self._unused) > UNUSED:
            where = max(self._by_address, key=lambda one: len(self._by_address[one]))
            account = next(iter(self._by_address[where]))
            self._take(where, account)
            del self._unused[account]
            gone.append(account)
        return gone

    def _forget(self, quarter: int) -> None:
        while self._quarters and next(iter(self._quarters)) <= quarter - 4 * HOURS:
            self._quarters.popitem(last=False)


def group(address: str) -> str:
    """Return what counts as one address: of IPv6 the network, in which one machine has many."""
    try:
        found = ipaddress.ip_address(address)
    except ValueError:
        return address[:64]
    if found.version == 6:
        mapped = found.ipv4_mapped
        return str(mapped) if mapped else str(ipaddress.ip_network((found, 64), strict=False))
    return str(found)
