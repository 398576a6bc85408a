"""What `vrts grade` published of a class, beside what is true of it."""

import json
from collections import Counter
from pathlib import Path
from typing import Any, NamedTuple

from tests.support_judge.classes import Class, Copy

FIRST = 12  # groups that a teacher looks at


class Judged(NamedTuple):
    """How good the list of groups of a class is."""

    name: str
    found: tuple[tuple[Copy, int], ...]  # with the number of their group, from 1
    missed: tuple[Copy, ...]  # not in the first groups
    above: tuple[tuple[str, ...], ...]  # innocent groups above the last copy that was found
    false: Counter[str]  # innocent groups by what is said of them

    def said(self) -> str:
        """Return a line for people to read."""
        count = len(self.found) + len(self.missed)
        late = "; ".join(
            f"missed {one.id} of {one.of}: {' + '.join(one.how)}" for one in self.missed
        )
        false = (
            ", ".join(f"{number} {what}" for what, number in sorted(self.false.items())) or "none"
        )
        return (
            f"{self.name:<24} {len(self.found):>2} of {count:>2} in the first {FIRST} groups,"
            f" {len(self.above)} innocent above the last; innocent groups: {false}"
            + (f"; {late}" if late else "")
        )


def groups(out: Path) -> list[tuple[frozenset[str], str]]:
    """Return the groups of a marking in their order: who is in them, and what is said of them."""
    read: dict[str, Any] = json.loads((out / "staff" / "similarity.json").read_text("utf-8"))
    return [(frozenset(map(str, one["members"])), str(one["strength"])) for one in read["groups"]]


def judged(name: str, out: Path, one: Class) -> Judged:
    """Return how the groups of a marking compare with what is true of its class."""
    listed = groups(out)
    found: list[tuple[Copy, int]] = []
    missed: list[Copy] = []
    for copy in one.copies:
        ranks = [n for n, (who, _) in enumerate(listed, 1) if copy.id in who and _has(who, copy.of)]
        if ranks and ranks[0] <= FIRST:
            found.append((copy, ranks[0]))
        else:
            missed.append(copy)
    last = max((rank for _, rank in found), default=0)
    guilty = [
        any(copy.id in who and _has(who, copy.of) for copy in one.copies) for who, _ in listed
    ]
    innocent = [
        (n, who, what)
        for n, ((who, what), is_true) in enumerate(zip(listed, guilty, strict=True), 1)
        if not is_true
    ]
    return Judged(
        name,
        tuple(found),
        tuple(missed),
        tuple(tuple(sorted(who)) for n, who, _ in innocent if n < last),
        Counter(what for _, _, what in innocent),
    )


def _has(who: frozenset[str], of: str) -> bool:
    """Return whether somebody is in a group: of the class, or of an earlier year by its folder."""
    return any(member == of or member.endswith((f"/{of}", f":{of}", f" {of}")) for member in who)
