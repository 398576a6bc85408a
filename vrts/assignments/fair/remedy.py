"""What to exclude so that no student gets a variant that falls out: `[[variants.without]]`."""

from collections.abc import Callable, Iterator, Sequence
from typing import TypeAlias

from vrts.check.variants.model import Combination, Variants, Vary

HEADER = "[[variants.without]]"

Part: TypeAlias = tuple[tuple[int, int], ...]  # what varies, and which of its choices


def cause(
    bad: Combination,
    good: Combination,
    falls_out: Callable[[Combination], bool],
    allowed: Callable[[Combination], bool],
) -> Part:
    """Return values of a variant that make it fall out, none of which could be left away.

    One value after the other is taken from a variant that is all right, as long as the rest still
    falls out.

    Args:
        bad: A variant that falls out.
        good: One that does not.
        falls_out: Tries a variant.
        allowed: Whether a student may get it.
    """
    now = bad
    for k, choice in enumerate(good):
        other = (*now[:k], choice, *now[k + 1 :])
        if other != now and allowed(other) and falls_out(other):
            now = other
    found = tuple((k, choice) for k, choice in enumerate(now) if choice != good[k])
    return found or tuple(enumerate(bad))


def narrowed(part: Part, bad: Combination, good: Sequence[Combination]) -> Part:
    """Return a part with as few more values of its variant as it takes to leave good ones alone."""
    left = [one for one in good if has(one, part)]
    while left:
        more = [(k, choice) for k, choice in enumerate(bad) if (k, choice) not in part]
        best = min(more, key=lambda value: sum(one[value[0]] == value[1] for one in left))
        part = tuple(sorted((*part, best)))
        left = [one for one in left if has(one, part)]
    return part


def fewest(parts: Sequence[Part], bad: Sequence[Combination]) -> tuple[Part, ...]:
    """Return parts without those that others make needless, the one that explains most first."""
    sets = [frozenset(enumerate(one)) for one in bad]
    counts = {part: sum(one.issuperset(part) for one in sets) for part in parts}
    ordered = sorted(counts, key=lambda part: (-counts[part], len(part), part))
    found: list[Part] = []
    for part in ordered:
        if not any(set(part).issuperset(other) for other in found):
            found.append(part)
    return tuple(found)


def has(combination: Combination, part: Part) -> bool:
    """Return whether a variant has all values of a part."""
    return all(combination[k] == choice for k, choice in part)


def as_toml(variants: Variants, parts: Sequence[Part]) -> Iterator[str]:
    """Yield exclusions as they stand in `task.toml`, single values of one thing in one table."""
    single: dict[int, list[int]] = {}
    for part in parts:
        if len(part) == 1:
            single.setdefault(part[0][0], []).append(part[0][1])
    for number, choices in single.items():
        yield f"{HEADER}\n{_line(variants.varies[number], sorted(choices))}"
    for part in parts:
        if len(part) > 1:
            lines = (_line(variants.varies[number], [choice]) for number, choice in part)
            yield "\n".join((HEADER, *lines))


def _line(vary: Vary, choices: Sequence[int]) -> str:
    texts: list[str] = []
    for choice in choices:
        values = vary.choices[choice]
        texts.append(values[0] if len(set(values)) == 1 else f"[{', '.join(values)}]")
    return f"{vary.name} = [{', '.join(texts)}]"
