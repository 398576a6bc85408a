"""The variants of a task as data: what varies, between which values, and what never goes together.

A variant is one combination: for everything that varies the number of its choice, from 0. Values
are kept as the TOML text that is written into the files.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import prod
from typing import NamedTuple, TypeAlias

from vrts.base.source import Span
from vrts.check.variants.even import USUAL, Even

Combination: TypeAlias = tuple[int, ...]  # a choice for each `Vary`, in their order


class Vary(NamedTuple):
    """One thing that varies: a draw of it sets one or several values."""

    name: str
    paths: tuple[str, ...]  # what it sets: "scene.objects.can1.at_mm.x"
    choices: tuple[tuple[str, ...], ...]  # TOML text for each path, once for each choice
    span: Span  # of its table
    path_spans: tuple[Span, ...]  # of each path

    def shown(self, choice: int) -> str:
        """Return a choice in words: its values, or one where all paths get the same."""
        values = self.choices[choice]
        return values[0] if len(set(values)) == 1 else ", ".join(values)


class Without(NamedTuple):
    """A combination that no student gets: all of these together."""

    choices: Mapping[int, frozenset[int]]  # which choices, by the number of what varies


@dataclass(frozen=True, slots=True)
class Variants:
    """All variants of a task."""

    assignment: str  # what variants are drawn by, beside key and student
    varies: tuple[Vary, ...]
    without: tuple[Without, ...]
    staff_names: tuple[str, ...]  # locations of the scene that students have to teach
    span: Span
    even: Even = USUAL  # how much harder one may be than another
    staff_spans: tuple[Span, ...] = ()  # of each of `staff_names`
    key: bytes = field(default=b"", repr=False)  # that tags are made with; none: nobody's

    @property
    def total(self) -> int:
        """How many combinations there are, with those that no student gets."""
        return prod(len(vary.choices) for vary in self.varies)

    def combination(self, number: int) -> Combination:
        """Return a combination by its number, from 0 to `total` - 1."""
        found: list[int] = []
        for vary in reversed(self.varies):
            number, choice = divmod(number, len(vary.choices))
            found.append(choice)
        return tuple(reversed(found))

    def allowed(self, combination: Combination) -> bool:
        """Return whether a student may get a combination."""
        return not any(
            all(combination[k] in choices for k, choices in rule.choices.items())
            for rule in self.without
        )

    def values(self, combination: Combination) -> dict[str, str]:
        """Return what varies, by its name, as the table for staff shows it."""
        pairs = zip(self.varies, combination, strict=True)
        return {vary.name: vary.shown(choice) for vary, choice in pairs}
