"""Which parts of situations were looked at along which ways, so that each is looked at once."""

from collections.abc import Hashable, Sequence
from typing import TypeAlias

from vrts.prove.certify.situation import Part

NOTHING = 1e-7  # [s] what is shorter is no interval

Span: TypeAlias = tuple[float, float]


class Seen:
    """What was looked at along every way."""

    def __init__(self) -> None:
        """Nothing was."""
        self._ways: dict[Hashable, dict[int, list[Span]]] = {}  # by number of the situation
        self._parts: dict[int, frozenset[Part]] = {}

    def added(
        self, way: Hashable, situation: int, parts: tuple[Part, ...], span: Span
    ) -> list[tuple[Span, tuple[Part, ...]]]:
        """Add an interval of a way in a situation.

        Args:
            way: What moves.
            situation: Number of the situation.
            parts: What it is made of.
            span: The interval.

        Returns:
            Intervals in which some parts were not looked at before, and which.
        """
        known = self._ways.setdefault(way, {})
        own = known.get(situation, [])
        if any(low <= span[0] + NOTHING and span[1] <= high + NOTHING for low, high in own):
            return []
        new = without([span], own)
        known[situation] = _joined([*own, *new])
        others = [(self._parts[k], spans) for k, spans in known.items() if k != situation]
        if situation not in self._parts:
            self._parts[situation] = frozenset(parts)
        if not others:
            return [(one, parts) for one in new]
        found: dict[Span, list[Part]] = {}
        for part in parts:
            left = new
            for its, spans in others:
                if part in its:
                    left = without(left, spans)
            for one in left:
                found.setdefault(one, []).append(part)
        return [(one, tuple(some)) for one, some in found.items()]


def without(spans: Sequence[Span], others: Sequence[Span]) -> list[Span]:
    """Return what is left of intervals without others."""
    left = list(spans)
    for low, high in others:
        left = [
            part
            for a, b in left
            for part in ((a, min(b, low)), (max(a, high), b))
            if part[1] - part[0] > NOTHING
        ]
    return left


def _joined(spans: Sequence[Span]) -> list[Span]:
    """Return intervals in order, those that meet joined."""
    ordered = sorted(spans)
    joined = ordered[:1]
    for low, high in ordered[1:]:
        if low <= joined[-1][1] + NOTHING:
            joined[-1] = (joined[-1][0], max(joined[-1][1], high))
        else:
            joined.append((low, high))
    return joined
