"""Wrong passwords: who waits after them, and who does not.

Every account is guessed at by itself. From one address the first few wrong passwords of an account
cost nothing; after that each next try has to wait twice as long as the one before. Another address
starts with tries of its own, so nobody elsewhere is locked out; and a browser that was logged in to
the account before is known by a cookie and has tries of its own too, wherever it is.
"""

from collections import OrderedDict
from dataclasses import dataclass
from typing import Final

FREE: Final = 5  # wrong passwords that cost nothing
FIRST_S: Final = 1.0  # to wait after the next
LONGEST_S: Final = 60.0  # to wait at most
FORGOTTEN_S: Final = 86_400.0  # without a try
SOURCES: Final = 4096  # of tries at one account that are remembered
STRANGERS: Final = 65_536  # names without an account, and where from, that are remembered


@dataclass(slots=True)
class _Tries:
    wrong: int = 0
    next: float = 0.0  # when another is looked at
    last: float = 0.0


class LogIns:
    """Counts wrong passwords; times are of a clock that only goes on [s]."""

    def __init__(self) -> None:
        """Begin without any."""
        self._of: dict[int, OrderedDict[str, _Tries]] = {}
        self._strangers: OrderedDict[str, _Tries] = OrderedDict()

    def wait_s(self, account: int | None, name: str, source: str, now: float) -> float:
        """Return how long a source has to wait before another try at an account; 0: not at all.

        Args:
            account: Whose it is; None: there is no account of that name, and nobody may see that.
            name: That was typed.
            source: The address, or the known browser.
            now: The time [s].
        """
        tries, key = self._table(account, name, source)
        found = tries.get(key)
        return 0.0 if found is None else max(0.0, found.next - now)

    def wrong(self, account: int | None, name: str, source: str, now: float) -> None:
        """Count a wrong password."""
        tries, key = self._table(account, name, source)
        found = tries.get(key)
        if found is None or now - found.last > FORGOTTEN_S:
            found = tries[key] = _Tries()
        tries.move_to_end(key)
        while len(tries) > 1 and now - next(iter(tries.values())).last > FORGOTTEN_S:
            tries.popitem(last=False)
        found.wrong += 1
        found.last = now
        if found.wrong >= FREE:
            found.next = now + min(FIRST_S * 2.0 ** min(found.wrong - FREE, 32), LONGEST_S)
        while len(tries) > (STRANGERS if account is None else SOURCES):
            tries.popitem(last=False)

    def take_back(self, account: int | None, name: str, source: str) -> None:
        """Forget the last wrong password, which nobody has looked at."""
        tries, key = self._table(account, name, source)
        found = tries.get(key)
        if found is not None:
            found.wrong = max(0, found.wrong - 1)
            found.next = 0.0

    def right(self, account: int, source: str) -> None:
        """Forget the wrong passwords of who is right."""
        tries = self._of.get(account, OrderedDict())
        tries.pop(source, None)
        if not tries:
            self._of.pop(account, None)

    def _table(
        self, account: int | None, name: str, source: str
    ) -> tuple["OrderedDict[str, _Tries]", str]:
        if account is None:
            return self._strangers, f"{name}\n{source}"
        return self._of.setdefault(account, OrderedDict()), source
