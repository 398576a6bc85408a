"""Which intervals were looked at before, each kind by itself."""

from collections.abc import Hashable

NOTHING = 1e-7  # [s] what is shorter is no interval


class Spans:
    """Intervals by kind."""

    def __init__(self) -> None:
        """Know none."""
        self._known: dict[Hashable, list[tuple[float, float]]] = {}

    def added(self, kind: Hashable, from_s: float, to_s: float) -> list[tuple[float, float]]:
        """Add an interval; return the parts of it that were not there before."""
        known = self._known.get(kind)
        if known is None:
            self._known[kind] = [(from_s, to_s)]
            return [(from_s, to_s)]
        for low, high in known:
            if low <= from_s + NOTHING and to_s <= high + NOTHING:
                return []
        left = [(from_s, to_s)]
        for low, high in known:
            left = [
                part
                for a, b in left
                for part in ((a, min(b, low)), (max(a, high), b))
                if part[1] - part[0] > NOTHING
            ]
        known += left
        known.sort()
        joined = [known[0]]
        for low, high in known[1:]:
            if low <= joined[-1][1] + NOTHING:
                joined[-1] = (joined[-1][0], max(joined[-1][1], high))
            else:
                joined.append((low, high))
        self._known[kind] = joined
        return left
