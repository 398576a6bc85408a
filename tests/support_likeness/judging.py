"""Where planted copies stand in a ranking, and what stands above them."""

import json
from pathlib import Path
from typing import Any, NamedTuple

from tests.support_likeness.classes import Planted

STRANGERS = 2  # that may stand in a group beside those who copied; with more it says nothing


class Group(NamedTuple):
    """Programs that something calls alike."""

    members: frozenset[str]
    score: float
    strength: str


class Place(NamedTuple):
    """Where a planted copy was found."""

    planted: Planted
    rank: int | None  # of the first group that shows it, counted from 1; None: none does
    above: int  # innocent groups before it
    shown: int  # of those who copied from each other, how many the group holds
    strangers: int  # others in that group
    strength: str


def groups_in(path: Path) -> list[Group]:
    """Read the groups of `similarity.json`; of schema 1, which has none, its pairs."""
    told: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    if "groups" in told:
        return [
            Group(frozenset(one["members"]), float(one["score"]), str(one.get("strength", "")))
            for one in told["groups"]
        ]
    return [
        Group(frozenset((one["first"], one["second"])), float(one["score"]), "pair")
        for one in told["pairs"]
    ]


def placed(planted: list[Planted], groups: list[Group]) -> list[Place]:
    """Return where each planted copy stands."""
    found: list[Place] = []
    shows = [any(shown(one, group) for one in planted) for group in groups]
    for one in planted:
        at = next((k for k, group in enumerate(groups) if shown(one, group)), None)
        if at is None:
            found.append(Place(one, None, shows.count(False), 0, 0, ""))
            continue
        members = groups[at].members
        ours = len(members & set(one.members))
        above = shows[:at].count(False)
        strength = groups[at].strength
        found.append(Place(one, at + 1, above, ours, len(members) - ours, strength))
    return found


def shown(one: Planted, group: Group) -> bool:
    """Return whether a group shows a planted copy: two who copied, and few others."""
    ours = len(group.members & set(one.members))
    return ours >= 2 and len(group.members) - ours <= STRANGERS


def ranks(places: list[Place]) -> list[int]:
    """Return at which place among those found each stands, extra groups of one copy not counted.

    A copy that is shown by two groups takes one place of twelve, not two.
    """
    ordered = sorted(one.rank for one in places if one.rank is not None)
    above = {one.rank: one.above for one in places if one.rank is not None}
    return [above[rank] + k for k, rank in enumerate(ordered, 1)]


def told(places: list[Place]) -> str:
    """Return a line for each planted copy."""
    lines: list[str] = []
    for one in places:
        size = len(one.planted.members)
        where = "not shown" if one.rank is None else f"group {one.rank:3}"
        rest = f"{one.above} innocent above, {one.shown} of {size}"
        rest += f", {one.strangers} strangers" * bool(one.strangers)
        rest += f", {one.strength}" * bool(one.strength)
        changes = " then ".join(one.planted.changes)
        lines.append(f"  {one.planted.kind:13} {where}, {rest}  ({changes})")
    return "\n".join(lines)
