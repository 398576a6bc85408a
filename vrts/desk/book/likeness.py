"""Which programs are alike, from what marking wrote: pairs (of an earlier vrts), or groups.

It is shown beside a row, and changes no mark.
"""

from collections.abc import Mapping
from typing import Any, Final, cast

import msgspec

from vrts.desk.told import Likeness
from vrts.marking.result import Damaged

LARGEST: Final = 64_000_000  # bytes of `similarity.json`
_STRONG, _CLEAR = 0.6, 0.3  # scores of pairs


def read_likeness(data: bytes) -> Mapping[str, Likeness]:
    """Return by id what a program is like.

    Raises:
        Damaged: The bytes are nothing of the kind.
    """
    if len(data) > LARGEST:
        raise Damaged(f"likeness of {len(data):,} bytes")
    try:
        found = msgspec.json.decode(data, type=dict[str, Any])
        groups = found.get("groups")
        return _of_pairs(found["pairs"]) if groups is None else _of_groups(groups)
    except (msgspec.MsgspecError, KeyError, TypeError, ValueError, AttributeError) as problem:
        raise Damaged(f"`similarity.json` is of no version that is known: {problem}") from problem


def _of_pairs(pairs: list[dict[str, Any]]) -> dict[str, Likeness]:
    """Return the strongest likeness of each; who hang together by pairs are one group."""
    home: dict[str, str] = {}

    def root(name: str) -> str:
        while home.setdefault(name, name) != name:
            name = home[name]
        return name

    others: dict[str, dict[str, float]] = {}
    for pair in pairs:
        first, second, score = str(pair["first"]), str(pair["second"]), float(pair["score"])
        others.setdefault(first, {})[second] = score
        others.setdefault(second, {})[first] = score
        one, two = sorted((root(first), root(second)))
        home[two] = one
    return {
        name: _likeness(root(name), max(like.values()), sorted(like, key=lambda k: (-like[k], k)))
        for name, like in others.items()
    }


def _of_groups(groups: list[dict[str, Any]]) -> dict[str, Likeness]:
    """Return the strongest group that each is in, as strong as its own best link is."""
    found: dict[str, Likeness] = {}
    for number, group in enumerate(groups):
        members = [_member(one) for one in cast("list[Any]", group["members"])]
        score = float(group.get("score", group.get("strength_score", 0.0)))
        strength = group.get("strength")
        name = str(group.get("id", number + 1))
        best = _best_links(cast("list[dict[str, Any]]", group.get("links") or []))
        for member in members:
            rest = [other for other in members if other != member]
            own, word = best.get(member, (score, strength))
            one = _likeness(name, own, rest)
            if isinstance(word, str):
                one = msgspec.structs.replace(one, strength=word)
            if member not in found or found[member].score < own:
                found[member] = one
    return found


def _best_links(links: list[dict[str, Any]]) -> dict[str, tuple[float, object]]:
    """Return score and strength of the best link of each program."""
    found: dict[str, tuple[float, object]] = {}
    for link in links:
        score = float(link["score"])
        for name in (str(link["first"]), str(link["second"])):
            if name not in found or found[name][0] < score:
                found[name] = score, link.get("strength")
    return found


def _member(told: object) -> str:
    if isinstance(told, dict):
        return str(cast("dict[str, Any]", told)["id"])
    return str(told)


def _likeness(group: str, score: float, others: list[str]) -> Likeness:
    strength = "strong" if score >= _STRONG else "clear" if score >= _CLEAR else "weak"
    return Likeness(group, strength, tuple(others), round(score, 3))
