"""What somebody could tell at best who knew of every decision: the rarest that two share.

This is no detector: it reads what the generator knows. A copy that shares
less with its source than chance makes honest people share is one that nobody could find.
"""

from collections import Counter
from itertools import combinations
from math import log2
from typing import NamedTuple

from tests.support_judge.classes import Class, Copy

GONE = {  # what a disguise leaves nothing of
    "rename": ("name", "names"), "shift": ("n ", "place", "usual speed"), "split": ("plan",),
    "for to while": ("plan",), "reorder steps": ("order", "first can first", "speed first"),
    "reorder programs": ("main last",), "filler": ("says something", "break", "delay"),
}  # fmt: skip


class Known(NamedTuple):
    """A copy, what it shares with its source, and how many innocent pairs share as much."""

    copy: Copy
    bits: float
    innocent: int


def known(one: Class) -> list[Known]:
    """Return for each copy of a class how many pairs of honest people share more."""
    copies = {copy.id: copy for copy in one.copies}
    honest = [hand_in for hand_in in one.hand_ins if hand_in.id not in copies]
    seen = Counter(item for hand_in in honest for item in hand_in.decided.items())
    rarity = {item: log2(len(honest) / count) for item, count in seen.items()}
    pairs = sorted(
        (
            sum(rarity[item] for item in a.decided.items() & b.decided.items())
            for a, b in combinations(honest, 2)
        ),
        reverse=True,
    )
    out: list[Known] = []
    for hand_in in one.hand_ins:
        if (copy := copies.get(hand_in.id)) is not None:
            gone = tuple(prefix for name in copy.how for prefix in GONE[name])
            kept = [item for item in hand_in.decided.items() if not item[0].startswith(gone)]
            bits = sum(rarity.get(item, log2(len(honest))) for item in kept)
            out.append(Known(copy, bits, sum(pair >= bits for pair in pairs)))
    return sorted(out, key=lambda item: item.innocent)
